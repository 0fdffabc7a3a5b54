// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/conductor_surface.h"

namespace dewbow {

ConductorSurface::ConductorSurface(const Conductor& material, const SurfaceView& view)
    : count_(view.lanes.count),
      fresnel_(material, view.lanes, view.outside),
      lobe_(view.wo, alpha_of_roughness(view.inputs.number(material.roughness))),
      energy_(alpha_of_roughness(view.inputs.number(material.roughness))),
      lost_(energy_.at(view.wo.z).lost) {
    LaneValues average;
    fresnel_.average(average);
    double once = 0.0, repeatedly = 0.0;
    for (int k = 0; k < count_; ++k) {
        multiple_[k] = energy_.multiple(average[k]);
        once += average[k] * (1.0 - lost_);
        repeatedly += multiple_[k] * lost_;
    }
    if (repeatedly > 0.0) multiple_share_ = repeatedly / (once + repeatedly);
}

double ConductorSurface::eval(Vec3 wi, LaneValues& f) const {
    const GgxLobe::Value once = lobe_.eval(wi);
    const double more = energy_.compensation(lost_, energy_.at(wi.z).lost, wi.z);
    LaneValues reflectance;
    fresnel_.at(once.cos_m, reflectance);
    for (int k = 0; k < count_; ++k) f[k] = reflectance[k] * once.f_cos + multiple_[k] * more;
    return (1.0 - multiple_share_) * once.pdf + multiple_share_ * kEvenHemispherePdf;
}

double ConductorSurface::typical_density(Vec3 wi) const {
    return (1.0 - lost_) * lobe_.eval(wi).pdf + lost_ * kEvenHemispherePdf;
}

std::optional<Vec3> ConductorSurface::sample(double u_lobe, std::array<double, 2> u) const {
    return u_lobe < multiple_share_ ? sample_even_hemisphere(u) : lobe_.sample(u);
}

}  // namespace dewbow
