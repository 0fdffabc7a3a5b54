// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/composition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/airy.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/geometric_rays.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;
constexpr RelativeIndex kWater{1.333};
const std::vector<double> kSizes = {900.0, 950.0, 1000.0, 1050.0, 1100.0};
const std::vector<double> kShares = {0.1, 0.2, 0.4, 0.2, 0.1};

std::vector<Angle> angles(double from, double to, double step) {
    std::vector<Angle> result;
    for (double theta = from; theta <= to; theta += step) result.push_back(theta * deg);
    return result;
}

TEST(FringeAverage, IsTheSumOverDrops) {
    /// Of the local mean over fringes.
    constexpr double kError = 1e-3;
    const FringeAverage average(kSizes, kShares);
    const FringeAverage larger = average.rescaled(1.5);
    for (const auto& [drops, ratio] : {std::pair{&average, 1.0}, std::pair{&larger, 1.5}})
        for (double z = -0.03; z < 0.4; z += 0.0037) {
            double G = 0.0, H = 0.0, square = 0.0;
            for (std::size_t k = 0; k < kSizes.size(); ++k) {
                const double x = ratio * kSizes[k];
                const AiryPair ai = airy(-z * std::pow(x, 2.0 / 3.0));
                G += kShares[k] * std::pow(x, 7.0 / 3.0) * ai.value * ai.value;
                H += kShares[k] * std::pow(x, 5.0 / 3.0) * ai.derivative * ai.derivative;
                square += kShares[k] * x * x;
            }
            const double root = std::sqrt(std::max(std::abs(z), 0.01));
            EXPECT_NEAR(drops->at(z).G, G, kError * square / (2.0 * kPi * root)) << z;
            EXPECT_NEAR(drops->at(z).H, H, kError * square * root / (2.0 * kPi)) << z;
        }
}

TEST(DiffractionAverage, IsTheSumOverDrops) {
    constexpr double kError = 2e-3;
    const DiffractionAverage average(kSizes, kShares);
    for (const double s : {0.0, 1e-4, 1e-3, 5e-3, 0.02}) {
        double sum = 0.0;
        for (std::size_t k = 0; k < kSizes.size(); ++k) {
            const double u = kSizes[k] * s;
            const double part = u == 0.0 ? 0.5 : std::cyl_bessel_j(1.0, u) / u;
            sum += kShares[k] * std::pow(kSizes[k], 4.0) * part * part;
        }
        EXPECT_NEAR(average.at(s).diffracted, sum, kError * sum) << s;
    }
}

TEST(OrderPattern, IsUniformAirysBow) {
    // Of orders 2 and 3 light comes to an angle once, and phases do not count.
    /// Of the largest: cubics between nodes, and terms in 1/x that the pattern leaves out.
    constexpr double kError = 0.02;
    std::vector<Drop> drops;
    for (const double x : kSizes) drops.push_back({x, {}});
    for (const int p : {2, 3}) {
        const std::vector<Angle> at = angles(5.0, 175.0, 0.5);
        std::vector<Intensities> ours(at.size()), theirs(drops.size() * at.size());
        OrderPattern(kWater, p).at(at, {}).add(FringeAverage(kSizes, kShares), ours);
        ModelOptions options;
        options.orders = {p};
        make_scattering_model("uniform_airy", options)->intensities(kWater, drops, at, theirs);
        std::vector<double> sum(at.size(), 0.0);
        for (std::size_t d = 0; d < drops.size(); ++d)
            for (std::size_t a = 0; a < at.size(); ++a)
                sum[a] += kShares[d] * theirs[d * at.size() + a].perpendicular;
        const double most = *std::max_element(sum.begin(), sum.end());
        for (std::size_t a = 0; a < at.size(); ++a)
            EXPECT_NEAR(ours[a].perpendicular, sum[a], kError * most)
                << p << " at " << at[a].to(deg);
    }
}

