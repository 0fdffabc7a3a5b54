// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/layered_surface.h"

#include <numbers>

#include "dewbow/render/surface/schlick.h"

namespace dewbow {
namespace {

/// No lobe is sampled much more rarely than this while it reflects anything.
constexpr double kLeastShare = 0.1;
/// Below this a dielectric leaves next to nothing to the body under it.
constexpr double kLeastLeft = 1e-6;

double mixed(double dielectric, double metal, double metalness) {
    return dielectric + (metal - dielectric) * metalness;
}

double mean_of(const LaneValues& values, int count) {
    double sum = 0.0;
    for (int k = 0; k < count; ++k) sum += values[k];
    return sum / count;
}

}  // namespace

LayeredSurface::LayeredSurface(const MetallicRoughness& material, const SurfaceView& view)
    : count_(view.lanes.count),
      lobe_(view.wo, alpha_of_roughness(view.inputs.number(material.roughness))),
      energy_(alpha_of_roughness(view.inputs.number(material.roughness))),
      albedo_o_(energy_.at(view.wo.z)) {
    make_base(material, view);
    make_layers(material, view);
    make_shares();
}

void LayeredSurface::make_base(const MetallicRoughness& material, const SurfaceView& view) {
    LaneValues base;
    view.inputs.colour(material.base_colour, view.lanes, base);
    view.inputs.colour(material.specular_colour, view.lanes, dielectric_f0_);
    const double metalness = view.inputs.number(material.metalness);
    dielectric_f90_ = view.inputs.number(material.specular);
    f90_ = mixed(dielectric_f90_, 1.0, metalness);
    has_body_ = metalness < 1.0;
    const double amplitude = (material.ior - 1.0) / (material.ior + 1.0);
    for (int k = 0; k < count_; ++k) {
        // [KHR_materials_specular]
        dielectric_f0_[k] =
            std::min(1.0, amplitude * amplitude * dielectric_f0_[k]) * dielectric_f90_;
        dielectric_multiple_[k] =
            energy_.multiple(average_schlick(dielectric_f0_[k], dielectric_f90_));
        f0_[k] = mixed(dielectric_f0_[k], base[k], metalness);
        multiple_[k] = mixed(dielectric_multiple_[k],
                             energy_.multiple(average_schlick(base[k], 1.0)), metalness);
        const double left = 1.0 - dielectric_albedo(albedo_o_, k);
        const double left_on_average = 1.0 - dielectric_albedo(energy_.average(), k);
        body_[k] = (1.0 - metalness) * base[k] / std::numbers::pi * left /
                   std::max(kLeastLeft, left_on_average);
    }
}

void LayeredSurface::make_layers(const MetallicRoughness& material, const SurfaceView& view) {
    const double strength = view.inputs.number(material.clearcoat);
    if (strength > 0.0)
        clearcoat_.emplace(view.wo, strength, view.inputs.number(material.clearcoat_roughness));
    if (material.sheen_colour) {
        sheen_.emplace(view.wo, view.inputs.number(material.sheen_roughness));
        view.inputs.colour(material.sheen_colour, view.lanes, sheen_colour_);
    }
}

void LayeredSurface::make_shares() {
    const double body = std::numbers::pi * mean_of(body_, count_);
    const double once = albedo_o_.schlick(mean_of(f0_, count_), f90_);
    const double repeatedly = mean_of(multiple_, count_) * albedo_o_.lost;
    const double sheen =
        sheen_ ? mean_of(sheen_colour_, count_) * std::min(1.0, sheen_->albedo_o()) : 0.0;
    const double varnish = clearcoat_ ? clearcoat_->once() : 0.0;
    const double above = clearcoat_ ? clearcoat_->repeatedly() : 0.0;
    const double under_varnish = std::max(0.0, 1.0 - varnish - above);
    const double base = under_varnish * std::max(0.0, 1.0 - sheen);
    shares_ = {base * body, base * once, varnish,
               above + under_varnish * sheen + base * repeatedly};
    const double all = shares_.body + shares_.specular + shares_.clearcoat + shares_.even;
    if (!(all > 0.0)) {
        shares_ = {0.0, 1.0, 0.0, 0.0};
        return;
    }
    for (double* share : {&shares_.body, &shares_.specular, &shares_.clearcoat})
        if (*share > 0.0) *share = std::max(*share, kLeastShare * all);
    const double sum = shares_.body + shares_.specular + shares_.clearcoat + shares_.even;
    for (double* share : {&shares_.body, &shares_.specular, &shares_.clearcoat, &shares_.even})
        *share /= sum;
}

double LayeredSurface::eval(Vec3 wi, LaneValues& f) const {
    const GgxLobe::Value lobe = lobe_.eval(wi);
    const GgxAlbedo albedo_i = energy_.at(wi.z);
    const double more = energy_.compensation(albedo_o_.lost, albedo_i.lost, wi.z);
    const double at_grazing = grazing(lobe.cos_m);
    for (int k = 0; k < count_; ++k)
        f[k] = schlick(f0_[k], f90_, at_grazing) * lobe.f_cos + multiple_[k] * more;
    if (has_body_)
        for (int k = 0; k < count_; ++k)
            f[k] += body_[k] * (1.0 - dielectric_albedo(albedo_i, k)) * wi.z;
    double pdf = shares_.body * pdf_cosine_hemisphere(wi.z) + shares_.specular * lobe.pdf +
                 shares_.even * kEvenHemispherePdf;
    if (sheen_) {
        const double albedo = sheen_->albedo(wi.z), fibres = sheen_->eval(wi, albedo);
        for (int k = 0; k < count_; ++k)
            f[k] = f[k] * sheen_->leaves(sheen_colour_[k], albedo) + sheen_colour_[k] * fibres;
    }
    if (clearcoat_) {
        const ClearcoatLayer::Value varnish = clearcoat_->eval(wi);
        for (int k = 0; k < count_; ++k) f[k] = f[k] * varnish.leaves + varnish.f_cos;
        pdf += shares_.clearcoat * varnish.pdf;
    }
    return pdf;
}

/// Equal shares of the lobes that it has.
double LayeredSurface::typical_density(Vec3 wi) const {
    double sum = lobe_.eval(wi).pdf;
    int lobes = 1;
    const auto add = [&](double pdf) { sum += pdf, ++lobes; };
    if (has_body_) add(pdf_cosine_hemisphere(wi.z));
    if (clearcoat_) add(clearcoat_->eval(wi).pdf);
    if (sheen_) add(kEvenHemispherePdf);
    return sum / lobes;
}

std::optional<Vec3> LayeredSurface::sample(double u_lobe, std::array<double, 2> u) const {
    if (u_lobe < shares_.body) return sample_cosine_hemisphere(u[0], u[1]).v;
    u_lobe -= shares_.body;
    if (u_lobe < shares_.even) return sample_even_hemisphere(u);
    u_lobe -= shares_.even;
    if (clearcoat_ && u_lobe < shares_.clearcoat) return clearcoat_->sample(u);
    return lobe_.sample(u);
}

}  // namespace dewbow
