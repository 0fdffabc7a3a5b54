// SPDX-License-Identifier: Apache-2.0
#pragma once

// Spectra as scene files write them:
//
//     0.5                                     the same at every wavelength
//     [0.8, 0.2, 0.1]                         linear sRGB: a smooth reflectance, or light of that
//     colour "D65"                                   an illuminant, as bright as the constant 1 {
//     illuminant = "A", scale = 5.0 }       { rgb = [1, 0.9, 0.8], scale = 5.0 } { blackbody_K =
//     3200, scale = 5.0 } { lambda_nm = [400, 700], values = [0.1, 0.9] }      piecewise linear,
//     held (light: 0) outside { lines_nm = [546.07, 435.83], strengths = [1, 0.7], width_nm = 1 }
//
// Light may state its photometric size instead of a scale: luminance_cd_m2, intensity_cd or
// illuminance_lx, by what the key holds.

#include "dewbow/import/toml/typed.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow::toml_import {

/// What a key's spectrum is: it decides which forms are allowed, and their range.
enum class SpectrumUse {
    share,       ///< a reflectance, a tint: 0 to 1
    absorption,  ///< m⁻¹
    scattering,  ///< m⁻¹
    index,       ///< n or k of a metal
    radiance,    ///< W m⁻² sr⁻¹ nm⁻¹
    intensity,   ///< W sr⁻¹ nm⁻¹
    irradiance,  ///< W m⁻² nm⁻¹
};

SpectrumPtr read_spectrum(const TomlDocument& document, const TomlValue& value,
                          std::string_view name, SpectrumUse use);

}  // namespace dewbow::toml_import
