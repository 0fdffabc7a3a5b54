// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/file.h"
#include "dewbow/import/glass/glass_file.h"
#include "glass_facts.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

std::string rows_of(const std::vector<Glass>& glasses) {
    std::string text(glass_csv_header());
    for (const Glass& glass : glasses) text.append("\n").append(csv_line_of(glass));
    return text + "\n";
}

/// What a scene file says to have the glass.
std::string scene_snippet(const Glass& glass) {
    const DispersionData& data = glass.data;
    std::vector<std::string> coefficients;
    for (const double c : data.coefficients) coefficients.push_back(fmt::format("{}", c));
    std::string text = fmt::format(
        "dispersion = {{ form = \"{}\", coefficients = [{}], reference = "
        "\"{}\"",
        data.form, joined(coefficients), data.reference == IndexReference::air ? "air" : "vacuum");
    if (data.range)
        text +=
            fmt::format(", range_nm = [{:.7g}, {:.7g}]", data.range->min_nm, data.range->max_nm);
    return text + " }";
}

std::string v_text(double v) { return std::isfinite(v) ? fmt::format("{:.2f}", v) : "-"; }

std::string text_of(const GlassFile& file) {
    std::size_t width = 4;
    for (const Glass& glass : file.glasses) width = std::max(width, glass.name.size());
    std::string text =
        fmt::format("{:<{}}  n_d       V_d     formula  range (nm)\n", "name", width);
    for (const Glass& glass : file.glasses) {
        const GlassFacts facts(glass);
        text += fmt::format("{:<{}}  {:.6f}  {:<6}  {:<7}  ", glass.name, width, facts.n_d,
                            v_text(facts.V_d), glass.data.form);
        text += glass.data.range
                    ? fmt::format("{:.6g} to {:.6g}\n", glass.lambda_min_nm, glass.lambda_max_nm)
                    : std::string("not stated\n");
    }
    return text;
}

Json json_of(const GlassFile& file) {
    Json glasses = Json::array(), notes = Json::array();
    for (const Glass& glass : file.glasses) {
        const GlassFacts facts(glass);
        glasses.push_back({{"name", glass.name},
                           {"n_d", facts.n_d},
                           {"V_d", std::isfinite(facts.V_d) ? Json(facts.V_d) : Json(nullptr)},
                           {"formula", glass.data.form},
                           {"coefficients", glass.data.coefficients},
                           {"range_um", {1e-3 * glass.lambda_min_nm, 1e-3 * glass.lambda_max_nm}},
                           {"has_extinction", !glass.k.empty()}});
    }
    for (const Diagnostic& note : file.notes)
        notes.push_back({{"line", note.place.line}, {"text", note.text}});
    return {{"glasses", glasses}, {"notes", notes}};
}

}  // namespace

int run(const GlassImportCommand& command) {
    GlassFile file = load_glass_file(command.file);
    for (const Diagnostic& note : file.notes)
        if (!command.json) print_message(to_string(note.place) + ": " + note.text);
    if (!command.name.empty()) {
        const Glass glass = load_glass(command.file, command.name);
        file.glasses = {glass};
    }
    if (!command.rows.empty()) write_file_atomically(command.rows, rows_of(file.glasses));
    if (command.json)
        print_data(json_of(file).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
    else if (!command.name.empty())
        print_data(scene_snippet(file.glasses.front()) + "\n");
    else
        print_data(text_of(file));
    return kDone;
}

}  // namespace dewbow
