// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/uneven_rain.h"

#include <algorithm>
#include <cmath>

namespace dewbow {

void dim_by_uneven_rain(const LineInterval& part, std::span<const double> extinction, double usual,
                        const std::function<double(double)>& density, RandomSteps& steps,
                        LaneValues& values) {
    const double most = *std::max_element(extinction.begin(), extinction.end());
    const double length = part.end - part.begin;
    if (!(most > 0.0) || !(length > 0.0)) return;
    for (std::size_t k = 0; k < extinction.size(); ++k)
        if (extinction[k] > 0.0) values.v[k] *= std::exp(-extinction[k] * usual * length);
    // Behind rain without end, or very dense rain, nothing is left.
    if (std::isinf(length)) return;
    if (std::all_of(values.v.begin(), values.v.begin() + std::ptrdiff_t(extinction.size()),
                    [](double value) { return value == 0.0; }))
        return;
    const double rate = most * std::max(usual, 1.0 - usual);
    double s = part.begin;
    for (;;) {
        s -= std::log1p(-steps.next()[0]) / rate;
        if (s >= part.end) return;
        const double more = (density(s) - usual) / rate;
        for (std::size_t k = 0; k < extinction.size(); ++k)
            values.v[k] *= std::max(0.0, 1.0 - extinction[k] * more);
    }
}

}  // namespace dewbow
