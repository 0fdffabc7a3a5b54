// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_tree.h"

#include <algorithm>
#include <cmath>

#include "dewbow/render/light_tree_limits.h"

namespace dewbow {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1
/// What a cosine counts for at least where light is possible at all: bounds that are rounded may
/// miss the rim by this much.
constexpr double kLeastCosine = 2e-3;

/// Cosine and sine of an angle in [0, π].
struct CosSin {
    double cosine, sine;

    static CosSin of(double cosine) {
        const double c = std::clamp(cosine, -1.0, 1.0);
        return {c, std::sqrt(1.0 - c * c)};
    }
};

/// Of max(0, a − b).
CosSin less(CosSin a, CosSin b) {
    if (a.cosine > b.cosine) return {1.0, 0.0};
    return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
}

}  // namespace

/// Irradiance of a light of the node's whole intensity at the ball's centre, with each angle as
/// favourable as the bounds allow. [Conty Estevez & Kulla 2018, eq. 3]
double LightTree::importance(const Node& node, const Receiver& receiver) const {
    const Vec3 centre{node.centre[0], node.centre[1], node.centre[2]};
    const Vec3 to_light = centre - receiver.position;
    const double d2 = dot(to_light, to_light), r2 = double(node.radius) * node.radius;
    if (!(d2 > r2)) return r2 > 0.0 ? node.intensity / r2 : 0.0;
    const double inverse = 1.0 / d2, per_distance = std::sqrt(inverse);
    const Vec3 direction = to_light * per_distance;
    const double sin_ball = node.radius * per_distance;
    const CosSin ball{std::sqrt(std::max(0.0, 1.0 - sin_ball * sin_ball)), sin_ball};
    double result = node.intensity * inverse;
    if (node.cos_normals > -1.0f) {  // else alike to all sides
        const double along = -dot(direction, Vec3{node.axis[0], node.axis[1], node.axis[2]});
        const CosSin off_axis = CosSin::of(node.two_sided ? std::abs(along) : along);
        const CosSin outside = less(less(off_axis, {node.cos_normals, node.sin_normals}), ball);
        if (outside.cosine < node.cos_emission) return 0.0;
        result *= std::max(outside.cosine, kLeastCosine);
    }
    if (!receiver.one_sided()) return result;
    const CosSin incidence = less(CosSin::of(dot(direction, receiver.normal)), ball);
    if (incidence.cosine < -light_tree::kRim) return 0.0;
    return result * std::max(incidence.cosine, kLeastCosine);
}

double LightTree::irradiance(const Receiver& receiver) const {
    return empty() ? 0.0 : intensity_ * importance(nodes_[0], receiver);
}

/// Probability of the first child of `parent`; less than 0 if neither can give light.
double LightTree::first_share(std::uint32_t parent, const Receiver& receiver) const {
    const double first = importance(nodes_[parent + 1], receiver);
    const double second = importance(nodes_[nodes_[parent].second], receiver);
    const double both = first + second;
    return both > 0.0 ? first / both : -1.0;
}

std::optional<LightTree::Choice> LightTree::sample(const Receiver& receiver, double u) const {
    if (empty()) return std::nullopt;
    std::uint32_t at = 0;
    double probability = 1.0;
    while (nodes_[at].second) {
        const double share = first_share(at, receiver);
        if (share < 0.0) return std::nullopt;
        const bool first = u < share;
        u = std::min(first ? u / share : (u - share) / (1.0 - share), kOneBelow);
        probability *= first ? share : 1.0 - share;
        at = first ? at + 1 : nodes_[at].second;
    }
    return Choice{int(nodes_[at].light), probability};
}

double LightTree::probability(const Receiver& receiver, int light) const {
    std::uint64_t way = ways_[std::size_t(light)];
    if (way == light_tree::kNowhere) return 0.0;
    std::uint32_t at = 0;
    double probability = 1.0;
    for (; nodes_[at].second && probability > 0.0; way >>= 1) {
        const double share = first_share(at, receiver);
        if (share < 0.0) return 0.0;
        const bool first = !(way & 1u);
        probability *= first ? share : 1.0 - share;
        at = first ? at + 1 : nodes_[at].second;
    }
    return probability;
}

}  // namespace dewbow
