// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/mie_model.h"

#include <algorithm>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/mie/angular_sum.h"
#include "dewbow/rainbow/mie/partial_waves.h"

namespace dewbow {
namespace {

/// Spheres whose sums share π_n and τ_n: enough that those no longer count, few enough for the
/// caches (bench/micro/mie_speed.cpp).
constexpr std::size_t kGroup = 16;

class MieModel final : public AmplitudeModel {
public:
    std::string_view name() const override { return "mie"; }
    void intensities(ComplexIndex index, std::span<const Drop> drops, std::span<const Angle> theta,
                     std::span<Intensities> out) const override;
    Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const override;
    void amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                    std::span<Amplitudes> out) const override;
};

PartialWaves waves_of(ComplexIndex index, const Drop& drop) {
    if (!drop.is_sphere())
        throw InputError("model \"mie\" is for spheres, and this drop is not one",
                         "models of rays and Airy's treat flattened drops");
    return mie_waves(index, drop.size_parameter);
}

void MieModel::intensities(ComplexIndex index, std::span<const Drop> drops,
                           std::span<const Angle> theta, std::span<Intensities> out) const {
    std::vector<Amplitudes> sums(std::min(drops.size(), kGroup) * theta.size());
    std::vector<PartialWaves> waves;
    AngularSum angular_sum(theta);
    for (std::size_t first = 0; first < drops.size(); first += kGroup) {
        const auto group = drops.subspan(first, std::min(kGroup, drops.size() - first));
        waves.clear();
        for (const Drop& drop : group) waves.push_back(waves_of(index, drop));
        angular_sum.sum(waves, sums);
        std::transform(sums.begin(), sums.begin() + std::ptrdiff_t(group.size() * theta.size()),
                       out.begin() + std::ptrdiff_t(first * theta.size()), [](const Amplitudes& S) {
                           return Intensities{std::norm(S.perpendicular), std::norm(S.parallel)};
                       });
    }
}

Efficiencies MieModel::efficiencies(ComplexIndex index, const Drop& drop) const {
    return efficiencies_of(waves_of(index, drop), drop.size_parameter);
}

void MieModel::amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                          std::span<Amplitudes> out) const {
    const PartialWaves waves = waves_of(index, drop);
    angular_sum({&waves, 1}, theta, out);
}

}  // namespace

std::unique_ptr<ScatteringModel> make_mie(const ModelOptions& options) {
    if (!options.orders.empty())
        throw InputError("model \"mie\" does not know orders of light: it has all of it together",
                         "model \"debye\" has them one by one");
    return std::make_unique<MieModel>();
}

}  // namespace dewbow
