// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/debye.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/debye_series.h"
#include "dewbow/rainbow/mie/angular_sum.h"

namespace dewbow {
namespace {

Orders checked(Orders orders) {
    std::sort(orders.begin(), orders.end());
    if (!orders.empty() && orders.front() < 0) {
        throw InputError(fmt::format("debye has no order {}; expected 0 or more", orders.front()));
    }
    orders.erase(std::unique(orders.begin(), orders.end()), orders.end());
    return orders;
}

void add(PartialWaves& sum, const PartialWaves& term) {
    for (std::size_t i = 0; i < sum.a.size(); ++i) {
        sum.a[i] += term.a[i];
        sum.b[i] += term.b[i];
    }
}

class DebyeModel : public AmplitudeModel {
public:
    explicit DebyeModel(Orders orders) : orders_(checked(std::move(orders))) {}

    std::string_view name() const override { return "debye"; }

    void amplitudes(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                    std::span<Amplitudes> out) const override {
        const PartialWaves waves = partial_waves(index, drop);
        angular_sum({&waves, 1}, theta, out);
    }

    void intensities(ComplexIndex index, std::span<const Drop> drops, std::span<const Angle> theta,
                     std::span<Intensities> out) const override {
        std::vector<PartialWaves> waves;
        for (const Drop& drop : drops) waves.push_back(partial_waves(index, drop));
        std::vector<Amplitudes> amplitudes(out.size());
        angular_sum(waves, theta, amplitudes);
        std::transform(amplitudes.begin(), amplitudes.end(), out.begin(), [](const Amplitudes& s) {
            return Intensities{std::norm(s.perpendicular), std::norm(s.parallel)};
        });
    }

    Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const override {
        Efficiencies result = efficiencies_of(partial_waves(index, drop), drop.size_parameter);
        // By another sum, which keeps its digits where Re a_n is the small part of a small a_n.
        if (orders_.empty()) result.extinction = result.scattering;
        return result;
    }

private:
    PartialWaves partial_waves(ComplexIndex index, const Drop& drop) const {
        if (!index.is_real()) {
            throw InputError(fmt::format("model \"debye\" is for drops that do not absorb, not for "
                                         "an index with the imaginary part {}",
                                         index.k),
                             "model \"mie\" takes absorption into account");
        }
        if (!drop.is_sphere()) {
            throw InputError("model \"debye\" is for spheres, and this drop is not one",
                             "models of rays and Airy's treat flattened drops");
        }
        const DebyeSeries series({index.n}, drop.size_parameter);
        if (orders_.empty()) return series.all();
        PartialWaves sum = series.order(orders_.front());
        for (std::size_t i = 1; i < orders_.size(); ++i) add(sum, series.order(orders_[i]));
        return sum;
    }

    Orders orders_;  ///< ascending; empty: all
};

}  // namespace

std::unique_ptr<ScatteringModel> make_debye(const ModelOptions& options) {
    return std::make_unique<DebyeModel>(options.orders);
}

}  // namespace dewbow
