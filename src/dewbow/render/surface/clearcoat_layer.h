// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dewbow/render/surface/ggx_energy.h"
#include "dewbow/render/surface/ggx_lobe.h"

namespace dewbow {

/// A varnish of index 1.5, of which `strength` in [0, 1] is there. What is below gets what the
/// varnish leaves; what is reflected from below at the varnish's inner side is not followed.
///                                                                    [KHR_materials_clearcoat]
class ClearcoatLayer {
public:
    ClearcoatLayer(Vec3 wo, double strength, double roughness);

    struct Value {
        double f_cos = 0.0;   ///< BSDF × cos θ_i of the varnish
        double leaves = 1.0;  ///< factor on what is below, the same for both ways
        double pdf = 0.0;     ///< of sample()
    };
    Value eval(Vec3 wi) const;
    std::optional<Vec3> sample(std::array<double, 2> u) const { return lobe_.sample(u); }

    /// Parts of the light to or from wo that it reflects once, and repeatedly.
    double once() const { return once_; }
    double repeatedly() const { return repeatedly_; }

private:
    double albedo(const GgxAlbedo& albedo) const;

    double strength_;
    GgxLobe lobe_;
    GgxEnergy energy_;
    double multiple_;  // factor on what comes back after repeated reflection
    GgxAlbedo albedo_o_;
    double once_, repeatedly_;
};

}  // namespace dewbow
