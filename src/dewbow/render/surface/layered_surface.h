// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dewbow/render/surface/clearcoat_layer.h"
#include "dewbow/render/surface/ggx_energy.h"
#include "dewbow/render/surface/ggx_lobe.h"
#include "dewbow/render/surface/sheen_layer.h"
#include "dewbow/render/surface/surface_view.h"
#include "dewbow/scene/material.h"

namespace dewbow {

/// glTF's metallic-roughness surface with its layers: clearcoat over sheen over a base, which is a
/// mixture of a metal and of a dielectric over Lambert.
///
/// Both reflect by the same GGX microfacets, with Schlick's reflectance, repeatedly too
/// (ggx_energy.h). Lambert's part gets what the dielectric leaves, on both ways:
///     base / π (1 − C(o)) (1 − C(i)) / (1 − C_avg)
/// with C the albedo of what the dielectric reflects. So white stays white, and all is reciprocal.
///                                                                        [Kulla & Conty 2017]
class LayeredSurface {
public:
    LayeredSurface(const MetallicRoughness& material, const SurfaceView& view);
    double eval(Vec3 wi, LaneValues& f) const;
    double typical_density(Vec3 wi) const;
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    /// Probabilities of sampling Lambert's lobe, the microfacets, the varnish, and all directions
    /// alike (for repeated reflections and sheen).
    struct Shares {
        double body = 0.0, specular = 0.0, clearcoat = 0.0, even = 0.0;
    };

    void make_base(const MetallicRoughness& material, const SurfaceView& view);
    void make_layers(const MetallicRoughness& material, const SurfaceView& view);
    void make_shares();
    double dielectric_albedo(const GgxAlbedo& albedo, int k) const {
        return albedo.schlick(dielectric_f0_[k], dielectric_f90_) +
               dielectric_multiple_[k] * albedo.lost;
    }

    int count_;
    GgxLobe lobe_;
    GgxEnergy energy_;
    GgxAlbedo albedo_o_;
    // Of the dielectric part.
    LaneValues dielectric_f0_, dielectric_multiple_;
    double dielectric_f90_ = 1.0;
    LaneValues body_;  // Lambert's: all of its factors but (1 − C(i)) cos θ_i
    // Of metal and dielectric together.
    LaneValues f0_, multiple_;
    double f90_ = 1.0;
    bool has_body_ = true;

    std::optional<ClearcoatLayer> clearcoat_;
    std::optional<SheenLayer> sheen_;
    LaneValues sheen_colour_;
    Shares shares_;
};

}  // namespace dewbow
