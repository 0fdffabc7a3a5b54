// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_claims.h"

#include <cmath>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/equivalents.h"
#include "dewbow/optics/paper_index.h"

namespace dewbow {

std::vector<IndexAndPower> indices_and_powers(std::string_view maker) {
    std::vector<IndexAndPower> media;
    for (const Glass& glass : glass_catalogue()) {
        if (!glass.name.starts_with(maker)) continue;
        const DispersionPtr dispersion = make_dispersion(glass.data);
        if (!disperses_in_air(dispersion)) continue;
        media.push_back({((*dispersion)(kLineD) / (*air())(kLineD)).value,
                         dispersive_power(index_in_air(dispersion))});
    }
    return media;
}

PowerAndDensity power_and_density(std::string_view maker) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    const std::vector<IndexAndPower> media = indices_and_powers(maker);
    for (const auto& [n_D, w] : media)
        x += n_D, y += w, xx += n_D * n_D, xy += n_D * w, yy += w * w;
    const double count = double(media.size());
    const double spread = (count * xx - x * x) * (count * yy - y * y);
    return {media.size(), spread > 0.0 ? (count * xy - x * y) / std::sqrt(spread) : 0.0};
}

}  // namespace dewbow
