// SPDX-License-Identifier: Apache-2.0
#pragma once

// How rough surfaces scatter: values and densities at the lanes of a path. Smooth mirrors and glass
// have no values; the path tracer follows them.

#include <optional>

#include "dewbow/render/lanes.h"
#include "dewbow/render/microfacet.h"
#include "dewbow/render/surface_inputs.h"
#include "dewbow/scene/material.h"

namespace dewbow {

/// Orthonormal frame at a surface point.
struct LocalFrame {
    Vec3 t, b, n;
    explicit LocalFrame(Vec3 normal) : n(normal) {
        const Tangents tangents = tangents_of(normal);
        t = tangents.t, b = tangents.b;
    }
    Vec3 to_local(Vec3 v) const { return {dot(v, t), dot(v, b), dot(v, n)}; }
    Vec3 to_world(Vec3 v) const { return t * v.x + b * v.y + n * v.z; }
};

/// An opaque surface: Diffuse or MetallicRoughness. All directions are local and point away from
/// the surface; z > 0 is the side that is looked at. Densities are the same for all lanes, so that
/// a packet which scatters together stays together.
class OpaqueSurface {
public:
    static bool holds(const Material& material);
    OpaqueSurface(const Material& material, const SurfaceInputs& inputs, const LaneSet& lanes,
                  Vec3 wo);

    /// BSDF × cos θ_i of each lane into `f`; returns the density of sample() for `wi`.
    double eval(Vec3 wi, LaneValues& f) const;
    /// A direction, or nothing if it leads below the surface.
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    int count_;
    Vec3 wo_;
    LaneValues base_;
    double metalness_ = 0.0, alpha_ = 0.0, f0_ = 0.0;
    double specular_share_ = 0.0;  ///< probability of sampling the specular lobe
};

/// A rough boundary between two dielectrics, for one lane with n = n_t / n_i.
struct RoughDielectricValue {
    double f_cos = 0.0;  ///< BSDF × |cos θ_i|; radiance divided by the square of the index
    double pdf = 0.0;
};
RoughDielectricValue eval_rough_dielectric(Vec3 wo, Vec3 wi, double alpha, double n);

}  // namespace dewbow
