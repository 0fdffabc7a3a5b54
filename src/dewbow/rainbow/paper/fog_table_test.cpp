// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/fog_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr Wavelength kSodium = 589.3 * nm;

double sum_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Root mean square of the relative error against `right`, in buckets that hold enough of it.
double rms_error(const std::vector<double>& values, const std::vector<double>& right) {
    double square = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < values.size(); ++k)
        if (right[k] > 5e-6) {
            square += std::pow(values[k] / right[k] - 1.0, 2);
            ++count;
        }
    return std::sqrt(square / count);
}

TEST(FogTable, ConvolutionKeepsTheSumAndMirrorsEnds) {
    constexpr double kBalance = 1e-12;
    std::vector<double> values(40);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::pow(0.7, double(k)) + 0.1;
    for (SunKernel kernel : {SunKernel::none, SunKernel::five_entries, SunKernel::disc}) {
        const auto smeared = convolve_mirrored(values, sun_kernel(kernel));
        EXPECT_NEAR(sum_of(smeared), sum_of(values), kBalance);
    }
    const std::vector<double> ends = {1.0, 0.0, 0.0, 0.0};
    const auto smeared = convolve_mirrored(ends, {0.1, 0.2, 0.4, 0.2, 0.1});
    EXPECT_NEAR(smeared[0], 0.4 + 0.2, kBalance);
    EXPECT_NEAR(smeared[1], 0.2 + 0.1, kBalance);
    EXPECT_NEAR(smeared[2], 0.1, kBalance);
}

TEST(FogTable, FiftyThousandEvenRaysAreNearTheLimit) {
    // Measured 1.1 % rms a bucket; random ones 11 %, which is 1 / √(rays in it).
    PaperMethod method;
    method.rays = 0;
    const auto limit = paper_intensities(method, kSodium);
    method.rays = 50'000;
    const auto even = paper_intensities(method, kSodium);
    method.random_rays = true;
    const auto random = paper_intensities(method, kSodium);
    EXPECT_LT(rms_error(even, limit), 0.02);
    EXPECT_NEAR(rms_error(random, limit), 0.12, 0.04);
    EXPECT_NEAR(sum_of(even) / sum_of(limit), 1.0, 1e-6);
}

TEST(FogTable, MoreRaysTendToTheLimitUnderEverySwitch) {
    PaperMethod method;
    method.density = RayDensity::even_over_disc;
    method.per_solid_angle = true;
    method.rays = 0;
    const auto limit = paper_intensities(method, kSodium);
    method.rays = 400'000;
    const auto rays = paper_intensities(method, kSodium);
    // Outside the buckets next to the antisolar point, which few rays reach.
    for (std::size_t k = 100; k < 1700; ++k)
        EXPECT_NEAR(rays[k], limit[k], 0.04 * limit[k] + 1e-6) << k;
}

TEST(FogTable, LeavesTheBandDarkAndTheRestBright) {
    const FogTable table = make_fog_table({});
    double greatest = 0.0;
    for (std::size_t k = 0; k < std::size_t(kPaperBuckets); ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            greatest = std::max(greatest, table.intensity[k][c]);
            const double t = table.transmittance[k][c];
            if (k >= 431 && k < 495) {  // between the bows there is no fog
                EXPECT_TRUE(std::isinf(t)) << k;
            } else if (k < 390 || (k > 560 && k < 1700)) {
                EXPECT_NEAR(t * table.intensity[k][c], 1.0, 1e-12) << k;
            }
        }
    EXPECT_EQ(greatest, 1.0);
}

TEST(FogTable, ColoursRunAsInTheSky) {
    const FogTable table = make_fog_table({});
    const auto at = [&](double r) { return table.intensity[std::size_t(r * 10.0)]; };
    EXPECT_GT(at(42.6)[0], 3.0 * at(42.6)[2]);  // the primary is red outside
    EXPECT_GT(at(40.9)[2], at(40.9)[1]);        // and violet inside
    EXPECT_GT(at(50.2)[0], 3.0 * at(50.2)[2]);  // the secondary is red inside
    EXPECT_GT(at(53.6)[2], at(53.6)[1]);
    for (double r : {20.0, 30.0, 80.0})  // elsewhere all colours overlap: white
        for (std::size_t c : {1u, 2u}) EXPECT_NEAR(at(r)[c] / at(r)[0], 1.0, 0.12) << r;
}

