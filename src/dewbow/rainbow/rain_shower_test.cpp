// SPDX-License-Identifier: Apache-2.0

// A. B. Fraser, "Why can the supernumerary bows be seen in a rain shower?", J. Opt. Soc. Am. 73,
// 1626 (1983): the bow of small drops lies far inside by interference, that of large ones by their
// flatness; between them, at radii of about 0.25 mm, there is a least angle at which the bows of
// many sizes fall together, with their supernumeraries. At the top of the arc, and nowhere else.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/drop_shape.h"
#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {
namespace {

using namespace unit;

const RelativeIndex kIndex{1.334};
constexpr Wavelength kGreen = 550.0 * nm;

/// Of Airy's main maximum, moved by the drop's shape.
double brightest_deg(Length radius, const BowPlace& place) {
    constexpr double kFirstMaximum = 1.018793;  // zero of Ai'
    const DescartesRay bow = descartes_ray(kIndex, 2);
    const double x = 2.0 * std::numbers::pi * radius.to(m) / (1e-9 * kGreen.to(nm));
    const Angle inside = kFirstMaximum * std::cbrt(bow.airy_constant / (x * x)) * rad;
    const BowShifts shifts = bow_shifts(kIndex, {raindrop_axis_ratio(radius)}, place);
    return (bow.scattering_angle + inside + shifts[2]).to(deg);
}

TEST(RainShower, HasItsLeastAngleAtAQuarterOfAMillimetre) {
    Length least = 0.05 * mm;
    for (Length r = 0.05 * mm; r < 1.0 * mm; r += 0.005 * mm)
        if (brightest_deg(r, {}) < brightest_deg(least, {})) least = r;
    EXPECT_NEAR(least.to(mm), 0.25, 0.03);
    // At the foot of the arc the largest drops have it.
    const BowPlace foot{{}, 90.0 * deg};
    EXPECT_LT(brightest_deg(0.9 * mm, foot), brightest_deg(0.25 * mm, foot));
}

/// Phase function of green light in rain of 5 mm/h, every 0.05° from 138°.
std::vector<double> bow(std::optional<FallingShape> falling) {
    TableRequest request;
    request.sizes = parse_drop_sizes("rain:marshall-palmer,rate=5mm/h");
    const DispersionPtr water =
        make_dispersion({"constant", {kIndex.value}, IndexReference::vacuum});
    request.optics = {water, vacuum(), 0.0};
    request.wavelengths = {kGreen};
    for (double d = 138.0; d <= 142.0; d += 0.05) request.angles.push_back(d * deg);
    request.falling = falling;
    const ScatteringTable table = make_scattering_table(request);
    std::vector<double> values;
    for (std::size_t a = 0; a < request.angles.size(); ++a)
        values.push_back(table.at(a, 0).unpolarised());
    return values;
}

/// Places of maxima that stand out from the minimum before them by 2 %.
std::vector<double> maxima_deg(const std::vector<double>& values) {
    constexpr double kVisible = 1.02;
    std::vector<double> maxima;
    double least = values.front();
    for (std::size_t i = 1; i + 1 < values.size(); ++i) {
        least = std::min(least, values[i]);
        if (values[i] > values[i - 1] && values[i] >= values[i + 1] &&
            values[i] > kVisible * least) {
            maxima.push_back(138.0 + 0.05 * double(i));
            least = values[i];
        }
    }
    return maxima;
}

TEST(RainShower, ShowsSupernumerariesAtTheTopOfTheArcOnly) {
    EXPECT_EQ(maxima_deg(bow(std::nullopt)).size(), 1u);
    EXPECT_EQ(maxima_deg(bow(FallingShape{{}, {{}, 90.0 * deg}})).size(), 1u);
    const std::vector<double> top = maxima_deg(bow(FallingShape{{}, {}}));
    ASSERT_GE(top.size(), 3u);
    // Spacings of "about 0.7°" [old.atoptics.co.uk, supernumeraries at a bow's top]; the first,
    // from the bow itself, is Airy's of 0.25 mm drops, (3.248 − 1.019) (h/x²)^{1/3} = 1.09°.
    EXPECT_NEAR(top[1] - top[0], 1.0, 0.15);
    EXPECT_NEAR(top[2] - top[1], 0.7, 0.1);
    // The bow lies inside the least angle, by no more than the sun's disc and other sizes blur it.
    EXPECT_GT(top[0], brightest_deg(0.25 * mm, {}));
    EXPECT_LT(top[0], brightest_deg(0.25 * mm, {}) + kSunRadius.to(deg));
}

}  // namespace
}  // namespace dewbow
