// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "dewbow/scene/checks.h"

namespace dewbow::checks {
namespace {

constexpr int kMostBlades = 64;
/// Below this n_d − 1 against air is rounding and no glass.
constexpr double kLeastRefraction = 1e-6;

void check_projection(const std::string& who, const Projection& projection) {
    if (const auto* orthographic = std::get_if<Orthographic>(&projection))
        check_positive(who, "height", orthographic->height.to(unit::m));
    const auto* perspective = std::get_if<Perspective>(&projection);
    if (!perspective) return;
    const double degrees = perspective->vertical_field_of_view.to(unit::deg);
    if (degrees > 0.0 && degrees < 180.0) return;
    fail(who,
         fmt::format("the vertical field of view is {} deg; it must be between 0 and 180 deg, both "
                     "excluded",
                     degrees));
}

void check_lens_glass(const std::string& who, const LensGlass& glass, Length focus_distance) {
    check_positive(who, "focal length", glass.focal_length.to(unit::m));
    if (!glass.index) fail(who, "the glass of its lens is missing");
    const double n = ((*glass.index)(kLined) / (*air())(kLined)).value;
    if (!(n - 1.0 > kLeastRefraction))
        fail(who,
             fmt::format("the glass of its lens has the index {} in air, and bends nothing", n));
    if (glass.focal_length < focus_distance) return;
    fail(who, fmt::format("the focus distance is {} m; it must be greater than the focal length, "
                          "{} m: nearer things have no image",
                          focus_distance.to(unit::m), glass.focal_length.to(unit::m)));
}

void check_lens(const std::string& who, const CameraView& camera) {
    const ThinLens& lens = *camera.lens;
    if (!std::holds_alternative<Perspective>(camera.projection))
        fail(who, "it has a lens; only a perspective camera can");
    check_positive(who, "aperture radius", lens.aperture_radius.to(unit::m));
    check_positive(who, "focus distance", lens.focus_distance.to(unit::m));
    if (lens.blades != 0) check_range(who, "the number of blades", lens.blades, 3, kMostBlades);
    if (lens.glass) check_lens_glass(who, *lens.glass, lens.focus_distance);
}

void check_stereo(const std::string& who, const CameraView& camera, const Film& film) {
    const StereoPair& stereo = *camera.stereo;
    if (!std::holds_alternative<Perspective>(camera.projection))
        fail(who, "it is a stereo pair; only a perspective camera can be one");
    check_positive(who, "separation of the eyes", stereo.separation.to(unit::m));
    check_positive(who, "convergence distance", stereo.convergence.to(unit::m));
    if (stereo.layout == StereoLayout::side_by_side && film.width % 2 != 0)
        fail(who,
             fmt::format("two eyes side by side share the width; {} pixels are odd", film.width));
    if (stereo.layout == StereoLayout::over_under && film.height % 2 != 0)
        fail(who, fmt::format("two eyes one above the other share the height; {} pixels are odd",
                              film.height));
}

}  // namespace

void check_camera(const CameraView& camera, const Film& film) {
    const std::string who = fmt::format("camera \"{}\"", camera.name);
    check_affine(who, camera.world_from_camera.affine());
    check_projection(who, camera.projection);
    if (camera.lens) check_lens(who, camera);
    if (camera.stereo) check_stereo(who, camera, film);
}

}  // namespace dewbow::checks
