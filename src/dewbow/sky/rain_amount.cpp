// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/rain_amount.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

struct FallRow {
    double diameter_mm, metres_per_second;
};
constexpr std::array<FallRow, 33> kFall = {{
    {0.1, 0.27}, {0.2, 0.72}, {0.3, 1.17}, {0.4, 1.62}, {0.5, 2.06}, {0.6, 2.47}, {0.7, 2.87},
    {0.8, 3.27}, {0.9, 3.67}, {1.0, 4.03}, {1.2, 4.64}, {1.4, 5.17}, {1.6, 5.65}, {1.8, 6.09},
    {2.0, 6.49}, {2.2, 6.90}, {2.4, 7.27}, {2.6, 7.57}, {2.8, 7.82}, {3.0, 8.06}, {3.2, 8.26},
    {3.4, 8.44}, {3.6, 8.60}, {3.8, 8.72}, {4.0, 8.83}, {4.2, 8.92}, {4.4, 8.98}, {4.6, 9.03},
    {4.8, 9.07}, {5.0, 9.09}, {5.2, 9.12}, {5.4, 9.14}, {5.8, 9.17},
}};

/// mm/h of water that falls at 1 m/s with 1 m³ in a cubic metre.
constexpr double kMmPerHour = 1e3 * 3600.0;

/// Geometric cross section of a drop on average, m².
double section(const DropSizes& sizes) { return mean_cross_section(sizes).to(m * m); }

/// Mean over showers of what a drop has, over its cross section.
template <class Quantity>
double per_section(std::span<const DropSizesPtr> showers, Quantity quantity) {
    double sum = 0.0;
    for (const DropSizesPtr& sizes : showers) sum += quantity(*sizes) / section(*sizes);
    return sum / static_cast<double>(showers.size());
}

void check_positive(double value, const char* what) {
    if (value > 0.0 && std::isfinite(value)) return;
    throw InputError(fmt::format("{} of {:.6g}; expected above 0", what, value));
}

}  // namespace

double fall_speed(Length radius) {
    const double diameter = 2.0 * radius.to(mm);
    const FallRow &first = kFall.front(), &last = kFall.back();
    if (diameter <= first.diameter_mm) {
        const double ratio = diameter / first.diameter_mm;
        return first.metres_per_second * ratio * ratio;
    }
    if (diameter >= last.diameter_mm) return last.metres_per_second;
    const auto above = std::find_if(kFall.begin(), kFall.end(),
                                    [&](const FallRow& row) { return row.diameter_mm > diameter; });
    const FallRow &high = *above, &low = *(above - 1);
    const double share = (diameter - low.diameter_mm) / (high.diameter_mm - low.diameter_mm);
    return low.metres_per_second + share * (high.metres_per_second - low.metres_per_second);
}

double mean_rain_flux(const DropSizes& sizes) {
    const auto flux = [](Length r) {
        const double metres = r.to(m);
        return 4.0 / 3.0 * std::numbers::pi * metres * metres * metres * fall_speed(r);
    };
    if (sizes.is_single()) return flux(sizes.largest());
    // Midpoints in ln r: the integrand is smooth, and small at both ends.
    constexpr int kSteps = 4000;
    const double from = std::log(sizes.smallest().to(m));
    const double step = (std::log(sizes.largest().to(m)) - from) / kSteps;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const Length r = std::exp(from + (i + 0.5) * step) * m;
        sum += step * r.to(m) * sizes.density(r) * flux(r);
    }
    return sum;
}

double number_per_cross_section(std::span<const DropSizesPtr> showers) {
    return per_section(showers, [](const DropSizes&) { return 1.0; });
}

double water_per_cross_section(std::span<const DropSizesPtr> showers) {
    return per_section(showers, [](const DropSizes& sizes) {
        return 4.0 / 3.0 * std::numbers::pi * sizes.mean_power(3.0);
    });
}

double rain_rate_per_cross_section(std::span<const DropSizesPtr> showers) {
    return kMmPerHour * per_section(showers, mean_rain_flux);
}

double cross_section_per_volume(const RainAmount& amount, std::span<const DropSizesPtr> showers,
                                double efficiency) {
    if (const auto* number = std::get_if<DropsPerVolume>(&amount)) {
        check_positive(number->per_m3, "drops per cubic metre");
        return number->per_m3 / number_per_cross_section(showers);
    }
    if (const auto* rate = std::get_if<RainRate>(&amount)) {
        check_positive(rate->mm_per_hour, "a rain rate in mm/h");
        return rate->mm_per_hour / rain_rate_per_cross_section(showers);
    }
    const double per_m = std::get<RainExtinction>(amount).per_m;
    check_positive(per_m, "an extinction per metre");
    return per_m / efficiency;
}

}  // namespace dewbow
