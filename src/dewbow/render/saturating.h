// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums that stop at their largest value instead of wrapping around. Of terms that are not negative
// the order does not matter, nor whether some are added up beforehand.

#include <cstdint>
#include <limits>

namespace dewbow {

inline void add_saturating(std::int64_t& sum, std::int64_t term) {
    if (__builtin_add_overflow(sum, term, &sum)) sum = std::numeric_limits<std::int64_t>::max();
}
inline void add_saturating(__int128& sum, __int128 term) {
    constexpr auto kMost = static_cast<__int128>(~static_cast<unsigned __int128>(0) >> 1);
    if (__builtin_add_overflow(sum, term, &sum)) sum = kMost;
}

}  // namespace dewbow
