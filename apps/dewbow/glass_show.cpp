// SPDX-License-Identifier: Apache-2.0

// `dewbow glass show` and `dewbow glass compare`.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/file.h"
#include "glass_facts.h"
#include "glass_plot.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

/// Lines whose indices are always shown, in the order of wavelengths.
constexpr const char* kShownLines[] = {"g", "F", "d", "C"};

std::string published(double value, int digits) {
    return value > 0.0 ? fmt::format("{:.{}f}", value, digits) : "-";
}
Json json_or_null(double value) {
    return value > 0.0 && std::isfinite(value) ? Json(value) : Json(nullptr);
}
const char* reference_name(const Glass& glass) {
    return glass.data.reference == IndexReference::air ? "air" : "vacuum";
}

struct Row {
    std::string line;  ///< of Fraunhofer, or empty
    double lambda_nm = 0.0;
};

std::vector<Row> rows_of(const std::vector<double>& at_nm) {
    std::vector<Row> rows;
    for (const char* line : kShownLines)
        rows.push_back({line, vacuum_wavelength(fraunhofer_line(line)->air_nm).to(unit::nm)});
    for (const double lambda_nm : at_nm) rows.push_back({"", lambda_nm});
    return rows;
}

// ---- one glass ----

Json extinction_json(const Glass& glass) {
    if (glass.k.empty()) return nullptr;
    Json pairs = Json::array();
    for (const Extinction& at : glass.k) pairs.push_back({at.lambda_nm, at.k});
    return pairs;
}

Json json_of(const GlassFacts& facts, const std::vector<double>& at_nm) {
    const Glass& glass = facts.glass;
    Json indices = Json::array();
    for (const Row& row : rows_of(at_nm))
        indices.push_back({{"line", row.line.empty() ? Json(nullptr) : Json(row.line)},
                           {"lambda_nm", row.lambda_nm},
                           {"n", facts.index(row.lambda_nm)},
                           {"n_vacuum", facts.index_in_vacuum(row.lambda_nm)},
                           {"in_range", facts.has_data_at(row.lambda_nm)}});
    Json json = {
        {"name", glass.name},
        {"aliases", glass.aliases},
        {"description", glass.description},
        {"reference", reference_name(glass)},
        {"n_d", facts.n_d},
        {"V_d", json_or_null(facts.V_d)},
        {"w", facts.w},
        {"P_g,F", facts.P_gF},
        {"published", {{"n_d", json_or_null(glass.n_d)}, {"V_d", json_or_null(glass.v_d)}}},
        {"accuracy", json_or_null(glass.accuracy)},
        {"formula", glass.data.form},
        {"coefficients", glass.data.coefficients},
        {"range_um", {1e-3 * glass.lambda_min_nm, 1e-3 * glass.lambda_max_nm}},
        {"birefringent", glass.birefringent},
        {"indices", indices},
        {"lambda_nm_and_k", extinction_json(glass)},
        {"notes", facts.notes()},
        {"source", glass.source},
        {"licence", glass.licence}};
    if (at_nm.size() == 1) json["n"] = facts.index(at_nm.front());
    return json;
}

std::string wavelengths_text(const GlassFacts& facts, const std::vector<double>& at_nm) {
    const bool in_air = facts.glass.data.reference == IndexReference::air;
    std::string text = fmt::format("  {:<16}{}{:<16}\n", "λ in vacuum",
                                   in_air ? "n in air    " : "", "n in vacuum");
    for (const Row& row : rows_of(at_nm)) {
        text += fmt::format("  {:<2}{:>9.4f} nm  ", row.line, row.lambda_nm);
        if (in_air) text += fmt::format("{:<12.6f}", facts.index(row.lambda_nm));
        text += fmt::format("{:.6f}{}\n", facts.index_in_vacuum(row.lambda_nm),
                            facts.has_data_at(row.lambda_nm) ? "" : "  (outside the data)");
    }
    return text;
}

