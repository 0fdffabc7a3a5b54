// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/fog.h"

#include <cmath>

namespace dewbow {

double fog_replacement(InverseLength h, Length d, double t) {
    return std::isinf(t) ? 0.0 : -std::expm1(-h * d / t);
}

double fog_replacement_as_printed(InverseLength h, Length d, double t) {
    return std::exp(h * d / t);
}

}  // namespace dewbow
