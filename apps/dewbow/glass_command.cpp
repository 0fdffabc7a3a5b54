// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/optics/catalogue.h"

namespace dewbow {

namespace {

using Json = nlohmann::ordered_json;

/// "1.51680", or "-" where nothing is published.
std::string published(double value, int digits) {
    return value > 0.0 ? fmt::format("{:.{}f}", value, digits) : "-";
}

Json published_json(double value) { return value > 0.0 ? Json(value) : Json(nullptr); }

/// What its maker measures a glass against.
DispersionPtr reference_of(const Glass& glass) {
    return glass.data.reference == IndexReference::air ? air() : vacuum();
}
std::string reference_name(const Glass& glass) {
    return glass.data.reference == IndexReference::air ? "air" : "vacuum";
}

struct Row {
    std::string line;  ///< of Fraunhofer, or empty
    double lambda_nm = 0.0;
    double against_reference = 0.0, against_vacuum = 0.0;
    bool in_range = true;
};

std::vector<Row> rows_of(const Glass& glass, const std::vector<double>& at_nm) {
    const DispersionPtr dispersion = make_dispersion(glass.data);
    const DispersionPtr reference = reference_of(glass);
    std::vector<Row> rows{{"F", kLineF.to(unit::nm), 0, 0, true},
                          {"d", kLined.to(unit::nm), 0, 0, true},
                          {"C", kLineC.to(unit::nm), 0, 0, true}};
    for (const double lambda_nm : at_nm) rows.push_back({"", lambda_nm, 0, 0, true});
    for (Row& row : rows) {
        const Wavelength lambda = row.lambda_nm * unit::nm;
        row.against_vacuum = (*dispersion)(lambda).value;
        row.against_reference = row.against_vacuum / (*reference)(lambda).value;
        row.in_range = row.lambda_nm >= glass.lambda_min_nm && row.lambda_nm <= glass.lambda_max_nm;
    }
    return rows;
}

Json json_of(const Glass& glass, const std::vector<Row>& rows, double abbe) {
    Json indices = Json::array();
    for (const Row& row : rows)
        indices.push_back({{"line", row.line.empty() ? Json(nullptr) : Json(row.line)},
                           {"lambda_nm", row.lambda_nm},
                           {"n", row.against_reference},
                           {"n_vacuum", row.against_vacuum},
                           {"in_range", row.in_range}});
    return {{"name", glass.name},
            {"description", glass.description},
            {"reference", reference_name(glass)},
            {"indices", indices},
            {"abbe_number", std::isfinite(abbe) ? Json(abbe) : Json(nullptr)},
            {"published_n_d", published_json(glass.n_d)},
            {"published_v_d", published_json(glass.v_d)},
            {"formula", glass.data.form},
            {"lambda_min_nm", glass.lambda_min_nm},
            {"lambda_max_nm", glass.lambda_max_nm},
            {"source", glass.source}};
}

std::string text_of(const Glass& glass, const std::vector<Row>& rows, double abbe) {
    std::string text = glass.name + "\n";
    if (!glass.description.empty()) text += "  " + glass.description + "\n";
    const bool in_air = glass.data.reference == IndexReference::air;
    text += fmt::format("\n  {:<16}{}{:<16}\n", "wavelength", in_air ? "n in air    " : "",
                        "n in vacuum");
    for (const Row& row : rows) {
        text += fmt::format("  {:<2}{:>9.4f} nm  ", row.line, row.lambda_nm);
        if (in_air) text += fmt::format("{:<12.6f}", row.against_reference);
        text += fmt::format("{:.6f}{}\n", row.against_vacuum,
                            row.in_range ? "" : "  (outside the data: continued)");
    }
    text +=
        std::isfinite(abbe) ? fmt::format("\n  Abbe number V_d {:.2f}", abbe) : "\n  no dispersion";
    text += fmt::format(" (published: n_d {}, V_d {})\n", published(glass.n_d, 5),
                        published(glass.v_d, 2));
    text += fmt::format("  formula {}, {:.0f} to {:.0f} nm\n", glass.data.form, glass.lambda_min_nm,
                        glass.lambda_max_nm);
    return text + "  source  " + glass.source + "\n";
}

/// Here the name is of the command line, and wrong names are wrong use.
Glass glass_of(const std::string& name) {
    try {
        return find_glass(name);
    } catch (const InputError& error) {
        throw UsageError(error.sentence(), error.hint());
    }
}

}  // namespace

int run_glass_list(const GlassListCommand& command) {
    if (command.json) {
        Json list = Json::array();
        for (const Glass& glass : glass_catalogue())
            list.push_back({{"name", glass.name},
                            {"n_d", published_json(glass.n_d)},
                            {"v_d", published_json(glass.v_d)},
                            {"description", glass.description}});
        print_data(list.dump() + "\n");
        return kDone;
    }
    std::size_t width = 4;
    for (const Glass& glass : glass_catalogue()) width = std::max(width, glass.name.size());
    std::string text = fmt::format("{:<{}}  n_d      V_d     description\n", "name", width);
    for (const Glass& glass : glass_catalogue())
        text += fmt::format("{:<{}}  {:<7}  {:<6}  {}\n", glass.name, width,
                            published(glass.n_d, 5), published(glass.v_d, 2), glass.description);
    print_data(text);
    return kDone;
}

int run_glass_show(const GlassShowCommand& command) {
    const Glass glass = glass_of(command.name);
    const std::vector<Row> rows = rows_of(glass, command.at_nm);
    const double abbe = abbe_number(*make_dispersion(glass.data), *reference_of(glass));
    print_data(command.json ? json_of(glass, rows, abbe).dump() + "\n"
                            : text_of(glass, rows, abbe));
    return kDone;
}

}  // namespace dewbow
