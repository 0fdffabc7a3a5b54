// SPDX-License-Identifier: Apache-2.0
#pragma once

// How many drops there are of each size.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// A distribution of drop radii, by number.
class DropSizes {
public:
    virtual ~DropSizes() = default;
    /// Number of drops per metre of radius, over the number of all: integrates to 1.
    virtual double density(Length radius) const = 0;
    /// Radii outside which less than 1e-6 of the cross section lies.
    virtual Length smallest() const = 0;
    virtual Length largest() const = 0;
    /// One size, and no other.
    virtual bool is_single() const { return false; }
    /// As parse_drop_sizes reads it.
    virtual std::string describe() const = 0;
};
using DropSizesPtr = std::shared_ptr<const DropSizes>;

/// A class of drops: `share` of the number of all drops has about this radius.
struct WeightedRadius {
    Length radius;
    double share = 0.0;
};

DropSizesPtr single_drop_size(Length radius);

}  // namespace dewbow
