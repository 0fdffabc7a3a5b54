// SPDX-License-Identifier: Apache-2.0
#pragma once

// [film], [render]: how the picture is taken. ([camera]: camera.h.)

#include "dewbow/import/toml/table.h"
#include "dewbow/scene/scene.h"

namespace dewbow::toml_import {

/// width = 960, height = 540, filter = "blackman-harris", filter_radius_px = 1.5 (box: 0.5),
/// exposure_stops = 0, white_luminance_cd_m2, spectral_bins = 0.
void read_film(const TomlDocument& document, const TomlValue* value, Film& film);

/// samples_per_pixel, seed, packet, wavelengths = "visual", max_depth, roulette_depth.
void read_render(const TomlDocument& document, const TomlValue* value, RenderSettings& settings);

}  // namespace dewbow::toml_import
