// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/range.h"

#include <fmt/format.h>

#include <cmath>

namespace dewbow {

bool Range::contains(double value) const {
    return std::isfinite(value) && (low_open ? value > low : value >= low) &&
           (high_open ? value < high : value <= high);
}

std::string Range::text() const {
    if (!low_open && !high_open) return fmt::format("between {} and {}", low, high);
    return fmt::format("{} {} and {} {}", low_open ? "greater than" : "at least", low,
                       high_open ? "less than" : "at most", high);
}

}  // namespace dewbow
