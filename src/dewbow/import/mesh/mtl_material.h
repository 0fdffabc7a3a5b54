// SPDX-License-Identifier: Apache-2.0
#pragma once

// What surfaces the materials of MTL files become:
//
//     glass            where a comment names one, or illum is 4, 6, 7 or 9 and Ni > 1: a body of
//                      that index, smooth or of roughness Pr, tinted by Tf
//     mirror           illum 3 with Kd 0 and Ks: reflectance Ks
//     metallic-rough.  with any of Pr, Pm, Ps, Pc: as glTF's, of index Ni (1.5 where it is 1 or
//                      missing); else with Ks and illum not 0 or 1: the same with metalness 0,
//                      reflectance at normal incidence times Ks, and roughness from Ns
//     diffuse          else: Kd
//
// On all but glass d is coverage. Ke glows on both sides; (1, 1, 1) is as bright as the constant
// spectrum 1 W m⁻² sr⁻¹ nm⁻¹.

#include "dewbow/import/mesh/mtl.h"
#include "dewbow/import/mesh/mtl_pictures.h"
#include "dewbow/scene/material.h"

namespace dewbow {

/// Roughness (α = roughness²) of the GGX surface that looks like Phong's exponent Ns:
/// α = √(2 / (Ns + 2)).   [Walter et al. 2007, "Microfacet Models for Refraction through Rough
/// Surfaces", §5.2: α_p = 2 α_b⁻² − 2, for Beckmann's α_b]
/// @param exponent  at least 0.
double roughness_of_exponent(double exponent);

/// @param pictures  of the library that holds `material`.
/// What cannot be had (a picture that is missing, options that nothing here does) is noted. Throws
/// InputError where a glass is not known.
Material material_of(const MtlMaterial& material, MtlPictures& pictures, Diagnostics& diagnostics);

}  // namespace dewbow