TEST(OrderPattern, CarriesTheFluxOfItsRays) {
    /// Of the order's flux: waves of the dark side and beyond the grazing ray move it about.
    constexpr double kFlux = 0.01;
    const std::vector<Angle> at = angles(0.0, 180.0, 0.02);
    for (const int p : {2, 3, 4}) {
        std::vector<Intensities> light(at.size());
        OrderPattern(kWater, p).at(at, {}).add(FringeAverage(kSizes, kShares), light);
        double sum = 0.0, square = 0.0;
        for (std::size_t a = 1; a < at.size(); ++a)
            sum += 0.5 * (light[a].unpolarised() + light[a - 1].unpolarised()) *
                   (cos(at[a - 1]) - cos(at[a]));
        for (std::size_t k = 0; k < kSizes.size(); ++k)
            square += kShares[k] * kSizes[k] * kSizes[k];
        const double flux = order_flux(kWater, p).flux.unpolarised();
        EXPECT_NEAR(2.0 * sum / square, flux, kFlux * flux) << p;
    }
}

TEST(OrderPattern, KeepsItsFluxWhereverItIsTurned) {
    /// Fringes within the steps of the angles. Without the change of solid angle 3° cost 9 %.
    constexpr double kSteps = 2e-3;
    const std::vector<Angle> at = angles(0.0, 180.0, 0.02);
    for (int p : {2, 3}) {
        const auto flux = [&](Angle shift) {
            std::vector<Intensities> light(at.size());
            OrderPattern(kWater, p).at(at, shift).add(FringeAverage(kSizes, kShares), light);
            double sum = 0.0;
            for (std::size_t a = 0; a < at.size(); ++a) sum += light[a].unpolarised() * sin(at[a]);
            return sum;
        };
        const double round = flux({});
        for (double shift_deg : {-3.0, 1.0, 3.0})
            EXPECT_NEAR(flux(shift_deg * deg) / round, 1.0, kSteps) << p << ' ' << shift_deg;
    }
}

TEST(Composition, OfAllOrdersIsTheSumOfThem) {
    constexpr double kRounding = 1e-12;
    const DropAverages drops(kSizes, kShares);
    const std::vector<Angle> at = angles(91.0, 179.0, 1.0);  // no diffraction
    std::vector<Intensities> all(at.size()), sum(at.size());
    Composition(kWater, {}).add(drops, {}, at, all);
    for (int p = 0; p <= kHighestOrder; ++p) Composition(kWater, {p}).add(drops, {}, at, sum);
    for (std::size_t a = 0; a < at.size(); ++a)
        EXPECT_NEAR(all[a].parallel, sum[a].parallel, kRounding * all[a].parallel);
}

TEST(Composition, OrdersZeroAndOneAreRays) {
    constexpr double kRounding = 1e-9;
    const DropAverages drops(kSizes, kShares);
    for (const int p : {0, 1}) {
        const std::vector<Angle> at = angles(0.5, 179.5, 1.0);
        std::vector<Intensities> light(at.size());
        Composition(kWater, {p}).add(drops, {}, at, light);
        for (std::size_t a = 0; a < at.size(); ++a) {
            const double ray =
                drops.fringes.mean_square() * geometric_intensity(kWater, p, at[a]).perpendicular;
            EXPECT_NEAR(light[a].perpendicular, ray, kRounding * ray);
        }
    }
}

TEST(CompositionFamily, GivesWhatEachIndexGives) {
    constexpr double kError = 2e-4;
    const DropAverages drops(kSizes, kShares);
    const CompositionFamily family({1.330}, {1.345}, {});
    const std::vector<Angle> at = angles(1.0, 179.0, 0.5);
    for (const double n : {1.3305, 1.336, 1.3447}) {
        std::vector<Intensities> one(at.size()), blended(at.size()), projected(at.size());
        Composition({n}, {}).add(drops, {}, at, one);
        family.at({n}).add(drops, {}, at, blended);
        family.at({n}).at(at).add(drops, projected);
        double peak = 0.0;
        for (std::size_t a = 0; a < at.size(); ++a)
            if (at[a] > 130.0 * deg) peak = std::max(peak, one[a].perpendicular);
        for (std::size_t a = 0; a < at.size(); ++a) {
            const double scale = std::max(peak, one[a].perpendicular);
            EXPECT_NEAR(blended[a].perpendicular, one[a].perpendicular, kError * scale)
                << n << " at " << at[a].to(deg);
            EXPECT_NEAR(projected[a].parallel, blended[a].parallel, 1e-12 * scale);
        }
    }
}

}  // namespace
}  // namespace dewbow
