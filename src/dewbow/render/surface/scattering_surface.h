// SPDX-License-Identifier: Apache-2.0
#pragma once

// How rough surfaces scatter: values and densities at the lanes of a path. Smooth mirrors and glass
// have none; the path tracer follows them. Rough boundaries between media bend each lane by itself:
// rough_dielectric.h.

#include <optional>
#include <variant>

#include "dewbow/render/surface/conductor_surface.h"
#include "dewbow/render/surface/lambert_surface.h"
#include "dewbow/render/surface/layered_surface.h"
#include "dewbow/render/surface/pane_surface.h"

namespace dewbow {

/// A rough surface that scatters all lanes alike: directions and their densities are the same for
/// all of them, so that a packet which scatters together stays together. Directions are local.
class ScatteringSurface {
public:
    /// Diffuse, MetallicRoughness; rough Conductor and ThinDielectric.
    static bool holds(const Material& material);
    /// Whether light goes through it, too.
    static bool transmits(const Material& material) {
        return std::holds_alternative<ThinDielectric>(material.surface);
    }

    ScatteringSurface(const Material& material, const SurfaceView& view);

    /// BSDF × |cos θ_i| of each lane into `f`; returns the density of sample() for `wi`. Of opaque
    /// surfaces 0 from below.
    double eval(Vec3 wi, LaneValues& f) const;
    /// About the density of sample() for `wi`, in a form that does not depend on the wavelengths
    /// that are looked at: > 0 wherever that density is.
    double typical_density(Vec3 wi) const;
    /// A direction, or nothing if it leads below the surface.
    std::optional<Vec3> sample(double u_lobe, std::array<double, 2> u) const;

private:
    using Kind = std::variant<LambertSurface, ConductorSurface, LayeredSurface, PaneSurface>;
    static Kind make(const Material& material, const SurfaceView& view);

    int count_;
    bool transmits_;
    Kind kind_;
};

}  // namespace dewbow
