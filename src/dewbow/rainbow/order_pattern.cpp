// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/order_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "dewbow/rainbow/bow_passages.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/ray_pair_series.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;

/// Distance of the nodes in deflection. Cubics between them are right to 1e-4 of P and Q.
constexpr double kFineStep = 0.5 * kPi / 180.0, kCoarseStep = 1.0 * kPi / 180.0;
/// How far the dark side is followed. From kFading on it is faded out: only drops with x < 100 or
/// high orders have light left there.
constexpr double kDark = 0.8, kFading = 0.4;
/// The dark side ends before 0° and 180°.
constexpr double kAxisDistance = 0.05;

/// 1 before `from`, 0 after `to`, smooth between.
double fade(double value, double from, double to) {
    const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

double reach(double to_axial_ray) {
    return to_axial_ray / std::sqrt(1.0 + to_axial_ray * to_axial_ray);
}

}  // namespace

OrderPattern::OrderPattern(RelativeIndex n, int p) : bow_(bow_geometry(n, p)) {
    step_ = p <= 3 ? kFineStep : kCoarseStep;
    const double to_axis = bow_.least - kPi * std::floor(bow_.least / kPi) - kAxisDistance;
    const double dark_steps = std::floor(std::min(kDark, to_axis) / step_);
    first_ = -(dark_steps + 0.5) * step_;  // the bow halfway between two
    const int count = int(std::ceil((bow_.most - bow_.least - first_) / step_)) + 4;
    nodes_.resize(std::size_t(count));

    std::optional<RayPairSeries> series;
    if (n.value >= kLowestBowIndex && n.value <= kHighestBowIndex) series.emplace(n, p);
    const auto pair_at = [&](double offset) {
        const double turn = bow_.least + offset;
        return series && turn > series->darkest() ? series->at(turn) : ray_pair(bow_, offset);
    };
    constexpr double kBeforeGrazing = 1e-3;  // of the span
    const Node last =
        of_pair((1.0 - kBeforeGrazing) * bow_.span, pair_at((1.0 - kBeforeGrazing) * bow_.span));
    for (int k = 0; k < count; ++k) {
        const double offset = first_ + k * step_;
        nodes_[std::size_t(k)] = offset < (1.0 - kBeforeGrazing) * bow_.span
                                     ? of_pair(offset, pair_at(offset))
                                     : of_ray(offset, last);
    }
}

OrderPattern::OrderPattern(RelativeIndex n, std::span<const OrderPattern> patterns,
                           std::span<const double> weights)
    : bow_(bow_geometry(n, patterns[0].order())), step_(patterns[0].step_) {
    std::size_t count = patterns[0].nodes_.size();
    first_ = patterns[0].first_;
    for (const OrderPattern& each : patterns) first_ = std::max(first_, each.first_);
    const auto skipped = [&](const OrderPattern& each) {
        return std::size_t(std::lround((first_ - each.first_) / step_));
    };
    for (const OrderPattern& each : patterns)
        count = std::min(count, each.nodes_.size() - skipped(each));
    nodes_.assign(count, Node{});
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const Node* from = patterns[i].nodes_.data() + skipped(patterns[i]);
        const double w = weights[i];
        for (std::size_t k = 0; k < count; ++k) {
            nodes_[k].z += w * from[k].z;
            nodes_[k].P_perpendicular += w * from[k].P_perpendicular;
            nodes_[k].Q_perpendicular += w * from[k].Q_perpendicular;
            nodes_[k].P_parallel += w * from[k].P_parallel;
            nodes_[k].Q_parallel += w * from[k].Q_parallel;
        }
    }
}

OrderPattern::Node OrderPattern::of_pair(double offset, const RayPair<double>& pair) const {
    const double end = -first_ - step_;
    const double left = fade(-offset, std::min(kFading, 0.5 * end), end) *
                        std::sqrt(2.0 / reach(bow_.most - bow_.least - offset));
    return {pair.zeta, left * pair.perpendicular.P, left * pair.perpendicular.Q,
            left * pair.parallel.P, left * pair.parallel.Q};
}

OrderPattern::Node OrderPattern::of_ray(double offset, const Node& before) const {
    // Beyond the axial ray the pattern mirrors itself.
    constexpr double kLeastDistance = 1e-4;
    const double to_axial = std::max(std::abs(bow_.most - bow_.least - offset), kLeastDistance);
    const double turn = std::max(bow_.most - to_axial, bow_.grazing());
    const LoneRay ray = lone_ray(bow_, turn - bow_.least);
    // The other one grazes the drop, and goes on along its surface.
    const double path = 2.0 * bow_.p * std::sqrt(bow_.n * bow_.n - 1.0) + turn - bow_.grazing();
    const double z = std::cbrt(std::pow(0.75 * (path - ray.path), 2.0));
    const double scale = std::sqrt((bow_.most - turn) / reach(to_axial));
    const double root = scale * std::pow(z, 0.25), per_root = scale / std::pow(z, 0.25);
    return {z, std::copysign(root * ray.perpendicular, before.P_perpendicular),
            std::copysign(per_root * ray.perpendicular, before.Q_perpendicular),
            std::copysign(root * ray.parallel, before.P_parallel),
            std::copysign(per_root * ray.parallel, before.Q_parallel)};
}

