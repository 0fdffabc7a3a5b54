// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/debye_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/math/quadrature.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/mie/angular_sum.h"
#include "dewbow/rainbow/mie/partial_waves.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
constexpr RelativeIndex kWater{1.333};

std::vector<std::vector<std::string>> reference_rows(const std::string& name,
                                                     std::string_view header) {
    return rows_of_csv(read_file(DEWBOW_SOURCE_DIR "/tests/reference/" + name), header);
}

Amplitudes amplitudes_at(const PartialWaves& waves, Angle theta) {
    Amplitudes result;
    angular_sum({&waves, 1}, {&theta, 1}, {&result, 1});
    return result;
}

/// Largest |a_n − a_n'| or |b_n − b_n'|; NaN if one is.
double distance(const PartialWaves& u, const PartialWaves& v) {
    double largest = 0.0;
    const auto add = [&](double d) { largest = d <= largest ? largest : d; };
    for (std::size_t i = 0; i < u.a.size(); ++i) {
        add(std::abs(u.a[i] - v.a[i]));
        add(std::abs(u.b[i] - v.b[i]));
    }
    return largest;
}

PartialWaves sum(const PartialWaves& u, const PartialWaves& v) {
    PartialWaves result = u;
    for (std::size_t i = 0; i < u.a.size(); ++i) {
        result.a[i] += v.a[i];
        result.b[i] += v.b[i];
    }
    return result;
}

PartialWaves sum_to(const DebyeSeries& series, int last) {
    PartialWaves result = series.order(0);
    for (int p = 1; p <= last; ++p) result = sum(result, series.order(p));
    return result;
}

TEST(DebyeSeries, AgreesWithArithmeticOf50Digits) {
    /// The amplitudes' own accuracy at x = 20,000, where n x has rounded to 2e-12 before the waves
    /// begin.
    constexpr double kLocal = 1e-9;
    /// Over x, the size of a ray's amplitude: what rounding leaves where the exact term is tiny.
    constexpr double kFloor = 2e-11;
    /// Efficiencies do not depend on phases; the rest after p = 7 lives from resonances.
    constexpr double kEnergy = 3e-14, kResonances = 1e-11;
    double size = 0.0;
    std::string order;
    PartialWaves waves;
    int rows = 0;
    for (const auto& row :
         reference_rows("debye_50_digits.csv", "x,order,quantity,angle_deg,re,im")) {
        if (std::stod(row[0]) != size || row[1] != order) {
            size = std::stod(row[0]);
            order = row[1];
            const DebyeSeries series(kWater, size);
            waves = order == "mie"    ? series.all()
                    : order == "rest" ? series.beyond(kHighestOrder)
                                      : series.order(std::stoi(order));
        }
        const Complex expected{std::stod(row[4]), std::stod(row[5])};
        const std::string where = row[0] + "," + row[1] + "," + row[2] + "," + row[3];
        if (row[2] == "qsca") {
            const double computed = efficiencies_of(waves, size).scattering;
            EXPECT_NEAR(computed / expected.real(), 1.0, order == "rest" ? kResonances : kEnergy)
                << where;
        } else {
            const Amplitudes s = amplitudes_at(waves, std::stod(row[3]) * unit::deg);
            const Complex computed = row[2] == "S1" ? s.perpendicular : s.parallel;
            EXPECT_LT(std::abs(computed - expected), kLocal * std::abs(expected) + kFloor * size)
                << where;
        }
        ++rows;
    }
    EXPECT_EQ(rows, 1040);
}

TEST(DebyeSeries, AgreesWithAnotherProgram) {
    /// That program stops at Wiscombe's N, which leaves 1e-7 of the forward peak's amplitude.
    constexpr double kPrinted = 1e-6;
    /// Over x²: rounding, there and here.
    constexpr double kFloor = 1e-9;
    for (const auto& row : reference_rows("debye_terms.csv", "x,p,angle_deg,absS1sq,absS2sq")) {
        const double size = std::stod(row[0]);
        if (size > 1000.0) continue;  // two programs in double precision prove no more there
        const PartialWaves waves = DebyeSeries(kWater, size).order(std::stoi(row[1]));
        const Amplitudes s = amplitudes_at(waves, std::stod(row[2]) * unit::deg);
        const double s1 = std::stod(row[3]), s2 = std::stod(row[4]);
        EXPECT_NEAR(std::norm(s.perpendicular), s1, kPrinted * s1 + kFloor * size * size) << row[2];
        EXPECT_NEAR(std::norm(s.parallel), s2, kPrinted * s2 + kFloor * size * size) << row[2];
    }
}

