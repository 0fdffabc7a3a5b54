// SPDX-License-Identifier: Apache-2.0
#pragma once

// What building a light tree and asking it agree on.

#include <cstdint>

namespace dewbow::light_tree {

/// The way to a light that is not in the tree.
inline constexpr std::uint64_t kNowhere = ~std::uint64_t{0};
/// From this depth on nodes are halved by count, so that no way is longer than 40 + 24 bits.
inline constexpr int kDeepest = 39;
inline constexpr int kMostLights = 1 << 24;
/// Bounds on angles are this much wider than they need be, in rad: single precision keeps a cosine
/// near 1 to 6e-8, and with it the angle to 3.5e-4.
inline constexpr double kRim = 1e-3;

}  // namespace dewbow::light_tree
