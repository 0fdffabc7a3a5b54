// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/placement.h"

#include <fmt/format.h>

#include <cmath>

namespace dewbow::toml_import {
namespace {

constexpr Range kScaleRange{1e-9, 1e9};
constexpr Range kAngleRange_deg{-1e6, 1e6};
/// Sine of the angle below which two directions count as parallel.
constexpr double kParallel = 1e-9;

Affine read_scale(Table& table) {
    const TomlValue* value = table.find("scale");
    if (!value) return {};
    if (!value->array()) {
        const double factor = read_number(table.document(), *value, "scale", kScaleRange);
        return scaling({factor, factor, factor});
    }
    const Vec3 factors =
        read_vec3(table.document(), *value, "scale", {-kScaleRange.high, kScaleRange.high});
    for (const double factor : {factors.x, factors.y, factors.z}) {
        if (std::abs(factor) >= kScaleRange.low) continue;
        fail(table.document(), value->place,
             fmt::format("scale has the component {}; its size must be {}", factor,
                         kScaleRange.text()));
    }
    return scaling(factors);
}

Affine read_turn(const TomlDocument& document, const TomlValue& value, std::size_t index) {
    const std::string name = fmt::format("rotate_deg[{}]", index);
    const std::vector<double> v = read_numbers(document, value, name, kAngleRange_deg, 4);
    const Vec3 axis{v[0], v[1], v[2]};
    if (length(axis) < kParallel) {
        fail(document, value.place, fmt::format("the axis of {} is zero", name));
    }
    return rotation(normalised(axis), v[3] * unit::deg);
}

Affine read_axis_turns(Table& table) {
    Affine turned;
    const auto turn = [&](std::string_view key, Vec3 axis) {
        const double angle_deg = table.number(key, kAngleRange_deg, 0.0);
        if (angle_deg != 0.0) turned = rotation(axis, angle_deg * unit::deg) * turned;
    };
    turn("rotate_x_deg", {1.0, 0.0, 0.0});
    turn("rotate_y_deg", {0.0, 1.0, 0.0});
    turn("rotate_z_deg", {0.0, 0.0, 1.0});
    return turned;
}

Affine read_rotation(Table& table) {
    for (const char* key : {"rotate_x_deg", "rotate_y_deg", "rotate_z_deg"}) {
        table.at_most_one_of({"rotate_deg", key});
    }
    const TomlValue* turns = table.find("rotate_deg");
    if (!turns) return read_axis_turns(table);
    const TomlValue::Array* array = turns->array();
    if (!array || array->empty()) {
        fail(
            table.document(), turns->place,
            fmt::format("rotate_deg is {}; expected [[axis x, y, z, angle], …]", describe(*turns)));
    }
    Affine turned;
    for (std::size_t i = 0; i < array->size(); ++i) {
        turned = read_turn(table.document(), (*array)[i], i) * turned;
    }
    return turned;
}

/// World from a frame whose −z points from `eye` to `target`.
Affine aimed(Table& table, const TomlValue& look_at, Vec3 eye, Vec3 target, Vec3 up) {
    const Vec3 ahead = target - eye;
    if (!(length(ahead) > 0.0)) {
        fail(table.document(), look_at.place,
             "look_at is the position itself: there is no direction");
    }
    if (length(cross(normalised(ahead), up)) < kParallel) {
        fail(table.document(), look_at.place, "the line of sight is parallel to up",
             "give another up, for instance up = [0, 0, 1]");
    }
    return looking_at(eye, target, up);
}

const TomlValue* find_look_at(Table& table) {
    for (const char* key : {"look_at", "look_at_m", "look_at_cm", "look_at_mm"}) {
        if (const TomlValue* value = table.find(key)) return value;
    }
    return nullptr;
}

/// Turns +z to `target`, with x level where that has a meaning.
Affine facing(Table& table, const TomlValue& look_at, Vec3 position, Vec3 target) {
    const Vec3 ahead = target - position;
    const bool steep = length(cross(ahead, {0.0, 1.0, 0.0})) <= 1e-6 * length(ahead);
    const Vec3 up = steep ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, 1.0, 0.0};
    return aimed(table, look_at, position, position - ahead, up);
}

}  // namespace

Affine read_placement(Table& table, bool with_look_at) {
    const Affine scale = read_scale(table);
    const Vec3 position = table.find_point("position").value_or(Vec3{});
    const TomlValue* look_at = with_look_at ? find_look_at(table) : nullptr;
    if (!look_at) return translation(position) * read_rotation(table) * scale;
    for (const char* key : {"rotate_deg", "rotate_x_deg", "rotate_y_deg", "rotate_z_deg"}) {
        if (const TomlValue* turn = table.find(key)) {
            fail(table.document(), turn->place,
                 fmt::format("{} has both look_at and {}; keep one", table.title(), key));
        }
    }
    return facing(table, *look_at, position, table.require_point("look_at")) * scale;
}

Affine read_viewpoint(Table& table) {
    const Vec3 eye = table.require_point("position");
    const Vec3 target = table.require_point("look_at");
    const TomlValue* up = table.find("up");
    const Vec3 direction = up ? read_direction(table.document(), *up, "up") : Vec3{0.0, 1.0, 0.0};
    return aimed(table, *find_look_at(table), eye, target, direction);
}

}  // namespace dewbow::toml_import
