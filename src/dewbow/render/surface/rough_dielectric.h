// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "dewbow/math/vector.h"
#include "dewbow/render/surface/dielectric_energy.h"

namespace dewbow {

/// A rough boundary between two dielectrics, for one lane: GGX, and what its microfacets send on
/// repeatedly (dielectric_energy.h). Directions are local.              [Walter et al. 2007, eq.
/// 20, 21]
class RoughDielectric {
public:
    /// @param wo  wo.z > 0.   @param n  n_t / n_i: of the far side against the side of wo.
    RoughDielectric(Vec3 wo, double alpha, double n);

    struct Value {
        double f_cos = 0.0;  ///< BSDF × |cos θ_i|; radiance divided by the square of the index
        double pdf = 0.0;    ///< of sample()
    };
    Value eval(Vec3 wi) const;
    /// Nothing if it leads to the wrong side of the surface.
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    Value eval_once(Vec3 wi) const;
    std::optional<Vec3> sample_once(double u_lobe, std::array<double, 2> u) const;

    Vec3 wo_;
    double alpha_, n_;
    DielectricEnergy energy_;
    double lost_;  // of light from or to wo
};

}  // namespace dewbow
