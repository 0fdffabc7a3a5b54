// SPDX-License-Identifier: Apache-2.0
// How a 60 degree prism of N-BK7, in air, bends the Fraunhofer lines F, d and C.
#include <cstdio>

#include "dewbow/optics/catalogue.h"

int main() {
    using namespace dewbow;
    const DispersionPtr glass = make_dispersion(find_glass("N-BK7").data);
    for (const Wavelength line : {kLineF, kLined, kLineC}) {
        const RelativeIndex n = (*glass)(line) / (*air())(line);
        const Angle bend = *minimum_deviation(60.0 * unit::deg, n);
        std::printf("%.2f nm  n = %.5f  deviation %.3f deg\n", line.to(unit::nm), n.value,
                    bend.to(unit::deg));
    }
}