OrderPattern::Node OrderPattern::interpolated(double position) const {
    const auto k = std::min(std::size_t(position), nodes_.size() - 3);
    const double t = position - double(k);
    // Lagrange's cubic through four nodes.
    const double w0 = -t * (t - 1.0) * (t - 2.0) / 6.0,
                 w1 = (t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0,
                 w2 = -(t + 1.0) * t * (t - 2.0) / 2.0, w3 = (t + 1.0) * t * (t - 1.0) / 6.0;
    const Node &n0 = nodes_[k - 1], &n1 = nodes_[k], &n2 = nodes_[k + 1], &n3 = nodes_[k + 2];
    const auto mix = [&](double Node::*part) {
        return w0 * n0.*part + w1 * n1.*part + w2 * n2.*part + w3 * n3.*part;
    };
    return {mix(&Node::z), mix(&Node::P_perpendicular), mix(&Node::Q_perpendicular),
            mix(&Node::P_parallel), mix(&Node::Q_parallel)};
}

void OrderPattern::add_passage(double turn, double sine, double brightness, std::uint32_t angle,
                               BowLight& light) const {
    /// Nearer than this to 0° and 180° light that meets there is no longer summed as rays.
    constexpr double kBesideAxis = 0.03;
    const Node at = interpolated((turn - bow_.least - first_) / step_);
    const bool along_axis = std::lround(turn / kPi) == bow_.p - 1;
    const bool beside_axis = !along_axis && sine < kBesideAxis;
    const double to_axial = bow_.most - turn;
    double geometry = reach(to_axial);
    if (along_axis && sine < 1e-6)
        geometry = 1.0;  // reach over sine, on the axis
    else if (!beside_axis)
        geometry /= sine;
    geometry *= brightness;
    const Intensities P2{geometry * at.P_perpendicular * at.P_perpendicular,
                         geometry * at.P_parallel * at.P_parallel};
    const Intensities Q2{geometry * at.Q_perpendicular * at.Q_perpendicular,
                         geometry * at.Q_parallel * at.Q_parallel};
    if (turn > bow_.grazing() && !beside_axis) {  // A² = ½ (P² / √z + Q² √z)
        const double root = std::sqrt(at.z), half = 0.5 / root, of_Q = 0.5 * root;
        light.singles_.push_back({angle,
                                  {half * P2.perpendicular + of_Q * Q2.perpendicular,
                                   half * P2.parallel + of_Q * Q2.parallel}});
        return;
    }
    (beside_axis ? light.beside_axis_ : light.pairs_)
        .push_back({angle,
                    at.z,
                    {kPi * P2.perpendicular, kPi * P2.parallel},
                    {kPi * Q2.perpendicular, kPi * Q2.parallel},
                    sine});
}

BowLight OrderPattern::at(std::span<const Angle> theta, Angle shift) const {
    BowLight light;
    for (std::size_t a = 0; a < theta.size(); ++a) {
        const bool turned = shift != Angle{};
        const Angle unshifted = turned ? angle_without_shift(theta[a], shift) : theta[a];
        const double sine = sin(unshifted),
                     brightness = turned ? brightness_of_shift(theta[a], shift) : 1.0;
        for_each_passage(bow_, bow_.least + first_ + step_, unshifted.to(rad),
                         [&](const Passage& way) {
                             add_passage(way.deviation, sine, brightness, std::uint32_t(a), light);
                         });
    }
    return light;
}

void BowLight::move_singles(std::span<Intensities> per_square) {
    for (const Single& from : singles_) {
        per_square[from.angle].perpendicular += from.per_square.perpendicular;
        per_square[from.angle].parallel += from.per_square.parallel;
    }
    singles_.clear();
}

void BowLight::add(const FringeAverage& drops, std::span<Intensities> out) const {
    for (const Passage& from : pairs_) {
        const FringeAverage::Value v = drops.at(from.z);
        out[from.angle].perpendicular +=
            from.of_G.perpendicular * v.G + from.of_H.perpendicular * v.H;
        out[from.angle].parallel += from.of_G.parallel * v.G + from.of_H.parallel * v.H;
    }
    const double square = drops.mean_square();
    for (const Single& from : singles_) {
        out[from.angle].perpendicular += square * from.per_square.perpendicular;
        out[from.angle].parallel += square * from.per_square.parallel;
    }
    // Rays that cross the axis with b > 0 are a caustic on it: there J_0²(x b θ) takes the place of
    // 2 / (π x b sin θ); with its value on the axis, and its mean beyond.
    constexpr double kTypicalImpact = 0.8;
    const double blur = 2.0 / (kPi * kTypicalImpact * drops.effective_size());
    for (const Passage& from : beside_axis_) {
        const FringeAverage::Value v = drops.at(from.z);
        const double per_sine = 1.0 / std::hypot(from.sine, blur);
        out[from.angle].perpendicular +=
            per_sine * (from.of_G.perpendicular * v.G + from.of_H.perpendicular * v.H);
        out[from.angle].parallel +=
            per_sine * (from.of_G.parallel * v.G + from.of_H.parallel * v.H);
    }
}

}  // namespace dewbow
