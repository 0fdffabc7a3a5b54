// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/paper_rainbow.h"

#include <algorithm>
#include <array>
#include <limits>

#include "dewbow/import/toml/chaos.h"

namespace dewbow::toml_import {
namespace {

const std::array<std::string, 2> kKinds{"table", "rings"};
const std::array<std::string, 2> kEquations{"corrected", "printed"};
const std::array<std::string, 2> kIndices{"cosine", "angle"};
const std::array<std::string, 2> kMethods{"published", "corrected"};
const std::array<std::string, 3> kKernels{"none", "five-entries", "disc"};
const std::array<std::string, 1> kInfinite{"infinite"};

constexpr Range kPositive{0.0, kHuge, true, false};
constexpr Range kAngles_deg{0.0, 180.0, true, true};
constexpr Range kJitters{0.0, kPaperSamples};
/// More gains nothing: 0.3 nm each.
constexpr std::int64_t kMostWavelengths = 1300;

/// One number for all channels, or one each.
Colour<LinearSrgb> read_transmittance(Table& table) {
    const TomlValue* value = table.find("transmittance");
    if (!value) return {{1.0, 1.0, 1.0}};
    if (!std::holds_alternative<TomlValue::Array>(value->value)) {
        const double t = read_number(table.document(), *value, "transmittance", kPositive);
        return {{t, t, t}};
    }
    const auto t = read_numbers(table.document(), *value, "transmittance", kPositive, 3);
    return {{t[0], t[1], t[2]}};
}

PaperRings read_rings(Table& table) {
    PaperRings rings;
    const Angle angle = table.number("angle_deg", kAngles_deg, 42.0) * unit::deg;
    const double widest_deg = 2.0 * std::min(angle, 180.0 * unit::deg - angle).to(unit::deg);
    const Angle width =
        table.number("width_deg", {0.0, widest_deg, true, false}, std::min(2.0, widest_deg)) *
        unit::deg;
    rings.bow.outer = angle + 0.5 * width, rings.bow.inner = angle - 0.5 * width;
    table.word("index", kIndices, rings.bow.index);
    rings.bow.jitter.delta = table.number("jitter", kJitters, 0.0);
    rings.bow.jitter.colour = table.boolean("colour_jitter", false);
    rings.transmittance = read_transmittance(table);
    return rings;
}

PaperMethod read_method(Table& table) {
    enum class Which { published, corrected } which = Which::published;
    table.word("method", kMethods, which);
    PaperMethod method = which == Which::corrected ? paper_method_corrected() : PaperMethod{};
    method.wavelengths = int(table.integer("wavelengths", 1, kMostWavelengths, method.wavelengths));
    table.word("sun", kKernels, method.kernel);
    method.jitter_wavelengths = table.boolean("jitter_wavelengths", method.jitter_wavelengths);
    if (method.jitter_wavelengths && method.rays == 0)
        table.fail_here(
            "has jitter_wavelengths with method = \"corrected\", which takes the limit of ever "
            "more rays; jitter goes with method = \"published\"");
    return method;
}

Length read_depth(Table& table, Length otherwise) {
    const TomlValue* value = table.find("rain_depth_m");
    if (!value) return otherwise;
    if (!value->text())
        return read_number(table.document(), *value, "rain_depth_m", kPositive) * unit::m;
    read_choice(table.document(), *value, "rain_depth_m", kInfinite);
    return std::numeric_limits<double>::infinity() * unit::m;
}

}  // namespace

std::optional<PaperRainbow> read_paper_rainbow(const TomlDocument& document,
                                               const TomlValue* value) {
    if (!value) return std::nullopt;
    Table table(document, *value, "[paper_rainbow]");
    PaperRainbow rainbow;
    enum class Kind { by_table, by_rings } kind = Kind::by_table;
    table.word("kind", kKinds, kind);
    if (kind == Kind::by_rings)
        rainbow.bow = read_rings(table);
    else
        rainbow.bow = read_method(table);
    table.word("equation", kEquations, rainbow.equation);
    const InverseLength per_m = 1.0 / unit::m;
    rainbow.constant = table.number("fog_per_m", kPositive, rainbow.constant.to(per_m)) * per_m;
    rainbow.depth = read_depth(table, rainbow.depth);
    rainbow.luminance = table.find_number("luminance_cd_m2", kAmountRange);
    rainbow.chaos = find_chaos(table, "size_deg");
    table.finish();
    at_place(document, table.place(), [&] {
        check_paper_rainbow(rainbow);
        return true;
    });
    return rainbow;
}

}  // namespace dewbow::toml_import
