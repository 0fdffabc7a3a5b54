// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "dewbow/rainbow/automatic.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/composition.h"
#include "dewbow/rainbow/mie/mie_model.h"

namespace dewbow {
namespace {

class AutomaticModel final : public ScatteringModel {
public:
    explicit AutomaticModel(const ModelOptions& options) : options_(options), mie_(make_mie({})) {}
    std::string_view name() const override { return "auto"; }
    void intensities(ComplexIndex index, std::span<const Drop> drops, std::span<const Angle> theta,
                     std::span<Intensities> out) const override;
    Efficiencies efficiencies(ComplexIndex index, const Drop& drop) const override {
        return mie_->efficiencies(index, {drop.size_parameter, {}});
    }

private:
    bool is_exact(ComplexIndex index, double x) const {
        return options_.orders.empty() &&
               (x < kLeastSummedSize || !is_clear(index.k, x) ||
                x * options_.averaging.relative_width < kWashedOutDeviation);
    }
    void add_sum(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                 std::span<Intensities> out) const;

    ModelOptions options_;
    std::unique_ptr<ScatteringModel> mie_;
};

void AutomaticModel::intensities(ComplexIndex index, std::span<const Drop> drops,
                                 std::span<const Angle> theta, std::span<Intensities> out) const {
    for (std::size_t d = 0; d < drops.size(); ++d) {
        const auto row = out.subspan(d * theta.size(), theta.size());
        const Drop sphere{drops[d].size_parameter, {}};
        if (is_exact(index, sphere.size_parameter)) {
            mie_->intensities(index, {&sphere, 1}, theta, row);
        } else {
            std::fill(row.begin(), row.end(), Intensities{});
            add_sum(index, drops[d], theta, row);
        }
    }
}

void AutomaticModel::add_sum(ComplexIndex index, const Drop& drop, std::span<const Angle> theta,
                             std::span<Intensities> out) const {
    const double x = drop.size_parameter, share = 1.0;
    const Composition composition(RelativeIndex{index.n}, options_.orders);
    const DropAverages averages({&x, 1}, {&share, 1});
    composition.add(averages, drop.shifts, theta, out);
    if (!options_.orders.empty()) return;

    const AutomaticPlan plan =
        plan_angles(x, is_point(options_.averaging.disc_radius), options_.tolerance);
    std::vector<Angle> exact;
    std::vector<std::size_t> where;
    for (std::size_t a = 0; a < theta.size(); ++a)
        if (exact_weight(plan.exact, theta[a]) > 0.0) exact.push_back(theta[a]), where.push_back(a);
    std::vector<Intensities> mie(exact.size()), sum(exact.size());
    const Drop sphere{x, {}};
    mie_->intensities(index, {&sphere, 1}, exact, mie);
    composition.add(averages, {}, exact, sum);
    for (std::size_t e = 0; e < exact.size(); ++e) {
        const double weight = exact_weight(plan.exact, exact[e]);
        Intensities& at = out[where[e]];
        at.perpendicular += weight * (mie[e].perpendicular - sum[e].perpendicular);
        at.parallel += weight * (mie[e].parallel - sum[e].parallel);
        at = {std::max(at.perpendicular, 0.0), std::max(at.parallel, 0.0)};
    }
}

}  // namespace

std::unique_ptr<ScatteringModel> make_automatic(const ModelOptions& options) {
    return std::make_unique<AutomaticModel>(options);
}

}  // namespace dewbow
