// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the picture is taken from, and on what.

#include <optional>
#include <string>
#include <variant>

#include "dewbow/math/transform.h"
#include "dewbow/optics/dispersion.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

/// All lines of sight go through one point.
struct Perspective {
    /// Full angle between the upper and the lower edge of the picture.
    Angle vertical_field_of_view = 40.0 * unit::deg;
};

/// All lines of sight are parallel to the axis.
struct Orthographic {
    /// Of what the picture shows, from its lower to its upper edge.
    Length height = 2.0 * unit::m;
};

/// Every direction, equirectangular: row 0 is straight up (the camera's +y), the middle of the
/// picture straight ahead, and longitude grows to the right. What it takes is an ImageEnvironment.
struct Panorama {};

/// Which line of sight belongs to a point of the picture.
using Projection = std::variant<Perspective, Orthographic, Panorama>;

/// The glass of a single thin lens, which has another focal length at each wavelength.
struct LensGlass {
    DispersionPtr index;
    Length focal_length;  ///< in air, at the d line
};

/// A lens in the plane z = 0 of a perspective camera: what lies at the focus distance is sharp.
/// [Cook, Porter & Carpenter 1984]
struct ThinLens {
    Length aperture_radius;          ///< of the circle, or through the corners of the polygon
    Length focus_distance;           ///< from the lens, along the axis; with a glass, at the d line
    int blades = 0;                  ///< corners of the aperture, one of them upright; 0: a circle
    std::optional<LensGlass> glass;  ///< none: all wavelengths are in focus together
};

enum class StereoLayout { side_by_side, over_under, left, right };

/// Two eyes beside each other, which look parallel to the axis through shifted windows (off-axis
/// frusta): nothing is tilted, so that no point is at different heights in the two pictures.
struct StereoPair {
    Length separation;   ///< from eye to eye, along x
    Length convergence;  ///< distance along the axis at which both see a point at the same place
    /// The eyes share the film, left eye left or above; or the film is one eye's.
    StereoLayout layout = StereoLayout::side_by_side;
};

/// What takes the picture, and from where.
struct CameraView {
    std::string name;
    Transform<World, Camera> world_from_camera;
    Projection projection;
    std::optional<ThinLens> lens;
    std::optional<StereoPair> stereo;
    /// A polariser before the lens, turned by this from the camera's +y, counterclockwise as the
    /// camera sees it: the axis of the light that it lets through.
    std::optional<Angle> polariser = {};
};

enum class FilterKind { box, gaussian, blackman_harris };

/// The pixel filter, by importance sampling: every sample counts for one pixel, with weight 1.
struct PixelFilter {
    FilterKind kind = FilterKind::blackman_harris;
    /// Half width in pixels. (Gaussian: standard deviation = radius / 3.)
    double radius = 1.5;
};

enum class ExposureMode {
    fixed,            ///< Film::exposure_stops
    automatic,        ///< chosen by the finished picture
    automatic_if_far  ///< 0, unless the picture would be much too bright or too dark
};

struct Film {
    int width = 960, height = 540;
    PixelFilter filter;
    /// Luminance in cd m⁻² that (1, 1, 1) of the written picture stands for, and that a screen
    /// shows as white at exposure 0. Default: that of the constant spectrum 1 W m⁻² sr⁻¹ nm⁻¹.
    double white_luminance = kLuminousEfficacy * 106.856917;
    ExposureMode exposure = ExposureMode::fixed;
    double exposure_stops = 0.0;
    /// Wavelength bins of the spectral layers, even over 360–830 nm; 0 = none.
    int spectral_bins = 0;
};

}  // namespace dewbow
