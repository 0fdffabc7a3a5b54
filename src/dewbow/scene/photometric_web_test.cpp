// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/photometric_web.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;  ///< relative: sums of at most some thousand doubles

std::vector<double> steps(double first, double last, int intervals) {
    std::vector<double> result;
    for (int i = 0; i <= intervals; ++i) result.push_back(first + (last - first) * i / intervals);
    return result;
}

/// Rows of `intensity(θ, φ)`, radians; the row of 360° repeats that of 0°.
PhotometricTable table_of(std::vector<double> vertical_deg, std::vector<double> horizontal_deg,
                          const std::function<double(double, double)>& intensity) {
    PhotometricTable table{std::move(vertical_deg), std::move(horizontal_deg), {}};
    for (double phi : table.horizontal_deg) {
        for (double theta : table.vertical_deg) {
            table.intensity_cd.push_back(
                intensity(theta * kPi / 180.0, std::fmod(phi, 360.0) * kPi / 180.0));
        }
    }
    return table;
}

PhotometricTable lambertian(int intervals) {
    return table_of(steps(0.0, 90.0, intervals), {0.0},
                    [](double theta, double) { return 100.0 * std::cos(theta); });
}

PhotometricTable uneven() {
    return table_of({0, 20, 50, 90, 135}, {0, 45, 100, 180, 330, 360}, [](double theta, double p) {
        return 10.0 + 5.0 * std::cos(theta) + 3.0 * std::sin(p) * std::sin(theta);
    });
}

TEST(PhotometricWeb, HasTheFluxOfAnIsotropicLamp) {
    const PhotometricWeb web(table_of({0, 180}, {0}, [](double, double) { return 2.0; }));
    EXPECT_NEAR(web.flux_lm() / (8.0 * kPi), 1.0, kRounding);  // 4π I
    EXPECT_NEAR(web.mean_intensity_cd(), 2.0, 2.0 * kRounding);
}

// I0 cos θ shines π I0. Chords lie below the cosine: with steps h the flux is low by h²/12, and
// another term of order h⁴.
TEST(PhotometricWeb, HasTheFluxOfALambertianLamp) {
    for (int intervals : {18, 90, 900}) {
        const double h = 0.5 * kPi / intervals;
        const PhotometricWeb web(lambertian(intervals));
        EXPECT_NEAR(web.flux_lm() / (100.0 * kPi), 1.0 - h * h / 12.0, h * h * h * h + kRounding);
        EXPECT_EQ(web.max_intensity_cd(), 100.0);
    }
}

// The flux of the bilinear table itself, by the midpoint rule with many steps in every cell.
TEST(PhotometricWeb, IntegratesItsOwnInterpolation) {
    const PhotometricWeb web(uneven());
    constexpr int kThetas = 135 * 8, kPhis = 360;  // cell borders are borders of the rule's too
    const double d_theta = 135.0 / kThetas * kPi / 180.0, d_phi = 2.0 * kPi / kPhis;
    double sum = 0.0;
    for (int t = 0; t < kThetas; ++t) {
        const double theta = (t + 0.5) * d_theta;
        for (int p = 0; p < kPhis; ++p) {
            sum += web.intensity_cd(theta, (p + 0.5) * d_phi) * std::sin(theta) * d_theta * d_phi;
        }
    }
    constexpr double kMidpointRule = 1e-5;  // d_theta² / 24 = 2e-7, times a few
    EXPECT_NEAR(web.flux_lm() / sum, 1.0, kMidpointRule);
}

TEST(PhotometricWeb, IsBilinearBetweenItsRows) {
    const PhotometricTable table = uneven();
    const PhotometricWeb web(table);
    const auto at = [&](double theta_deg, double phi_deg) {
        return web.intensity_cd(theta_deg * kPi / 180.0, phi_deg * kPi / 180.0);
    };
    const auto value = [&](std::size_t h, std::size_t v) { return table.intensity_cd[5 * h + v]; };
    EXPECT_NEAR(at(20, 45), value(1, 1), 1e-12);
    EXPECT_NEAR(at(50, 330), value(4, 2), 1e-12);
    // A quarter of the way from 50 to 90 deg, and 2/11 of that from 45 to 100 deg.
    const double near = 0.75 * value(1, 2) + 0.25 * value(1, 3);
    const double far = 0.75 * value(2, 2) + 0.25 * value(2, 3);
    EXPECT_NEAR(at(60, 55), near * 9.0 / 11.0 + far * 2.0 / 11.0, 1e-12);
    EXPECT_NEAR(at(60, 55 - 360), at(60, 55), 1e-12);
    EXPECT_NEAR(at(60, 55 + 720), at(60, 55), 1e-12);
    EXPECT_EQ(at(140, 55), 0.0) << "beyond the last vertical angle";
}

TEST(PhotometricWeb, KnowsDownFromUpAndItsHorizontalAngles) {
    // Bright by quadrant: φ = 0 bright 1, 90 2, 180 3, 270 4; nadir and zenith told apart by θ.
    const PhotometricWeb web(table_of({0, 90, 180}, {0, 90, 180, 270, 360}, [](double t, double p) {
        return t == 0.0 ? 10.0 : t > 3.0 ? 20.0 : 1.0 + std::round(p / (0.5 * kPi));
    }));
    const auto towards = [&](double x, double y, double z) {
        return web.intensity_cd(Dir<Object>{{x, y, z}});
    };
    EXPECT_NEAR(towards(0, -1, 0), 10.0, kRounding) << "nadir";
    EXPECT_NEAR(towards(0, 1, 0), 20.0, kRounding * 20) << "zenith";
    EXPECT_NEAR(towards(1, 0, 0), 1.0, 1e-12);
    EXPECT_NEAR(towards(0, 0, -1), 2.0, 1e-12);
    EXPECT_NEAR(towards(-1, 0, 0), 3.0, 1e-12);
    EXPECT_NEAR(towards(0, 0, 1), 4.0, 1e-12);
}

TEST(PhotometricWeb, RefusesWhatIsNoWeb) {
    struct Row {
        PhotometricTable table;
        const char* says;
    };
    const double nan = std::nan("");
    const std::vector<Row> rows{
        {{{0}, {0}, {1}}, "at least two vertical angles"},
        {{{0, 90}, {}, {}}, "horizontal angles must be"},
        {{{0, 90}, {0, 180}, {1, 1, 1, 1}}, "0 to 360"},
        {{{0, 200}, {0}, {1, 1}}, "between 0 and 180"},
        {{{0, nan}, {0}, {1, 1}}, "vertical angle 1 is nan"},
        {{{90, 0}, {0}, {1, 1}}, "0 after 90"},
        {{{0, 90}, {0}, {1}}, "has 1 intensities; its angles make 2"},
        {{{0, 90}, {0}, {1, -1}}, "-1"},
        {{{0, 90}, {0}, {1, nan}}, "nan"},
        {{{0, 90}, {0}, {0, 0}}, "all zero"},
        {{{0, 90}, {0, 360}, {1, 1, 1, 2}}, "must be the same"},
        {{{0, 90}, {0}, {1e308, 1e308}}, "too large"},
    };
    for (const Row& row : rows) {
        try {
            const PhotometricWeb web(row.table);
            ADD_FAILURE() << "took a table that must say \"" << row.says << '"';
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(row.says), std::string::npos) << error.what();
        }
    }
}

}  // namespace
}  // namespace dewbow
