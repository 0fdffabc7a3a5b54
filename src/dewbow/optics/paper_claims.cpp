// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_claims.h"

#include <cmath>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"
#include "dewbow/optics/paper_index.h"

namespace dewbow {
PowerAndDensity power_and_density(std::string_view maker) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    PowerAndDensity result;
    for (const Glass& glass : glass_catalogue()) {
        if (!glass.name.starts_with(maker)) continue;
        const DispersionPtr dispersion = make_dispersion(glass.data);
        if (!disperses_in_air(dispersion)) continue;
        const double n_D = ((*dispersion)(kLineD) / (*air())(kLineD)).value;
        const double w = dispersive_power(index_in_air(dispersion));
        x += n_D, y += w, xx += n_D * n_D, xy += n_D * w, yy += w * w;
        ++result.glasses;
    }
    const double count = double(result.glasses);
    const double spread = (count * xx - x * x) * (count * yy - y * y);
    if (spread > 0.0) result.correlation = (count * xy - x * y) / std::sqrt(spread);
    return result;
}

}  // namespace dewbow
