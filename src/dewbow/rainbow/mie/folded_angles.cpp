// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/folded_angles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewbow {
namespace {

/// π − the double next to it.
constexpr double kPiRest = 1.2246467991473532e-16;
constexpr double kSameAngle = 1e-15;

bool is_nearer(const FoldedAngle& a, const FoldedAngle& b) { return a.from_axis < b.from_axis; }

}  // namespace

double FoldedAngle::off_axis() const {
    const double s = std::sin(0.5 * from_axis);
    return 2.0 * s * s;
}

std::vector<FoldedAngle> fold_angles(std::span<const Angle> theta) {
    std::vector<FoldedAngle> forward, backward;
    for (std::size_t i = 0; i < theta.size(); ++i) {
        const double angle = theta[i].to(unit::rad);
        if (angle <= 0.5 * std::numbers::pi)
            forward.push_back({angle, int(i), -1});
        else
            backward.push_back({std::numbers::pi - angle + kPiRest, -1, int(i)});
    }
    std::reverse(backward.begin(), backward.end());
    for (auto* side : {&forward, &backward})
        if (!std::is_sorted(side->begin(), side->end(), is_nearer))
            std::sort(side->begin(), side->end(), is_nearer);
    std::vector<FoldedAngle> pairs, single_forward, single_backward;
    auto f = forward.begin(), b = backward.begin();
    while (f != forward.end() && b != backward.end())
        if (std::abs(f->from_axis - b->from_axis) <= kSameAngle)
            pairs.push_back({f->from_axis, f++->forward, b++->backward});
        else if (is_nearer(*f, *b))
            single_forward.push_back(*f++);
        else
            single_backward.push_back(*b++);
    for (auto [first, last] :
         {std::pair(single_forward.begin(), single_forward.end()), std::pair(f, forward.end()),
          std::pair(single_backward.begin(), single_backward.end()), std::pair(b, backward.end())})
        pairs.insert(pairs.end(), first, last);
    return pairs;
}

}  // namespace dewbow
