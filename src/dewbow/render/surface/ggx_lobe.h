// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "dewbow/render/microfacet.h"

namespace dewbow {

/// alpha = roughness², but never quite smooth: a texture may hold 0.
inline double alpha_of_roughness(double roughness) {
    return std::max(kLeastAlpha, roughness * roughness);
}

/// Light that was reflected repeatedly leaves in directions alike: nearer to what the lobes of
/// ggx_energy.h give back at grazing angles than Lambert's density.
inline Vec3 sample_even_hemisphere(std::array<double, 2> u) {
    return sample_uniform_cone(1.0, u[0], u[1]).v;
}
inline constexpr double kEvenHemispherePdf = pdf_uniform_cone(1.0);

/// A random number below `share`, or one beyond it, as a number from 0 to 1 again.
inline double renewed_number(double u, double share) {
    return u < share ? u / share : (u - share) / (1.0 - share);
}

/// What GGX microfacets reflect once, without Fresnel's factor, seen from `wo`:
/// D G1(wo) G1(wi) / (4 cos θ_o), with Smith's shadowing for both ways as if independent.
///                                                                     [Walter et al. 2007, eq. 20]
class GgxLobe {
public:
    struct Value {
        double cos_m = 0.0;  ///< between either direction and the microfacet
        double f_cos = 0.0;  ///< BSDF × cos θ_i
        double pdf = 0.0;    ///< of sample(), per steradian
    };

    GgxLobe(Vec3 wo, double alpha) : wo_(wo), alpha_(alpha), g1_(ggx_g1(wo, alpha)) {}

    /// wi.z > 0.
    Value eval(Vec3 wi) const {
        const Vec3 m = normalised(wo_ + wi);
        const double pdf = g1_ * ggx_d(m, alpha_) / (4.0 * wo_.z);
        return {std::min(1.0, dot(wo_, m)), pdf * ggx_g1(wi, alpha_), pdf};
    }
    /// Nothing if it leads below the surface.
    std::optional<Vec3> sample(std::array<double, 2> u) const {
        const Vec3 m = sample_visible_normal(wo_, alpha_, u);
        const Vec3 wi = m * (2.0 * dot(wo_, m)) - wo_;
        if (wi.z <= 0.0) return std::nullopt;
        return normalised(wi);
    }

private:
    Vec3 wo_;
    double alpha_, g1_;
};

}  // namespace dewbow
