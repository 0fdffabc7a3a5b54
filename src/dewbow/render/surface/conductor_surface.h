// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dewbow/render/surface/conductor_fresnel.h"
#include "dewbow/render/surface/ggx_energy.h"
#include "dewbow/render/surface/ggx_lobe.h"
#include "dewbow/render/surface/surface_view.h"

namespace dewbow {

/// A rough metal: GGX with its exact Fresnel reflectance, and what microfacets reflect repeatedly.
class ConductorSurface {
public:
    ConductorSurface(const Conductor& material, const SurfaceView& view);
    double eval(Vec3 wi, LaneValues& f) const;
    double typical_density(Vec3 wi) const;
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    int count_;
    ConductorFresnel fresnel_;
    GgxLobe lobe_;
    GgxEnergy energy_;
    double lost_;          // of light to or from wo
    LaneValues multiple_;  // factor on what comes back after repeated reflection
    double multiple_share_ = 0.0;
};

}  // namespace dewbow
