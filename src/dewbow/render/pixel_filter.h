// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pixel filter, both ways: where samples of a pixel lie, and which pixels a point counts for.

#include <cmath>

#include "dewbow/math/distribution.h"
#include "dewbow/scene/camera.h"

namespace dewbow {

/// Offsets from a pixel's centre, in proportion to the pixel filter (separable, so one axis a
/// time).
class FilterSampler {
public:
    explicit FilterSampler(const PixelFilter& filter);
    /// An offset in pixels, in [−radius, radius].
    double sample(double u) const;
    /// Exactly the density of sample(), per pixel: its integral over all offsets is 1.
    double density(double offset) const;
    /// Half the width, in pixels.
    double radius() const { return radius_; }

    /// Calls `add(i, density)` for each pixel i of a line, with its centre at i + 0.5, that reaches
    /// the place `at`.
    template <class Add>
    void for_each_cell(double at, Add&& add) const {
        const int last = int(std::floor(at + radius_ - 0.5));
        for (int i = int(std::ceil(at - radius_ - 0.5)); i <= last; ++i)
            if (const double weight = density(at - (i + 0.5)); weight > 0.0) add(i, weight);
    }

private:
    double radius_;
    Distribution1D table_;
};

}  // namespace dewbow
