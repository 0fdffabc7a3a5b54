// SPDX-License-Identifier: Apache-2.0
#pragma once

// How far light in rain is followed.

#include <string>

namespace dewbow {

/// Most times that `orders` may count.
inline constexpr int kMostRainOrders = 1000;

struct RainSettings {
    /// How often light may be scattered by drops on its way to the camera; kAllOrders: as often as
    /// paths are long. At 1 drops are lit by lights alone; above it by surfaces and other drops,
    /// too.
    int orders = 1;
    static constexpr int kAllOrders = 0;

    bool multiple() const { return orders != 1; }
    /// Whether a path that drops have scattered `times` times may be scattered once more, and still
    /// find light at a drop behind that.
    bool may_scatter_again(int times) const { return orders == kAllOrders || times + 1 < orders; }
};

/// All settings in one line: equal if and only if they are.
std::string text_of(const RainSettings& settings);

}  // namespace dewbow
