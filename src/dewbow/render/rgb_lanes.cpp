// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/rgb_lanes.h"

#include <algorithm>

#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

enum Basis { white, cyan, magenta, yellow, red, green, blue };

template <class Make>
RgbBasis make_basis(Make&& make) {
    constexpr std::array<std::array<double, 3>, 7> colours{
        {{1, 1, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    RgbBasis basis;
    for (std::size_t i = 0; i < basis.size(); ++i) basis[i] = make(Colour<LinearSrgb>{colours[i]});
    return basis;
}

}  // namespace

const RgbBasis& light_basis() {
    static const RgbBasis basis = make_basis(make_emission);
    return basis;
}

const RgbBasis& reflectance_basis() {
    static const RgbBasis basis = make_basis(make_reflectance);
    return basis;
}

void RgbLanes::eval(Colour<LinearSrgb> rgb, const LaneSet& lanes, LaneValues& out) {
    if (!ready_) {
        for (std::size_t i = 0; i < basis_.size(); ++i)
            basis_[i]->eval_lanes(packet_->lambdas(), values_[i].first(packet_->count));
        ready_ = true;
    }
    // The least channel is white; of the rest, the lesser two make a secondary colour; what is left
    // over is a primary.
    constexpr std::array<int, 3> secondary_without{cyan, magenta, yellow};
    constexpr std::array<int, 3> primary{red, green, blue};
    const std::array<double, 3>& c = rgb.v;
    const std::size_t least = std::size_t(std::min_element(c.begin(), c.end()) - c.begin());
    const std::size_t most = std::size_t(std::max_element(c.begin(), c.end()) - c.begin());
    const std::size_t middle = least == most ? least : 3 - least - most;
    const LaneValues& a = values_[white];
    const LaneValues& b = values_[std::size_t(secondary_without[least])];
    const LaneValues& p = values_[std::size_t(primary[most])];
    for (int k = 0; k < lanes.count; ++k) {
        const int id = lanes.id[std::size_t(k)];
        out[k] = c[least] * a[id] + (c[middle] - c[least]) * b[id] + (c[most] - c[middle]) * p[id];
    }
}

}  // namespace dewbow
