// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where the picture is taken from, and on what.

#include <string>
#include <variant>

#include "dewbow/math/transform.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

/// All lines of sight go through one point.
struct Perspective {
    /// Full angle between the upper and the lower edge of the picture.
    Angle vertical_field_of_view = 40.0 * unit::deg;
};

/// Which line of sight belongs to a point of the picture.
using Projection = std::variant<Perspective>;

/// What takes the picture, and from where.
struct CameraView {
    std::string name;
    Transform<World, Camera> world_from_camera;
    Projection projection;
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
