// SPDX-License-Identifier: Apache-2.0
#pragma once

// What pictures of a film need beside the film, as a text that travels with a render's state: so
// that states become pictures without their scene.

#include <string>
#include <string_view>

#include "dewbow/scene/camera.h"
#include "dewbow/spectrum/display.h"

namespace dewbow {

struct PictureSettings {
    std::string scene_file;
    int packet = 8;                ///< wavelengths that one path carries
    double white_luminance = 1.0;  ///< cd m⁻², above 0
    ExposureMode exposure = ExposureMode::fixed;
    double exposure_stops = 0.0;
    GamutMapping gamut = DisplaySettings{}.gamut;
    bool operator==(const PictureSettings&) const = default;
};

/// A line for each: its name, a space, its value. Numbers come back as they were.
std::string text_of(const PictureSettings& settings);

/// Throws InputError if `text` is none that text_of wrote.
PictureSettings picture_settings_from_text(std::string_view text);

}  // namespace dewbow
