// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/base/random.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// A straight way that light goes, and what its random numbers are drawn for.
struct Way {
    Vec3 origin, direction;  ///< unit
    double length;           ///< m; infinite to what is infinitely far
    std::uint32_t at;        ///< the vertex, of SampleKey
    Purpose purpose;
    /// Whether one looks at what lies infinitely far, and it is not light that falls on something:
    /// rain without end hides the one and does not dim the other (docs/conventions.md).
    bool seen = false;
};

}  // namespace dewbow
