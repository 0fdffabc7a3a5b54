// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/pane_surface.h"

#include "dewbow/optics/refraction.h"

namespace dewbow {

double pane_reflectance(double cosine, double n) {
    const double r = fresnel_dielectric(std::min(1.0, cosine), n).unpolarised();
    return 2.0 * r / (1.0 + r);
}

PaneSurface::PaneSurface(const ThinDielectric& material, const SurfaceView& view)
    : count_(view.lanes.count),
      lobe_(view.wo, alpha_of_roughness(view.inputs.number(material.roughness))),
      energy_(alpha_of_roughness(view.inputs.number(material.roughness))),
      lost_(energy_.at(view.wo.z).lost) {
    material.index->eval_lanes(view.lanes.lambdas(), index_.first(count_));
    for (int k = 0; k < count_; ++k) index_[k] /= view.outside[k];
    view.inputs.colour(material.tint, view.lanes, tint_);
    // What is lost leaves on either side as a beam at the mean angle of the hemisphere would.
    constexpr double kMeanCosine = 2.0 / 3.0;
    average_ = reflectances(kMeanCosine, average_reflectance_);
}

/// Returns the mean of all lanes.
double PaneSurface::reflectances(double cosine, LaneValues& r) const {
    double mean = 0.0;
    for (int k = 0; k < count_; ++k) {
        r[k] = pane_reflectance(cosine, index_[k]);
        mean += r[k] / count_;
    }
    return mean;
}

double PaneSurface::eval(Vec3 wi, LaneValues& f) const {
    const bool reflects = wi.z > 0.0;
    const Vec3 mirrored{wi.x, wi.y, std::abs(wi.z)};
    const GgxLobe::Value once = lobe_.eval(mirrored);
    const double more = energy_.compensation(lost_, energy_.at(mirrored.z).lost, mirrored.z);
    LaneValues r;
    const double mean = reflectances(once.cos_m, r);
    for (int k = 0; k < count_; ++k)
        f[k] = reflects ? r[k] * once.f_cos + average_reflectance_[k] * more
                        : tint_[k] *
                              ((1.0 - r[k]) * once.f_cos + (1.0 - average_reflectance_[k]) * more);
    const double share = reflects ? mean : 1.0 - mean;
    const double average_share = reflects ? average_ : 1.0 - average_;
    return (1.0 - lost_) * share * once.pdf + lost_ * average_share * kEvenHemispherePdf;
}

double PaneSurface::typical_density(Vec3 wi) const {
    constexpr double kShareOfSide = 0.5;
    const double once = lobe_.eval({wi.x, wi.y, std::abs(wi.z)}).pdf;
    return kShareOfSide * ((1.0 - lost_) * once + lost_ * kEvenHemispherePdf);
}

std::optional<Vec3> PaneSurface::sample(double u_lobe, std::array<double, 2> u) const {
    const auto on_side = [](Vec3 wi, bool reflects) {
        return Vec3{wi.x, wi.y, reflects ? wi.z : -wi.z};
    };
    const double u_side = renewed_number(u_lobe, lost_);
    if (u_lobe < lost_) return on_side(sample_even_hemisphere(u), u_side < average_);
    const std::optional<Vec3> wi = lobe_.sample(u);
    if (!wi) return std::nullopt;
    LaneValues r;
    return on_side(*wi, u_side < reflectances(lobe_.eval(*wi).cos_m, r));
}

}  // namespace dewbow
