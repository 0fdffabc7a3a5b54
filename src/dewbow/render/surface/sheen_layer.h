// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "dewbow/math/vector.h"

namespace dewbow {

/// Fibres on a surface: microfacets that stand upright.
///     f = D G / (4 cos θ_o cos θ_i),  D = (2 + 1/r) sin(θ_m)^(1/r) / (2 π),
///     G = 1 / (1 + Λ(o) + Λ(i)),  r = roughness²,
/// with the fit of Λ to the shadowing of that D, without the paper's softening of the terminator,
/// which is not reciprocal. Where a smooth sheen (roughness below 0.5) is grazed, its albedo E
/// comes out above 1; there it is divided by the larger E of both ways. What is below gets what the
/// fibres leave.
///           [Estevez & Kulla, "Production Friendly Microfacet Sheen BRDF", SIGGRAPH 2017 course]
class SheenLayer {
public:
    SheenLayer(Vec3 wo, double roughness);

    /// BSDF × cos θ_i of white fibres.   @param albedo_i  albedo(wi.z).
    double eval(Vec3 wi, double albedo_i) const;
    /// E, the part of the light to or from a direction that white fibres reflect, before that
    /// division, from a table that is computed when it is first asked for. Error:
    /// kSheenAlbedoError.
    double albedo(double cosine) const;
    double albedo_o() const { return albedo_o_; }
    /// Factor on what is below, the same for both ways and never more than they reflect:
    /// the least of both directions.                                        [KHR_materials_sheen]
    double leaves(double colour, double albedo_i) const {
        return std::max(0.0, 1.0 - colour * std::max(albedo_o_, albedo_i));
    }

private:
    Vec3 wo_;
    double r_;
    double lambda_o_, albedo_o_;
};

inline constexpr double kSheenAlbedoError = 5e-3;
/// Below this r the lobe is a line at grazing angles that nothing samples well; glTF leaves the
/// limit to renderers.
inline constexpr double kLeastSheenR = 5e-3;

}  // namespace dewbow
