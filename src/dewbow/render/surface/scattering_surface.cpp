// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/scattering_surface.h"

namespace dewbow {

bool ScatteringSurface::holds(const Material& material) {
    if (const auto* metal = std::get_if<Conductor>(&material.surface))
        return !(metal->roughness == 0.0);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return !(pane->roughness == 0.0);
    return std::holds_alternative<Diffuse>(material.surface) ||
           std::holds_alternative<MetallicRoughness>(material.surface);
}

ScatteringSurface::ScatteringSurface(const Material& material, const SurfaceView& view)
    : count_(view.lanes.count), transmits_(transmits(material)), kind_(make(material, view)) {}

ScatteringSurface::Kind ScatteringSurface::make(const Material& material, const SurfaceView& view) {
    if (const auto* diffuse = std::get_if<Diffuse>(&material.surface))
        return LambertSurface(*diffuse, view);
    if (const auto* metal = std::get_if<Conductor>(&material.surface))
        return ConductorSurface(*metal, view);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return PaneSurface(*pane, view);
    return LayeredSurface(std::get<MetallicRoughness>(material.surface), view);
}

double ScatteringSurface::eval(Vec3 wi, LaneValues& f) const {
    if (wi.z == 0.0 || (wi.z < 0.0 && !transmits_)) {
        for (int k = 0; k < count_; ++k) f[k] = 0.0;
        return 0.0;
    }
    return std::visit([&](const auto& kind) { return kind.eval(wi, f); }, kind_);
}

double ScatteringSurface::typical_density(Vec3 wi) const {
    if (wi.z == 0.0 || (wi.z < 0.0 && !transmits_)) return 0.0;
    return std::visit([&](const auto& kind) { return kind.typical_density(wi); }, kind_);
}

std::optional<Vec3> ScatteringSurface::sample(double u_lobe, std::array<double, 2> u) const {
    return std::visit([&](const auto& kind) { return kind.sample(u_lobe, u); }, kind_);
}

}  // namespace dewbow