TEST(DebyeSeries, OrdersAndTheClosedRemainderAddUp) {
    // Exact for every p; the coefficients are at most 1.
    constexpr double kRounding = 2e-13;
    for (const double size : {0.5, 10.0, 100.0, 1000.0, 5712.0}) {
        const DebyeSeries series(kWater, size);
        const PartialWaves all = series.all();
        for (const int last : {0, 1, 2, 3, 7, 20, 100})
            EXPECT_LT(distance(sum(sum_to(series, last), series.beyond(last)), all), kRounding)
                << "x = " << size << ", p = " << last;
    }
}

TEST(DebyeSeries, EachWaveIsMies) {
    // Relative to the waves of that n, also to those that hardly touch the drop (a_12 is 1e-40 for
    // x = 0.5), where R_22 and R_11 are nearly 1.
    constexpr double kRounding = 1e-11;  // 1.3e-12 at b_10 of x = 0.5
    for (const double size : {0.5, 10.0, 100.0}) {
        const PartialWaves all = DebyeSeries(kWater, size).all(), mie = mie_waves(kWater, size);
        ASSERT_EQ(all.a.size(), mie.a.size());
        for (std::size_t i = 0; i < mie.a.size(); ++i) {
            const double allowed = kRounding * (std::abs(mie.a[i]) + std::abs(mie.b[i]));
            EXPECT_LT(std::abs(all.a[i] - mie.a[i]), allowed) << "x = " << size << ", a_" << i + 1;
            EXPECT_LT(std::abs(all.b[i] - mie.b[i]), allowed) << "x = " << size << ", b_" << i + 1;
        }
    }
}

TEST(DebyeSeries, ClosedSumIsMiesAtEveryAngle) {
    constexpr double kLocal = 1e-9;  // of the amplitude there
    for (const double size : {100.0, 1000.0}) {
        const PartialWaves mie = mie_waves(kWater, size);
        const DebyeSeries series(kWater, size);
        for (const PartialWaves& waves :
             {series.all(), sum(sum_to(series, kHighestOrder), series.beyond(kHighestOrder))}) {
            for (double degrees = 0.0; degrees <= 180.0; degrees += 0.5) {
                const Amplitudes s = amplitudes_at(waves, degrees * unit::deg);
                const Amplitudes expected = amplitudes_at(mie, degrees * unit::deg);
                EXPECT_LT(std::abs(s.perpendicular - expected.perpendicular),
                          kLocal * std::abs(expected.perpendicular));
                EXPECT_LT(std::abs(s.parallel - expected.parallel),
                          kLocal * std::abs(expected.parallel));
            }
        }
    }
}

TEST(DebyeSeries, LightThatHitsTheDropDiesAway) {
    // Waves of n < x − 5 are reflected inside at less than grazing incidence: |R_11|^100 = 1e-32.
    // Others, n = 110 say, pass the drop by, leak in and stay for thousands of rounds.
    constexpr double kLeft = 1e-30, kStays = 1e-4;
    const PartialWaves left = DebyeSeries(kWater, 100.0).beyond(100);
    for (std::size_t n = 1; n <= 95; ++n) {
        EXPECT_LT(std::abs(left.a[n - 1]), kLeft) << n;
        EXPECT_LT(std::abs(left.b[n - 1]), kLeft) << n;
    }
    EXPECT_GT(std::abs(left.b[109]), kStays);
}

TEST(DebyeSeries, EnergyTendsToThatOfRays) {
    // ∫ 2b db ½ (ε_s² + ε_p²), and 1 more of diffraction at p = 0. What differs is the edge, a ring
    // of relative width x^{−2/3}: Q_ext = 2 + 1.9924 x^{−2/3}, nearly all of it in p = 0.
    //                                                              [Nussenzveig & Wiscombe 1980]
    // The other constants are those measured at x = 100 to 20,000 for the three indices, rounded
    // up; they fall as x grows.
    constexpr double kEdge[] = {1.9924, 0.7, 0.22, 0.11, 0.06, 0.04, 0.03, 0.02};
    const QuadratureRule rule = gauss_legendre(64);
    for (const double n : {1.325, 1.333, 1.345}) {
        for (int p = 0; p <= kHighestOrder; ++p) {
            // In b = sin i: the flux changes steeply near grazing.
            const double rays = integrate(rule, 0.0, 0.5 * std::numbers::pi, [&](double i) {
                const RayAmplitudes e = ray_amplitudes(drop_ray(std::sin(i), {n}), {n}, p);
                return std::sin(2.0 * i) * 0.5 *
                       (e.perpendicular * e.perpendicular + e.parallel * e.parallel);
            });
            for (const double size : {300.0, 1000.0, 5712.0}) {
                const double waves =
                    efficiencies_of(DebyeSeries({n}, size).order(p), size).scattering;
                EXPECT_NEAR(waves, rays + (p == 0 ? 1.0 : 0.0),
                            kEdge[p] * std::pow(size, -2.0 / 3.0))
                    << "n = " << n << ", p = " << p << ", x = " << size;
            }
        }
    }
}

