// SPDX-License-Identifier: Apache-2.0
#pragma once

// How light paths and camera paths share what both can find.
//
// D is what scatters (ScatteringSurface), S a smooth caster, R rough glass, L a lamp, E the camera.
//
//     shape                                      who finds it
//     L D … E                                    camera paths: next event, and by chance
//     L S⁺ D E,  L S⁺ D (D|S|R)* D E             both, and so with R among the S
//     L S⁺ D S⁺ E,  L … D S E,  L S⁺ E           camera paths
//
// So a light path can find what a camera path does if (a) the first surface y1 that the camera
// meets is a D, and nothing that stops shadow rays stands before it, and (b) the lamp's ray first
// meets what stops shadow rays and is not a D.
//
// For such a path the power heuristic compares three densities of the whole path, each over that
// of a camera path that runs into the lamp:
//     1                                by chance
//     q = p_next_event / p_surface     next event, where the surface next to the lamp is R; else 0
//     R = n ρ |cos θ_l| / (J |cos θ_c| p1)      light paths
//   n       light paths for each sample of a pixel
//   ρ       density of the lamp's ray, m⁻² sr⁻¹: of area across it and solid angle, which smooth
//           surfaces conserve together
//   J       pixels per m² across the line of sight at y1
//   θ_l θ_c angles at y1 to the true normal, of the way on to the light and to the camera
//   p1      density with which the camera's path goes on from y1, sr⁻¹
// Behind y1 both kinds of path choose directions in proportion to what the surface sends that way,
// so that these choices cancel. Where they do not quite, R is no longer that ratio, but still a
// function of the path alone: the weights sum to one, and the mean stays right. That is why p1 may
// be a density that leaves the wavelength out (ScatteringSurface::typical_density).
//                                                       [Veach 1997, chapter 9 and 10.3]
//
// Lamps without extent are never met by chance: behind S light paths alone find them, behind R next
// event and light paths.

#include "dewbow/render/caustics/aimed_emission.h"

namespace dewbow::caustics {

/// The light paths of a render. There is at least one lamp that shines on a caster.
struct LightPaths {
    const AimedEmission& emission;
    double per_sample;  ///< n
};

/// R / ρ, m² sr.
inline double light_ratio(const LightPaths& paths, double cos_light, double cos_camera,
                          double pixels_per_m2, double density) {
    return paths.per_sample * cos_light / (pixels_per_m2 * cos_camera * density);
}

/// Weight of the technique of density `a` beside two others.
inline double power_heuristic(double a, double b, double c = 0.0) {
    return a * a / (a * a + b * b + c * c);
}

/// What the choice of a light without extent is compared as with R: what the densities of the
/// choice and of the lamp's ray become for a small lamp is the same factor for both.
/// @param distance  to the light, m.
inline double choice_by_extent(LightSample::Source source, double choice, double distance) {
    return source == LightSample::Source::punctual ? choice * distance * distance : choice;
}

/// That of a light path, for any ratio R.
/// @param others  sum of the squares of the others' densities: 1 + q², or q² without extent.
inline double weight_of_light(double ratio, double others) {
    return 1.0 / (1.0 + others / (ratio * ratio));
}

}  // namespace dewbow::caustics
