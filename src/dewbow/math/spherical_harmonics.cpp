// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/spherical_harmonics.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/check.h"

namespace dewbow {

void legendre_harmonics(int degree, double mu, std::span<double> out) {
    DEWBOW_CHECK(out.size() == harmonic_count(degree), "one value for each (m, l)");
    const double sine = std::sqrt(std::max(0.0, (1.0 - mu) * (1.0 + mu)));
    double sectoral = 1.0;  // Λ_m^m
    for (int m = 0; m <= degree; ++m) {
        if (m > 0) sectoral *= sine * std::sqrt((2.0 * m - 1.0) / (2.0 * m));
        double* row = &out[harmonic_index(degree, m, m)];
        double before = 0.0, now = sectoral;
        for (int l = m; l <= degree; ++l) {
            row[l - m] = now;
            // √((l+1)² − m²) Λ_{l+1} = (2l + 1) μ Λ_l − √(l² − m²) Λ_{l−1}
            const double next = ((2.0 * l + 1.0) * mu * now -
                                 std::sqrt(static_cast<double>(l * l - m * m)) * before) /
                                std::sqrt(static_cast<double>((l + 1) * (l + 1) - m * m));
            before = now;
            now = next;
        }
    }
}

}  // namespace dewbow