TEST(FogTable, RingsAreWiderInTheViolet) {
    // "More widely spaced … in the violet": the last two rings of the primary over the first two.
    constexpr double kTwoDigits = 0.05;
    const auto ratio = [](SpectralSpacing spacing) {
        const auto radius = [&](int k) {
            const Wavelength lambda = paper_wavelength((k + 0.5) / kPaperSamples, spacing);
            return descartes_ray(paper_index({}, lambda), 2).radius();
        };
        return (radius(11) - radius(12)) / (radius(0) - radius(1));
    };
    EXPECT_NEAR(ratio(SpectralSpacing::wavelength), 6.2, kTwoDigits);
    EXPECT_NEAR(ratio(SpectralSpacing::frequency), 1.8, kTwoDigits);
}

TEST(FogTable, JitteredWavelengthsMergeTheRings) {
    PaperMethod method;
    method.kernel = SunKernel::none;
    /// Turns of the blue channel by more than a tenth of its peak, in the violet of the secondary.
    const auto rings = [](const FogTable& table) {
        int turns = 0;
        double last = 0.0;
        int direction = 1;
        for (std::size_t k = 515; k < 545; ++k) {
            const double now = table.intensity[k][2];
            if ((now - last) * direction > 0.0) {
                last = now;
            } else if ((last - now) * direction > 0.01) {
                direction = -direction, last = now;
                ++turns;
            }
        }
        return turns;
    };
    const FogTable fixed = make_fog_table(method);
    method.jitter_wavelengths = true;
    const FogTable jittered = make_fog_table(method);
    EXPECT_GE(rings(fixed), 7);
    EXPECT_LE(rings(jittered), 4);
    // The same again, bit for bit; and another seed, another table.
    method.rays = 1'000;
    const auto few = make_fog_table(method).intensity;
    EXPECT_EQ(make_fog_table(method).intensity, few);
    method.seed = 1;
    EXPECT_NE(make_fog_table(method).intensity, few);
}

TEST(FogTable, EachSwitchActsOnItsOwn) {
    PaperMethod published;
    published.rays = 0;
    const PaperMethod corrected = paper_method_corrected();
    const auto table = make_fog_table(published).intensity;
    const auto differs = [&](auto field) {
        PaperMethod method = published;
        method.*field = corrected.*field;
        return make_fog_table(method).intensity != table;
    };
    EXPECT_TRUE(differs(&PaperMethod::density));
    EXPECT_TRUE(differs(&PaperMethod::per_solid_angle));
    EXPECT_TRUE(differs(&PaperMethod::water));
    EXPECT_TRUE(differs(&PaperMethod::divide_by_air));
    EXPECT_TRUE(differs(&PaperMethod::kernel));
    EXPECT_TRUE(differs(&PaperMethod::wavelengths));
    published.spacing = SpectralSpacing::wavelength;
    EXPECT_NE(make_fog_table(published).intensity, table);
}

TEST(FogTable, EndsWhereTheDescartesRayLeaves) {
    PaperMethod method = paper_method_corrected();
    for (double lambda : {420.0, 589.3, 680.0}) {
        const auto buckets = paper_intensities(method, lambda * nm);
        const Angle radius = descartes_ray(paper_index(method, lambda * nm), 2).radius();
        const auto last = std::size_t(std::floor(radius / kPaperBucket));
        EXPECT_GT(buckets[last], 0.0) << lambda;
        EXPECT_EQ(buckets[last + 1], 0.0) << lambda;
        EXPECT_GT(buckets[last - 1], 2.0 * buckets[last - 20]) << lambda;
    }
}

TEST(FogTable, RefusesNothingToTrace) {
    PaperMethod method;
    method.wavelengths = 0;
    EXPECT_THROW(make_fog_table(method), InputError);
    method.wavelengths = 13;
    method.rays = -1;
    EXPECT_THROW(make_fog_table(method), InputError);
    method.rays = 0;
    method.jitter_wavelengths = true;
    EXPECT_THROW(make_fog_table(method), InputError);
}

}  // namespace
}  // namespace dewbow
