// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "glass_facts.h"

namespace dewbow {
namespace {

using Json = nlohmann::ordered_json;

/// One unit's number, and how good a picture of the true glass it alone gives.
struct Line {
    const DispersionUnit* unit;
    double value = 0.0;
    double residual = 0.0;  ///< largest |Δn| from 400 to 700 nm; 0 where there is no true glass
};

/// What a program makes of n_d and the number.
IndexInAir model_of(const DispersionUnit& unit, double n_d, double value) {
    if (unit.name != "pov_ray") return two_terms(n_d, unit.b_um2(n_d, value));
    return index_in_air(make_dispersion({"pov_ray", {n_d, value}, IndexReference::air}));
}

std::vector<Line> lines_of(const IndexInAir& n, double n_d, bool is_glass) {
    std::vector<Line> lines;
    for (const DispersionUnit& unit : dispersion_units()) {
        const double value = unit.measure(n);
        const double residual = is_glass ? worst_difference(model_of(unit, n_d, value), n) : 0.0;
        lines.push_back({&unit, value, residual});
    }
    return lines;
}

const DispersionUnit& unit_named(const std::string& name) {
    for (const DispersionUnit& unit : dispersion_units())
        if (unit.name == name) return unit;
    throw UsageError("no unit " + name);  // the command line knows them all
}

/// The two terms that the command's number stands for.
IndexInAir index_of(const GlassConvertCommand& command) {
    const DispersionUnit& unit = unit_named(command.unit);
    const double b = unit.b_um2(command.n_d, command.value);
    if (!std::isfinite(b) || b <= 0.0)
        throw UsageError(fmt::format("--{} {} is no dispersion of a glass of n_d {}", unit.name,
                                     command.value, command.n_d),
                         unit.meaning);
    return two_terms(command.n_d, b);
}

void print(const std::string& title, double n_d, const std::vector<Line>& lines,
           const GlassConvertCommand& command) {
    const bool is_glass = !command.name.empty();
    if (command.json) {
        Json json = {{"name", is_glass ? Json(title) : Json(nullptr)}, {"n_d", n_d}};
        for (const Line& line : lines) json[line.unit->name] = line.value;
        if (is_glass)
            for (const Line& line : lines) json["residual"][line.unit->name] = line.residual;
        print_data(json.dump() + "\n");
        return;
    }
    std::string text = fmt::format("{}\n\n{:<9} {:<12}{}what it is\n", title, "unit", "value",
                                   is_glass ? "worst Δn  " : "");
    for (const Line& line : lines) {
        text += fmt::format("{:<9} {:<12.6g}", line.unit->name, line.value);
        if (is_glass) text += fmt::format("{:<10.1e}", line.residual);
        text += line.unit->meaning + "\n";
    }
    if (is_glass)
        text +=
            "\nworst Δn: of the index that n_d and the number alone give (A + B/λ², or POV-Ray's "
            "formula) from the true one, 400 to 700 nm\n";
    print_data(text);
}

}  // namespace

int run(const GlassConvertCommand& command) {
    if (command.name.empty()) {
        const auto lines = lines_of(index_of(command), command.n_d, false);
        print(fmt::format("n_d {}, {} {}", command.n_d, command.unit, command.value), command.n_d,
              lines, command);
        return kDone;
    }
    const GlassFacts facts(glass_named(command.name));
    if (facts.dispersion->is_constant())
        throw UsageError(facts.glass.name + " has no dispersion to convert");
    const double n_d = facts.in_air(kAird_nm);
    print(fmt::format("{}, n_d {:.5f}", facts.glass.name, n_d), n_d,
          lines_of(facts.in_air, n_d, true), command);
    return kDone;
}

}  // namespace dewbow
