// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/composition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using namespace unit;

/// How much is left of the interference of diffracted with reflected light at the edge: it becomes
/// one with the reflection at angles above x^{−1/3} (Fock's region). The form and its two numbers
/// are a fit to Mie, n = 1.333, x = 300 to 9600 (error of the sum then 2 %; 6 % without).
double edge_interference(Angle theta, double x) {
    constexpr double kAtEdge = 0.55, kWidth = 2.4;
    const double t = theta.to(rad) * std::cbrt(x) / kWidth;
    return kAtEdge * std::exp(-t * t);
}

}  // namespace

DropAverages DropAverages::rescaled(double ratio) const {
    DropAverages result = *this;
    result.fringes = fringes.rescaled(ratio);
    result.diffraction = diffraction.rescaled(ratio);
    return result;
}

Composition::Composition(RelativeIndex n, const Orders& orders)
    : n_(n), diffraction_(orders.empty()) {
    for (const int p : orders)
        if (p < 0 || p > kHighestOrder)
            throw InputError(fmt::format("order {}; expected 0 to {}", p, kHighestOrder));
    const auto wanted = [&](int p) {
        return orders.empty() || std::find(orders.begin(), orders.end(), p) != orders.end();
    };
    reflected_ = wanted(0), refracted_ = wanted(1);
    for (int p = 2; p <= kHighestOrder; ++p)
        if (wanted(p)) bows_.emplace_back(n, p);
}

void Composition::add_rays(int p, std::span<const Angle> theta, std::span<Intensities> out) const {
    const double n = n_.value;
    for (std::size_t a = 0; a < theta.size(); ++a) {
        // The ray that leaves at θ: i = 90° − θ/2 outside; sin i = n sin(i − θ/2) inside.
        const double half = 0.5 * theta[a].to(rad);
        double b = std::cos(half), geometry = 0.25;
        if (p == 1) {
            const double s = n * std::sin(half), c = n * std::cos(half) - 1.0;
            if (c <= 0.0) break;  // beyond the ray at the edge
            b = s / std::hypot(s, c);
            const double ci = c / std::hypot(s, c), ncr = std::sqrt(n * n - b * b);
            // b / (sin θ |dθ/db|), by its limit on the axis.
            const double slope = 2.0 - 2.0 * ci / ncr;
            geometry = half < 1e-6 ? n * n / (4.0 * (n - 1.0) * (n - 1.0))
                                   : b * ci / (std::sin(2.0 * half) * slope);
        }
        const RayAmplitudes e = ray_amplitudes(drop_ray(b, n_), n_, p);
        out[a].perpendicular += geometry * e.perpendicular * e.perpendicular;
        out[a].parallel += geometry * e.parallel * e.parallel;
    }
}

ComposedLight Composition::beside_bows(std::span<const Angle> theta) const {
    ComposedLight light;
    light.per_square_.resize(theta.size());
    if (diffraction_)
        for (std::size_t a = 0; a < theta.size() && theta[a] < 90.0 * deg; ++a) {
            const RayAmplitudes r = ray_amplitudes(drop_ray(cos(0.5 * theta[a]), n_), n_, 0);
            light.forward_.push_back({theta[a], sin(theta[a]), {-r.perpendicular, -r.parallel}});
        }
    if (reflected_) add_rays(0, theta, light.per_square_);
    if (refracted_) add_rays(1, theta, light.per_square_);
    return light;
}

ComposedLight Composition::at(std::span<const Angle> theta) const {
    ComposedLight light = beside_bows(theta);
    for (const OrderPattern& bow : bows_) {
        light.bows_.push_back(bow.at(theta, {}));
        light.bows_.back().move_singles(light.per_square_);
    }
    return light;
}

void ComposedLight::add(const DropAverages& drops, std::span<Intensities> out) const {
    const double square = drops.fringes.mean_square();
    for (std::size_t a = 0; a < per_square_.size(); ++a) {
        out[a].perpendicular += square * per_square_[a].perpendicular;
        out[a].parallel += square * per_square_[a].parallel;
    }
    for (std::size_t a = 0; a < forward_.size(); ++a) {
        const Forward& at = forward_[a];
        const DiffractionAverage::Value value = drops.diffraction.at(at.sine);
        const double cross =
            value.cross * edge_interference(at.theta, drops.fringes.effective_size());
        out[a].perpendicular += value.diffracted + cross * at.grazing.perpendicular;
        out[a].parallel += value.diffracted + cross * at.grazing.parallel;
    }
    for (const BowLight& bow : bows_) bow.add(drops.fringes, out);
}

void Composition::add_beside_bows(const DropAverages& drops, std::span<const Angle> theta,
                                  std::span<Intensities> out) const {
    beside_bows(theta).add(drops, out);
}

void Composition::add(const DropAverages& drops, const BowShifts& shifts,
                      std::span<const Angle> theta, std::span<Intensities> out) const {
    add_beside_bows(drops, theta, out);
    for (const OrderPattern& bow : bows_)
        bow.at(theta, shifts[std::size_t(bow.order())]).add(drops.fringes, out);
}

CompositionFamily::CompositionFamily(RelativeIndex least, RelativeIndex greatest,
                                     const Orders& orders) {
    constexpr int kNodes = 4;
    const double middle = 0.5 * (least.value + greatest.value),
                 half = 0.5 * (greatest.value - least.value);
    const int count = half > 1e-9 ? kNodes : 1;
    for (int k = 0; k < count; ++k) {
        nodes_.push_back(middle - half * std::cos(std::numbers::pi * (k + 0.5) / count));
        compositions_.emplace_back(RelativeIndex{nodes_.back()}, orders);
    }
    bows_.resize(compositions_.front().bows_.size());
    for (const Composition& each : compositions_)
        for (std::size_t b = 0; b < bows_.size(); ++b) bows_[b].push_back(each.bows_[b]);
}

Composition CompositionFamily::at(RelativeIndex n) const {
    std::vector<double> weights(nodes_.size(), 1.0);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        for (std::size_t j = 0; j < nodes_.size(); ++j)
            if (i != j) weights[i] *= (n.value - nodes_[j]) / (nodes_[i] - nodes_[j]);
    std::vector<OrderPattern> bows;
    for (const std::vector<OrderPattern>& order : bows_) bows.emplace_back(n, order, weights);
    return {n, compositions_.front(), std::move(bows)};
}

}  // namespace dewbow
