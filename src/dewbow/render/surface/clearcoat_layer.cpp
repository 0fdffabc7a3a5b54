// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/clearcoat_layer.h"

#include "dewbow/render/surface/schlick.h"

namespace dewbow {
namespace {

constexpr double kF0 = 0.04;  // ((1.5 − 1) / (1.5 + 1))²

}  // namespace

ClearcoatLayer::ClearcoatLayer(Vec3 wo, double strength, double roughness)
    : strength_(strength),
      lobe_(wo, alpha_of_roughness(roughness)),
      energy_(alpha_of_roughness(roughness)),
      multiple_(energy_.multiple(average_schlick(kF0, 1.0))),
      albedo_o_(energy_.at(wo.z)),
      once_(strength * albedo_o_.schlick(kF0, 1.0)),
      repeatedly_(strength * multiple_ * albedo_o_.lost) {}

double ClearcoatLayer::albedo(const GgxAlbedo& albedo) const {
    return strength_ * (albedo.schlick(kF0, 1.0) + multiple_ * albedo.lost);
}

ClearcoatLayer::Value ClearcoatLayer::eval(Vec3 wi) const {
    const GgxLobe::Value lobe = lobe_.eval(wi);
    const GgxAlbedo albedo_i = energy_.at(wi.z);
    const double more = energy_.compensation(albedo_o_.lost, albedo_i.lost, wi.z);
    const double f = schlick(kF0, 1.0, grazing(lobe.cos_m)) * lobe.f_cos + multiple_ * more;
    return {strength_ * f, 1.0 - std::max(once_ + repeatedly_, albedo(albedo_i)), lobe.pdf};
}

}  // namespace dewbow