std::string absorption_text(const Glass& glass) {
    const SpectrumPtr absorption = absorption_of(glass);
    if (!absorption) return "";
    std::string text = "  absorbs";
    for (const double l : {400.0, 500.0, 600.0, 700.0})
        text +=
            fmt::format("{} {:.3g} at {} nm", l > 400.0 ? "," : "", (*absorption)(l * unit::nm), l);
    return text + " (1/m)\n";
}

std::string text_of(const GlassFacts& facts, const std::vector<double>& at_nm) {
    const Glass& glass = facts.glass;
    std::string text = glass.name;
    if (!glass.aliases.empty()) text += fmt::format(" (also {})", joined(glass.aliases));
    text += "\n";
    if (!glass.description.empty()) text += fmt::format("  {}\n", glass.description);
    text += fmt::format("\n{}\n", wavelengths_text(facts, at_nm));
    if (std::isfinite(facts.V_d))
        text += fmt::format("  n_d {:.5f}, V_d {:.2f}, w {:.5f}, P_g,F {:.4f}", facts.n_d,
                            facts.V_d, facts.w, facts.P_gF);
    else
        text += fmt::format("  n_d {:.5f}, no dispersion", facts.n_d);
    text += fmt::format(" (published: n_d {}, V_d {})\n", published(glass.n_d, 5),
                        published(glass.v_d, 2));
    text += fmt::format("  formula {}, {:.4g} to {:.6g} nm", glass.data.form, glass.lambda_min_nm,
                        glass.lambda_max_nm);
    if (glass.accuracy > 0.0) text += fmt::format(", good to {:.1g}", glass.accuracy);
    text += fmt::format("\n{}", absorption_text(glass));
    for (const std::string& note : facts.notes()) text += fmt::format("  note    {}\n", note);
    return text + fmt::format("  source  {}\n", glass.source);
}

// ---- several ----

std::string comparison(const std::vector<GlassFacts>& glasses, const std::vector<double>& at_nm) {
    std::size_t width = 4;
    for (const GlassFacts& facts : glasses) width = std::max(width, facts.glass.name.size());
    std::string text =
        fmt::format("{:<{}}  {:<8} {:<7} {:<8} {:<7}", "name", width, "n_d", "V_d", "w", "P_g,F");
    for (const double l : at_nm) text += fmt::format(" n({:g} nm)", l);
    text += "\n";
    for (const GlassFacts& facts : glasses) {
        text += fmt::format(
            "{:<{}}  {:<8.5f} {:<7} {:<8.5f} {:<7.4f}", facts.glass.name, width, facts.n_d,
            std::isfinite(facts.V_d) ? fmt::format("{:.2f}", facts.V_d) : "-", facts.w, facts.P_gF);
        for (const double l : at_nm) {
            const std::size_t column = fmt::format(" n({:g} nm)", l).size();
            text += fmt::format(" {:<{}.6f}", facts.index(l), column - 1);
        }
        text += "\n";
    }
    for (const GlassFacts& facts : glasses)
        for (const std::string& note : facts.notes()) text += fmt::format("note: {}\n", note);
    return text;
}

}  // namespace

int run(const GlassShowCommand& command) {
    std::vector<GlassFacts> glasses;
    for (const std::string& name : command.names) glasses.emplace_back(glass_named(name));
    if (!command.plot.empty()) write_file_atomically(command.plot, glass_plot(glasses));
    Json list = Json::array();
    for (const GlassFacts& facts : glasses) list.push_back(json_of(facts, command.at_nm));
    if (command.json)
        // Texts of files may hold bytes that are no UTF-8.
        print_data((glasses.size() == 1 ? list.front() : list)
                       .dump(-1, ' ', false, Json::error_handler_t::replace) +
                   "\n");
    else
        print_data(glasses.size() == 1 ? text_of(glasses.front(), command.at_nm)
                                       : comparison(glasses, command.at_nm));
    return kDone;
}

}  // namespace dewbow
