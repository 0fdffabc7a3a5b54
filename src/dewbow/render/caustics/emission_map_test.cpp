// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/emission_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

constexpr double kPi = std::numbers::pi;
/// places() computes again by inverses what ray() computed: some hundred roundings, made larger
/// where a lamp looks at a box nearly along its face.
constexpr double kRounding = 1e-7;

std::array<double, 4> numbers(int i, std::uint32_t which = 0) {
    const SampleKey key(stream_key(11, which, 0), std::uint32_t(i));
    const auto a = key.two(0, Purpose::test);
    return {a[0], a[1], key.third(0, Purpose::test), key.fourth(0, Purpose::test)};
}

/// Each ray finds back the numbers that gave it, with their density, and they give it again.
TEST(EmissionMap, PlacesInvertRays) {
    for (const LitScene& lit : all_lamps()) {
        const Ready ready(lit.scene);
        for (int m = 0; m < ready.maps.size(); ++m) {
            const EmissionMap& map = ready.maps[m];
            int found = 0;
            for (int i = 0; i < 2000; ++i) {
                const auto u = numbers(i);
                const auto ray = map.ray(u);
                if (!ray) continue;
                ++found;
                std::array<EmissionMap::Place, EmissionMap::kMostPlaces> places;
                const int count = map.places(ray->ray, places);
                double nearest = 1.0, pdf = 0.0;
                for (int p = 0; p < count; ++p) {
                    const EmissionMap::Place& place = places[std::size_t(p)];
                    double apart = 0.0;
                    for (std::size_t k = 0; k < std::size_t(map.dimensions()); ++k)
                        apart = std::max(apart, std::abs(place.u[k] - u[k]));
                    if (apart < nearest) nearest = apart, pdf = place.pdf;
                    const auto again = map.ray(place.u);
                    ASSERT_TRUE(again) << lit.name << " " << i;
                    EXPECT_NEAR(length(again->ray.direction - ray->ray.direction), 0.0, kRounding)
                        << lit.name << " " << i;
                    EXPECT_NEAR(again->pdf / place.pdf, 1.0, kRounding) << lit.name << " " << i;
                }
                ASSERT_LT(nearest, kRounding) << lit.name << " " << i << " of " << count;
                ASSERT_NEAR(pdf / ray->pdf, 1.0, kRounding) << lit.name << " " << i;
            }
            EXPECT_GT(found, 100) << lit.name;
        }
    }
}

}  // namespace
}  // namespace dewbow::caustics
