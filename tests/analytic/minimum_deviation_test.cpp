// SPDX-License-Identifier: Apache-2.0

// A ray through a 60° prism, traced through the whole renderer, leaves in the direction of the
// closed form. The probe is light: cones of parallel light from the predicted direction, one inside
// the other, each of its own radiance. How much is seen says how near to its centre the path ends.

#include <gtest/gtest.h>

#include <optional>

#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

/// What the test asks for: a tenth of a pixel of the sharpest picture.
constexpr double kDirectionError_rad = 1e-6;
/// Half angles of the cones. The narrowest that is seen is what a test reports; below the last lies
/// the rounding of directions.
constexpr std::array<double, 5> kCones_rad{1e-3, kDirectionError_rad, 1e-9, 1e-12, 1e-14};
constexpr double kApex_rad = kPi / 3.0;
constexpr int kWavelengths = 10;
/// Paths that are tried until one goes through both faces: reflected ones see nothing. The worst
/// transmittance is that of n = 2 next to grazing incidence, about 0.2: missing 400 has a chance of
/// 1e-38.
constexpr int kTries = 400;

const Affine kAskew = translation({0.3, -0.2, 0.1}) * rotation(normalised({1, 2, 3}), 40.0 * deg);

double wavelength(int i) { return 365.0 + 460.0 * i / (kWavelengths - 1); }

/// Deviation at incidence i: i + asin(sin A √(n² − sin² i) − cos A sin i) − A.
std::optional<double> deviation(double incidence, double n) {
    const double s = std::sin(incidence);
    const double sin_out = std::sin(kApex_rad) * std::sqrt(n * n - s * s) - std::cos(kApex_rad) * s;
    if (!(sin_out < 1.0)) return std::nullopt;
    return incidence + std::asin(sin_out) - kApex_rad;
}
double minimum(double n) { return 2.0 * std::asin(n * std::sin(0.5 * kApex_rad)) - kApex_rad; }

enum class Kind { analytic, mesh };

/// Through a prism of `interior`, light of `lambda_nm` at `incidence`: the half angle of the
/// narrowest cone about the direction of `predicted_deviation` that it ends in, or nothing.
/// The wavelength is lane `lane` of a packet of `count`.
std::optional<double> seen_within(Kind kind, const MediumPtr& interior, double lambda_nm,
                                  double incidence, double predicted_deviation, int count,
                                  int lane) {
    Scene scene = make_empty_scene();
    // Two refractions alone. (Reflected inside, a 60° prism is a Dove prism, too: it sends all
    // wavelengths where minimum deviation sends one.)
    scene.render.max_depth = 2;
    scene.render.roulette_depth = 2;
    if (kind == Kind::analytic)
        add(scene, Prism{kApex_rad * unit::rad, 1.0 * m, 1.0 * m}, dielectric(interior), kAskew);
    else
        add(scene, prism_mesh(kApex_rad, 1.0, 1.0), dielectric(interior), kAskew);

    // The left face's inward normal points 30° below +x; light comes from below it and is bent
    // towards the base.
    const double in = incidence - 0.5 * kApex_rad, out = in - predicted_deviation;
    const Vec3 d_in = kAskew.apply_linear({std::cos(in), std::sin(in), 0.0});
    const Vec3 d_out = normalised(kAskew.apply_linear({std::cos(out), std::sin(out), 0.0}));
    const double face_x = -2.0 / 3.0 * std::cos(0.5 * kApex_rad) * std::tan(0.5 * kApex_rad);
    const Vec3 entry = kAskew.apply({face_x, 0.0, 0.05});
    for (std::size_t i = 0; i < kCones_rad.size(); ++i) {
        const Angle radius = kCones_rad[i] * unit::rad;
        const double solid_angle = 2.0 * kPi * one_minus_cos(radius);
        scene.lights.push_back(DistantLight{
            {-d_out}, radius, make_constant(std::pow(1000.0, double(i)) * solid_angle)});
    }
    const PreparedScene prepared(scene);
    const Ray ray{entry - d_in, normalised(d_in), {}};
    const WavelengthPacket packet = among_others(lambda_nm, count, lane);
    for (std::size_t i = 0; i < kTries; ++i) {
        const PixelSample sample = trace_sample(prepared, ray, {}, packet, independent_key(4, i));
        const double seen = sample.radiance[std::size_t(lane)];
        for (std::size_t cone = kCones_rad.size(); cone-- > 0;)
            if (seen > 0.03 * std::pow(1000.0, double(cone))) return kCones_rad[cone];
    }
    return std::nullopt;
}

