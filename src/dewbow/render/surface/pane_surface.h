// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "dewbow/render/surface/ggx_energy.h"
#include "dewbow/render/surface/ggx_lobe.h"
#include "dewbow/render/surface/surface_view.h"
#include "dewbow/scene/material.h"

namespace dewbow {

/// Reflectance of a pane, both faces and all reflections between them: r + t² r + t² r³ + … =
/// 2r / (1 + r) with Fresnel's r at one face.   @param n  index against what is around the pane.
double pane_reflectance(double cosine, double n);

/// A rough pane too thin to bend light: what its microfacets do not reflect goes on, in a lobe that
/// is the mirror image of the reflected one.                [after KHR_materials_transmission]
class PaneSurface {
public:
    PaneSurface(const ThinDielectric& material, const SurfaceView& view);
    double eval(Vec3 wi, LaneValues& f) const;
    double typical_density(Vec3 wi) const;
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    double reflectances(double cosine, LaneValues& r) const;

    int count_;
    GgxLobe lobe_;
    GgxEnergy energy_;
    double lost_;                     // of light to or from wo
    LaneValues index_;                // against what is around
    LaneValues tint_;                 // factor on what goes through
    LaneValues average_reflectance_;  // over the hemisphere
    double average_ = 0.0;            // of all lanes
};

}  // namespace dewbow
