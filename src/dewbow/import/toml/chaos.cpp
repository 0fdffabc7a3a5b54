// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/chaos.h"

#include <fmt/format.h>

#include <limits>

namespace dewbow::toml_import {
namespace {

constexpr Range kSizes{0.0, kHuge, true, false};
constexpr Range kLacunarities{1.1, 10.0};
constexpr Range kExponents{1.0, 4.0};
constexpr Range kStretches{1e-6, 1e6};
constexpr Range kFactors{-1e6, 1e6};
constexpr std::int64_t kMaxSeed = std::numeric_limits<std::int64_t>::max();

/// Metres or radians.
double read_size(Table& table, std::string_view key) {
    const double size = table.require_number(key, kSizes);
    return key.ends_with("_deg") ? (size * unit::deg).to(unit::rad) : size;
}

}  // namespace

std::optional<Chaos> find_chaos(Table& parent, std::string_view size) {
    const TomlValue* value = parent.find("chaos");
    if (!value) return std::nullopt;
    Table table(parent.document(), *value, fmt::format("chaos of {}", parent.title()));
    Chaos chaos;
    chaos.base_frequency = 1.0 / read_size(table, size);
    chaos.octaves = int(table.integer("octaves", 1, kMostChaosOctaves, chaos.octaves));
    chaos.lacunarity = table.number("lacunarity", kLacunarities, chaos.lacunarity);
    chaos.exponent = table.number("exponent", kExponents, chaos.exponent);
    if (const TomlValue* axis = table.find("axis"))
        chaos.axis = read_direction(table.document(), *axis, "axis");
    chaos.stretch = table.number("stretch", kStretches, chaos.stretch);
    chaos.seed = std::uint64_t(table.integer("seed", 0, kMaxSeed, std::int64_t(chaos.seed)));
    chaos.bias = table.number("bias", kFactors, chaos.bias);
    chaos.gain = table.number("gain", kFactors, chaos.gain);
    table.finish();
    return chaos;
}

}  // namespace dewbow::toml_import
