// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/rough_dielectric.h"

#include <algorithm>
#include <cmath>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/surface/ggx_lobe.h"

namespace dewbow {

RoughDielectric::RoughDielectric(Vec3 wo, double alpha, double n)
    : wo_(wo),
      alpha_(alpha),
      n_(n),
      energy_(alpha, n),
      lost_(energy_.lost_near(std::min(1.0, wo.z))) {}

RoughDielectric::Value RoughDielectric::eval(Vec3 wi) const {
    if (wi.z == 0.0) return {};
    const bool reflects = wi.z > 0.0;
    const double cosine = std::min(1.0, std::abs(wi.z));
    const double lost_i = reflects ? energy_.lost_near(cosine) : energy_.lost_far(cosine);
    const double share = reflects ? energy_.reflected_share() : 1.0 - energy_.reflected_share();
    const Value once = eval_once(wi);
    return {once.f_cos + share * energy_.compensation(lost_, lost_i, cosine, reflects),
            (1.0 - lost_) * once.pdf + lost_ * share * kEvenHemispherePdf};
}

RoughDielectric::Value RoughDielectric::eval_once(Vec3 wi) const {
    const bool reflects = wi.z > 0.0;
    Vec3 m = reflects ? wo_ + wi : wo_ + wi * n_;
    const double squared = dot(m, m);
    if (!(squared > 0.0)) return {};
    m = m / std::sqrt(squared);
    if (m.z < 0.0) m = -m;
    const double cos_o = dot(wo_, m), cos_i = dot(wi, m);
    if (cos_o <= 0.0 || (reflects ? cos_i <= 0.0 : cos_i >= 0.0)) return {};
    const double reflectance = fresnel_dielectric(std::min(1.0, cos_o), n_).unpolarised();
    const double visible = ggx_visible_pdf(wo_, m, alpha_);
    double pdf = reflectance * visible / (4.0 * cos_o);
    if (!reflects) {
        const double k = cos_o + n_ * cos_i;
        pdf = (1.0 - reflectance) * visible * n_ * n_ * -cos_i / (k * k);
    }
    const Vec3 wi_up{wi.x, wi.y, std::abs(wi.z)};
    return {pdf * ggx_g1(wi_up, alpha_), pdf};
}

std::optional<Vec3> RoughDielectric::sample(double u_lobe, std::array<double, 2> u) const {
    const double renewed = renewed_number(u_lobe, lost_);
    if (u_lobe >= lost_) return sample_once(renewed, u);
    Vec3 wi = sample_even_hemisphere(u);
    if (renewed >= energy_.reflected_share()) wi.z = -wi.z;
    return wi;
}

std::optional<Vec3> RoughDielectric::sample_once(double u_lobe, std::array<double, 2> u) const {
    const Vec3 m = sample_visible_normal(wo_, alpha_, u);
    const double cos_m = std::min(1.0, dot(wo_, m));
    if (cos_m <= 0.0) return std::nullopt;
    const bool reflects = u_lobe < fresnel_dielectric(cos_m, n_).unpolarised();
    Vec3 wi = m * (2.0 * cos_m) - wo_;
    if (!reflects) {
        const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_m, n_)));
        wi = m * (cos_m / n_ - cos_t) - wo_ * (1.0 / n_);
    }
    if ((wi.z > 0.0) != reflects) return std::nullopt;
    return normalised(wi);
}

}  // namespace dewbow
