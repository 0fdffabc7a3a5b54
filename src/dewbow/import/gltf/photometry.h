// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF's light: linear sRGB colours with photometric units.

#include "dewbow/math/vector.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow::gltf {

/// A spectrum of colour `rgb` such that for (1, 1, 1) and `size` 1 its integral against V(λ) times
/// 683 lm W⁻¹ is 1: radiance from nits, irradiance from lux, intensity from candela. nullptr if it
/// is black.
SpectrumPtr photometric_spectrum(Vec3 rgb, double size);

/// What the constant spectrum 1 W m⁻² sr⁻¹ nm⁻¹ is to be multiplied by for a luminance of 1 cd m⁻².
double one_nit();

}  // namespace dewbow::gltf
