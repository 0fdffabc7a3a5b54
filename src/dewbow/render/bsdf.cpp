// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/bsdf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/optics/refraction.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
/// Neither lobe is sampled more rarely than this while it reflects anything.
constexpr double kLeastShare = 0.1;

/// Schlick's approximation, which glTF prescribes.
double schlick(double f0, double cosine) {
    const double x = std::clamp(1.0 - cosine, 0.0, 1.0);
    return f0 + (1.0 - f0) * (x * x) * (x * x) * x;
}

}  // namespace

bool OpaqueSurface::holds(const Material& material) {
    return std::holds_alternative<Diffuse>(material.surface) ||
           std::holds_alternative<MetallicRoughness>(material.surface);
}

OpaqueSurface::OpaqueSurface(const Material& material, const SurfaceInputs& inputs,
                             const LaneSet& lanes, Vec3 wo)
    : count_(lanes.count), wo_(wo) {
    if (const auto* diffuse = std::get_if<Diffuse>(&material.surface)) {
        inputs.colour(diffuse->reflectance, lanes, base_);
        return;
    }
    const auto& m = std::get<MetallicRoughness>(material.surface);
    inputs.colour(m.base_colour, lanes, base_);
    metalness_ = inputs.number(m.metalness);
    const double roughness = inputs.number(m.roughness);
    alpha_ = std::max(kLeastAlpha, roughness * roughness);
    f0_ = (m.ior - 1.0) * (m.ior - 1.0) / ((m.ior + 1.0) * (m.ior + 1.0));
    double base = 0.0;
    for (int k = 0; k < count_; ++k) base += base_[k] / count_;
    const double plastic = schlick(f0_, wo.z);
    const double specular = (1.0 - metalness_) * plastic + metalness_ * schlick(base, wo.z);
    const double diffuse = (1.0 - metalness_) * base * (1.0 - plastic);
    if (specular + diffuse > 0.0) specular_share_ = specular / (specular + diffuse);
    specular_share_ =
        metalness_ >= 1.0 ? 1.0 : std::clamp(specular_share_, kLeastShare, 1.0 - kLeastShare);
}

double OpaqueSurface::eval(Vec3 wi, LaneValues& f) const {
    if (wi.z <= 0.0 || wo_.z <= 0.0) {
        for (int k = 0; k < count_; ++k) f[k] = 0.0;
        return 0.0;
    }
    double pdf = (1.0 - specular_share_) * pdf_cosine_hemisphere(wi.z);
    if (alpha_ == 0.0) {
        for (int k = 0; k < count_; ++k) f[k] = base_[k] / kPi * wi.z;
        return pdf;
    }
    const Vec3 m = normalised(wo_ + wi);
    const double cosine = dot(wo_, m);
    const double lobe = ggx_d(m, alpha_) * ggx_g1(wo_, alpha_) * ggx_g1(wi, alpha_) / (4.0 * wo_.z);
    pdf += specular_share_ * ggx_visible_pdf(wo_, m, alpha_) / (4.0 * cosine);
    const double plastic = schlick(f0_, cosine);
    for (int k = 0; k < count_; ++k) {
        const double body = base_[k] / kPi * wi.z;
        f[k] = (1.0 - metalness_) * ((1.0 - plastic) * body + plastic * lobe) +
               metalness_ * schlick(base_[k], cosine) * lobe;
    }
    return pdf;
}

std::optional<Vec3> OpaqueSurface::sample(double u_lobe, std::array<double, 2> u) const {
    if (u_lobe >= specular_share_) return sample_cosine_hemisphere(u[0], u[1]).v;
    const Vec3 m = sample_visible_normal(wo_, alpha_, u);
    const Vec3 wi = m * (2.0 * dot(wo_, m)) - wo_;
    if (wi.z <= 0.0) return std::nullopt;
    return normalised(wi);
}

RoughDielectricValue eval_rough_dielectric(Vec3 wo, Vec3 wi, double alpha, double n) {
    const bool reflects = wi.z > 0.0;
    Vec3 m = reflects ? wo + wi : wo + wi * n;
    const double squared = dot(m, m);
    if (!(squared > 0.0) || wi.z == 0.0) return {};
    m = m / std::sqrt(squared);
    if (m.z < 0.0) m = -m;
    const double cos_o = dot(wo, m), cos_i = dot(wi, m);
    if (cos_o <= 0.0 || (reflects ? cos_i <= 0.0 : cos_i >= 0.0)) return {};
    const double reflectance = fresnel_dielectric(cos_o, n).unpolarised();
    const double visible = ggx_visible_pdf(wo, m, alpha);
    double pdf = reflectance * visible / (4.0 * cos_o);
    if (!reflects) {
        const double k = cos_o + n * cos_i;
        pdf = (1.0 - reflectance) * visible * n * n * -cos_i / (k * k);
    }
    const Vec3 wi_up{wi.x, wi.y, std::abs(wi.z)};
    return {pdf * ggx_g1(wi_up, alpha), pdf};
}

}  // namespace dewbow
