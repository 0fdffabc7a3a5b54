// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/bow_passages.h"

#include <cmath>
#include <numbers>

namespace dewbow {

bool is_central(const BowGeometry& bow, double deviation) {
    return deviation >= bow.grazing() && deviation > bow.most - 0.5 * std::numbers::pi;
}

double focus(const BowGeometry& bow, double deviation, double theta) {
    const double to_centre = bow.most - deviation;
    if (is_central(bow, deviation))
        return to_centre == 0.0 ? 1.0 : to_centre / std::abs(std::sin(to_centre));
    return (deviation < bow.grazing() ? 1.0 : to_centre) / std::sin(theta);
}

}  // namespace dewbow
