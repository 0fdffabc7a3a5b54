// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace dewbow {

/// Numbers that a key takes, ends included unless open. Nothing takes infinities or NaN.
struct Range {
    double low, high;
    bool low_open = false, high_open = false;

    bool contains(double value) const;
    /// "between 0 and 1", "greater than 0 and at most 5"
    std::string text() const;
};

/// Larger than anything that a scene means, small enough that squares and products stay finite.
inline constexpr double kHuge = 1e12;
inline constexpr Range kShareRange{0.0, 1.0};
inline constexpr Range kAmountRange{0.0, kHuge};
inline constexpr Range kCoordinateRange{-kHuge, kHuge};

}  // namespace dewbow