struct Setup {
    Kind kind;
    int packet;
};
/// A part of the catalogue is enough: 1662 glasses would take minutes.
constexpr std::size_t kEveryGlass = 41;
constexpr double kLeastIndex = 1.2;  ///< gases bend by less than the cones

class MinimumDeviation : public ::testing::TestWithParam<Setup> {};

TEST_P(MinimumDeviation, IsThatOfTheClosedForm) {
    const auto [kind, packet] = GetParam();
    double worst = 0.0;
    int glasses = 0;
    for (std::size_t g = 0; g < glass_catalogue().size(); g += kEveryGlass) {
        const Glass& row = glass_catalogue()[g];
        const MediumPtr interior = medium(make_dispersion(row.data));
        const double violet = index_of(*interior, wavelength(0)) / 1.0002;
        if (violet >= 2.0 || violet < kLeastIndex) continue;
        ++glasses;
        for (int i = 0; i < kWavelengths; ++i) {
            const double lambda_nm = wavelength(i);
            const double n = index_of(*interior, lambda_nm) / (*air())(lambda_nm * unit::nm).value;
            const double incidence = std::asin(n * std::sin(0.5 * kApex_rad));
            const int lane = i % packet;
            const std::optional<double> error =
                seen_within(kind, interior, lambda_nm, incidence, minimum(n), packet, lane);
            ASSERT_TRUE(error) << row.name << " at " << lambda_nm << " nm";
            EXPECT_LE(*error, kDirectionError_rad) << row.name << " at " << lambda_nm << " nm";
            worst = std::max(worst, *error);
            for (const double aside : {-1.0, 1.0}) {
                const double there = incidence + aside * kPi / 180.0;
                if (!(there < 0.497 * kPi)) continue;
                const std::optional<double> predicted = deviation(there, n);
                if (!predicted) continue;  // all is reflected inside
                EXPECT_GT(*predicted, minimum(n) + 10.0 * kDirectionError_rad);
                const std::optional<double> aside_error =
                    seen_within(kind, interior, lambda_nm, there, *predicted, packet, lane);
                ASSERT_TRUE(aside_error) << row.name << " at " << lambda_nm << " nm, aside";
                EXPECT_LE(*aside_error, kDirectionError_rad);
                worst = std::max(worst, *aside_error);
            }
        }
    }
    EXPECT_GE(glasses, 20);
    RecordProperty("glasses", glasses);
    RecordProperty("worst_rad", std::to_string(worst * 1e9) + "e-9");
    std::printf("    %d glasses, all within %.0e rad\n", glasses, worst);
}

INSTANTIATE_TEST_SUITE_P(Prisms, MinimumDeviation,
                         ::testing::Values(Setup{Kind::analytic, 1}, Setup{Kind::analytic, 8},
                                           Setup{Kind::mesh, 1}, Setup{Kind::mesh, 8}),
                         [](const auto& each) {
                             return std::string(each.param.kind == Kind::mesh ? "Mesh"
                                                                              : "Analytic") +
                                    "Packet" + std::to_string(each.param.packet);
                         });

/// Planted: an index that is off by 3e-6, which turns the ray by about 1e-5 rad; and the neighbour
/// lane's wavelength.
TEST(MinimumDeviationProbe, SeesASmallError) {
    const MediumPtr flint = glass("schott/F2");
    const double lambda_nm = 587.5618;
    const double n = index_of(*flint, lambda_nm) / (*air())(lambda_nm * unit::nm).value;
    const double incidence = std::asin(n * std::sin(0.5 * kApex_rad));
    const auto error = seen_within(Kind::analytic, flint, lambda_nm, incidence,
                                   *deviation(incidence, n + 3e-6), 1, 0);
    ASSERT_TRUE(error);
    EXPECT_GT(*error, kDirectionError_rad);
    const auto wrong_lane =
        seen_within(Kind::analytic, flint, lambda_nm + 58.75, incidence, minimum(n), 8, 1);
    EXPECT_TRUE(!wrong_lane || *wrong_lane > kDirectionError_rad);
}

}  // namespace
}  // namespace dewbow
