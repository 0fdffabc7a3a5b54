// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/camera.h"

#include <fmt/format.h>

#include <array>

#include "dewbow/import/toml/glass.h"
#include "dewbow/import/toml/placement.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kFieldOfViewRange_deg{0.0, 180.0, true, true};
/// From beyond the fastest lens that was ever made to a pinhole.
constexpr Range kFNumberRange{0.1, 1e6};
constexpr Range kPolariserRange_deg{-360.0, 360.0};
constexpr std::int64_t kFewestBlades = 3, kMostBlades = 64;

const std::array<std::string, 3> kProjections = {"perspective", "orthographic", "panorama"};
const std::array<std::string, 4> kLayouts = {"side-by-side", "over-under", "left", "right"};
constexpr std::array kLayoutKinds = {StereoLayout::side_by_side, StereoLayout::over_under,
                                     StereoLayout::left, StereoLayout::right};

Projection read_projection(Table& table) {
    const TomlValue* kind = table.find("projection");
    const std::size_t which =
        kind ? read_choice(table.document(), *kind, "projection", kProjections) : 0;
    if (which == 1) return Orthographic{table.require_length("height")};
    if (which == 2) return Panorama{};
    return Perspective{table.number("vertical_fov_deg", kFieldOfViewRange_deg, 40.0) * unit::deg};
}

/// `f_number` is the focal length over the aperture's diameter.
Length read_aperture(Table& table, std::optional<Length> focal_length) {
    const std::optional<Length> radius = table.find_length("aperture_radius");
    const std::optional<double> f_number = table.find_number("f_number", kFNumberRange);
    if (radius && f_number) table.fail_here("has both aperture_radius and f_number; keep one");
    if (radius) return *radius;
    if (!f_number) table.fail_here("needs aperture_radius_mm, or f_number and focal_length_mm");
    if (!focal_length) table.fail_here("has f_number and needs focal_length_mm with it");
    return *focal_length / (2.0 * *f_number);
}

/// From the camera's plane along its axis.
Length read_focus(Table& table, const Affine& world_from_camera) {
    const std::optional<Vec3> point = table.find_point("focus_on");
    const std::optional<Length> distance = table.find_length("focus_distance");
    if (point && distance) table.fail_here("has both focus_on and focus_distance; keep one");
    if (distance) return *distance;
    if (!point) table.fail_here("needs focus_distance_m or focus_on = [x, y, z]");
    const Vec3 ahead = world_from_camera.apply_linear({0.0, 0.0, -1.0});
    const double depth = dot(*point - world_from_camera.apply({}), ahead);
    if (!(depth > 0.0))
        table.fail_here("focuses on a point that does not lie in front of the camera");
    return depth * unit::m;
}

std::optional<LensGlass> read_lens_glass(Table& table, std::optional<Length> focal_length) {
    if (!table.find("glass") && !table.find("dispersion") && !table.find("ior")) return {};
    if (!focal_length) table.fail_here("is of glass and needs focal_length_mm");
    return LensGlass{read_index(table, nullptr), *focal_length};
}

ThinLens read_lens(Table& table, const Affine& world_from_camera) {
    const std::optional<Length> focal_length = table.find_length("focal_length");
    ThinLens lens;
    lens.aperture_radius = read_aperture(table, focal_length);
    lens.focus_distance = read_focus(table, world_from_camera);
    lens.blades = table.find("blades")
                      ? int(table.integer("blades", kFewestBlades, kMostBlades, kFewestBlades))
                      : 0;
    lens.glass = read_lens_glass(table, focal_length);
    if (focal_length && !(*focal_length < lens.focus_distance)) {
        table.fail_here(fmt::format(
            "focuses on {} m, which is not beyond its focal length, {} m: it has no image there",
            lens.focus_distance.to(unit::m), focal_length->to(unit::m)));
    }
    table.finish();
    return lens;
}

StereoPair read_stereo(Table& table) {
    StereoPair stereo;
    stereo.separation = table.require_length("separation");
    stereo.convergence = table.require_length("convergence");
    if (const TomlValue* layout = table.find("layout"))
        stereo.layout = kLayoutKinds[read_choice(table.document(), *layout, "layout", kLayouts)];
    table.finish();
    return stereo;
}

/// The table `key` of a camera that must be a perspective to have one.
std::optional<Table> find_part(Table& camera, const Projection& projection, const char* key) {
    const TomlValue* value = camera.find(key);
    if (!value) return std::nullopt;
    if (!std::holds_alternative<Perspective>(projection))
        fail(
            camera.document(), value->place,
            fmt::format(
                "{} is {}; only a perspective camera has a {}", camera.title(),
                std::holds_alternative<Panorama>(projection) ? "a panorama" : "orthographic", key));
    return Table(camera.document(), *value, fmt::format("{} of {}", key, camera.title()));
}

}  // namespace

CameraView read_camera(Table& table, const std::string& name) {
    CameraView camera;
    camera.name = name;
    const Affine world_from_camera = read_viewpoint(table);
    camera.world_from_camera = Transform<World, Camera>(world_from_camera);
    camera.projection = read_projection(table);
    if (auto lens = find_part(table, camera.projection, "lens"))
        camera.lens = read_lens(*lens, world_from_camera);
    if (auto stereo = find_part(table, camera.projection, "stereo"))
        camera.stereo = read_stereo(*stereo);
    if (const auto degrees = table.find_number("polariser_deg", kPolariserRange_deg))
        camera.polariser = *degrees * unit::deg;
    return camera;
}

}  // namespace dewbow::toml_import