/// ½ (|S_1|² + |S_2|²), the first of them, and the degree of polarisation.
struct Brightness {
    double perpendicular, unpolarised, polarisation;
};

Brightness brightness_at(const PartialWaves& waves, double theta_deg) {
    const Amplitudes s = amplitudes_at(waves, theta_deg * unit::deg);
    const double s1 = std::norm(s.perpendicular), s2 = std::norm(s.parallel);
    return {s1, 0.5 * (s1 + s2), (s1 - s2) / (s1 + s2)};
}

/// The place of the maximum of f within a parabola's step of `start`: Newton's method on three
/// points.
template <class Function>
double maximum_near(const Function& f, double start, double step) {
    for (int i = 0; i < 8; ++i, step *= 0.5) {
        const double before = f(start - step), here = f(start), after = f(start + step);
        start += 0.5 * step * (before - after) / (before - 2.0 * here + after);
    }
    return start;
}

TEST(DebyeSeries, BowsStandWhereAnotherProgramFoundThem) {
    constexpr double kPrinted = 1e-4;
    /// Four decimals at the grid's maximum, half a step or less from the true one.
    constexpr double kPolarisation = 2e-4;
    /// In degrees: four decimals, and the grid of that program, 11.5 / 4000 of the scale.
    const auto place_error = [](double scale) { return 1e-4 + scale * 11.5 / 4000.0; };
    constexpr double kAiryPeak = 0.5356566560156999;  // Ai(−1.0187929716)  [NIST DLMF, 9.9]
    for (const auto& row : reference_rows("debye_bow_peaks.csv",
                                          "n,x,p,theta_R_deg,scale_deg,k,theta_airy_deg,"
                                          "theta_debye_deg,diff_deg,I_ratio,dop_main")) {
        const RelativeIndex n{std::stod(row[0])};
        const double size = std::stod(row[1]), scale = std::stod(row[4]);
        const DescartesRay bow = descartes_ray(n, std::stoi(row[2]));
        const PartialWaves waves = DebyeSeries(n, size).order(bow.p);
        const auto s_at = [&](double theta) { return brightness_at(waves, theta).perpendicular; };
        const double peak = maximum_near(s_at, std::stod(row[7]), 0.1 * scale);
        EXPECT_NEAR(peak, std::stod(row[7]), place_error(scale));
        if (row[5] != "0") continue;
        // Airy's theory at its own maximum, where Ai' is 0.          [van de Hulst 1957, §13.2]
        const double epsilon = ray_amplitudes(bow.ray, n, bow.p).perpendicular;
        const double airy = 2.0 * std::numbers::pi * std::pow(size, 7.0 / 3.0) *
                            bow.impact_parameter /
                            (sin(bow.scattering_angle) * std::pow(bow.airy_constant, 2.0 / 3.0)) *
                            std::pow(epsilon * kAiryPeak, 2.0);
        EXPECT_NEAR(s_at(peak) / airy, std::stod(row[9]), kPrinted);
        const auto all_at = [&](double theta) { return brightness_at(waves, theta).unpolarised; };
        EXPECT_NEAR(brightness_at(waves, maximum_near(all_at, peak, 0.1 * scale)).polarisation,
                    std::stod(row[10]), kPolarisation);
    }
}

TEST(DebyeSeries, SmallDropsScatterAsRayleighSays) {
    // a_1 = −i ⅔ x³ (n² − 1) / (n² + 2), up to a part x² of it.        [Bohren & Huffman, eq. 5.4]
    const double n2 = kWater.value * kWater.value;
    for (const double size : {1e-3, 1e-2, 0.05}) {
        const PartialWaves all = DebyeSeries(kWater, size).all();
        const Complex dipole{0.0, -2.0 / 3.0 * std::pow(size, 3.0) * (n2 - 1.0) / (n2 + 2.0)};
        EXPECT_LT(std::abs(all.a[0] / dipole - 1.0), size * size) << size;
        EXPECT_LT(std::abs(all.b[0] / dipole), size * size) << size;
    }
}

TEST(DebyeSeries, ADropOfNothingLetsLightThroughUnchanged) {
    constexpr double kRounding = 1e-13;
    const DebyeSeries series({1.0}, 50.0);
    const PartialWaves none{std::vector<Complex>(series.order(0).a.size()),
                            std::vector<Complex>(series.order(0).b.size())};
    EXPECT_LT(distance(series.order(2), none), kRounding);
    EXPECT_LT(distance(series.all(), none), kRounding);
}

TEST(DebyeSeries, RefusesWhatItDoesNotHoldFor) {
    for (const double n : {0.999, -1.33, 1e9, std::nan("")})
        EXPECT_THROW(DebyeSeries({n}, 100.0), InputError);
    for (const double size : {0.0, -1.0, 1e-4, 20001.0, std::nan("")})
        EXPECT_THROW(DebyeSeries(kWater, size), InputError);
}

}  // namespace
}  // namespace dewbow
