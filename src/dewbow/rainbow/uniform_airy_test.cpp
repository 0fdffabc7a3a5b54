// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/uniform_airy.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/airy.h"
#include "dewbow/rainbow/debye.h"
#include "dewbow/rainbow/descartes.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/geometric_rays.h"
#include "dewbow/rainbow/uniform_bow.h"

namespace dewbow {
namespace {

using namespace unit;

/// `count` angles from `from` to `to` Airy units on the bright side of a bow.
std::vector<Angle> airy_units(double n, int p, double x, double from, double to, int count) {
    const DescartesRay bow = descartes_ray({n}, p);
    const double unit_angle = std::cbrt(bow.airy_constant / (x * x));
    std::vector<Angle> theta;
    for (int i = 0; i < count; ++i) {
        const double u = from + (to - from) * (i + 0.5) / count;
        theta.push_back(bow.scattering_angle + bow.bright_side * u * unit_angle * rad);
    }
    return theta;
}

std::vector<Amplitudes> amplitudes_of(const ScatteringModel& model, double n, double x,
                                      const std::vector<Angle>& theta) {
    std::vector<Amplitudes> s(theta.size());
    dynamic_cast<const AmplitudeModel&>(model).amplitudes({n, 0.0}, {x}, theta, s);
    return s;
}

ModelOptions of_order(int p) {
    ModelOptions options;
    options.orders = {p};
    return options;
}

/// Errors of a model against the Debye series, over the greatest value on the order's main bow:
/// root mean squares over angles evenly spread between two numbers of Airy units.
struct Errors {
    double perpendicular = 0.0, parallel = 0.0, unpolarised = 0.0;  ///< of |S|²
    double largest = 0.0;                         ///< of |S|² unpolarised, the worst angle
    double amplitude_1 = 0.0, amplitude_2 = 0.0;  ///< of S
};
using MakeModel = std::unique_ptr<ScatteringModel> (*)(const ModelOptions&);
Errors errors(double n, int p, double x, double from, double to,
              MakeModel make = make_uniform_airy) {
    constexpr int kAngles = 160;
    const std::vector<Angle> main = airy_units(n, p, x, 0.0, 1.9, 60);
    const std::vector<Angle> theta = airy_units(n, p, x, from, to, kAngles);
    const auto debye = make_debye(of_order(p));
    const auto exact = amplitudes_of(*debye, n, x, theta),
               at_peak = amplitudes_of(*debye, n, x, main);
    const auto found = amplitudes_of(*make(of_order(p)), n, x, theta);
    double s = 0.0, q = 0.0, both = 0.0;
    for (const Amplitudes& a : at_peak) {
        s = std::max(s, std::norm(a.perpendicular));
        q = std::max(q, std::norm(a.parallel));
        both = std::max(both, std::norm(a.perpendicular) + std::norm(a.parallel));
    }
    Errors sum;
    for (std::size_t i = 0; i < theta.size(); ++i) {
        const double ds = std::norm(found[i].perpendicular) - std::norm(exact[i].perpendicular);
        const double dq = std::norm(found[i].parallel) - std::norm(exact[i].parallel);
        sum.perpendicular += ds * ds / (s * s);
        sum.parallel += dq * dq / (q * q);
        sum.unpolarised += (ds + dq) * (ds + dq) / (both * both);
        sum.largest = std::max(sum.largest, std::abs(ds + dq) / both);
        sum.amplitude_1 += std::norm(found[i].perpendicular - exact[i].perpendicular) / s;
        sum.amplitude_2 += std::norm(found[i].parallel - exact[i].parallel) / q;
    }
    for (double* e :
         {&sum.perpendicular, &sum.parallel, &sum.unpolarised, &sum.amplitude_1, &sum.amplitude_2})
        *e = std::sqrt(*e / theta.size());
    return sum;
}

/// The last Airy unit with two rays, at most 8.
double last_unit(double n, int p, double x) {
    const BowGeometry bow = bow_geometry({n}, p);
    return std::min(8.0, 0.99 * bow.span / std::cbrt(bow.curvature / (x * x)));
}

TEST(UniformAiry, PrimaryBowAgainstDebye) {
    // What the model is held to from x = 1000 on; measured at 1000: 0.04 % s, 0.02 % p, 0.04 %
    // unpolarised, and 0.09 % on the fringes.
    for (double n : {1.325, 1.333, 1.345})
        for (double x : {1000.0, 5712.0}) {
            const Errors main = errors(n, 2, x, -2.0, 1.9), fringes = errors(n, 2, x, 1.9, 8.0);
            EXPECT_LT(main.perpendicular, 0.001) << n << " " << x;
            EXPECT_LT(main.parallel, 0.005) << n << " " << x;
            EXPECT_LT(main.unpolarised, 0.002) << n << " " << x;
            EXPECT_LT(fringes.perpendicular, 0.005) << n << " " << x;
        }
}

TEST(UniformAiry, AmplitudesHaveDebyesPhases) {
    // S_1 and S_2 as complex numbers, which a phase wrong by 0.01 radian would fail. Measured:
    // at most 0.0015 for p = 2 to 4.
    constexpr double kOfPeak = 0.004;
    for (int p : {2, 3, 4}) {
        const double x = p == 2 ? 3000.0 : p == 3 ? 5000.0 : 10000.0;
        const Errors main = errors(1.333, p, x, -2.0, 1.9);
        EXPECT_LT(main.amplitude_1, kOfPeak) << p;
        EXPECT_LT(main.amplitude_2, kOfPeak) << p;
    }
}

TEST(UniformAiry, AmplitudesHaveEveryTermInOneOverX) {
    // Measured 1e-5 of the peak; without the term in cot θ of Legendre's functions, 0.875/(x b),
    // it is 2e-4.
    constexpr double kNextOrder = 2.5e-5;
    EXPECT_LT(errors(1.333, 2, 5712.0, -2.0, 1.9).amplitude_1, kNextOrder);
}

TEST(UniformAiry, TermsInOneOverXMakeErrorsFallFaster) {
    // With the leading term alone the parallel amplitude is wrong by a part that falls as 1/x;
    // with the next one, as 1/x². Between x = 1000 and 4000 that is a factor 16 against 4.
    const double at_1000 = errors(1.333, 2, 1000.0, -2.0, 1.9).amplitude_2;
    const double at_4000 = errors(1.333, 2, 4000.0, -2.0, 1.9).amplitude_2;
    EXPECT_GT(at_1000 / at_4000, 8.0);
}

/// uniform_airy_error() as an upper bound on both regions, up to where it is 20 %.
void expect_stated_error(double n, int p, double x) {
    const BowError stated = uniform_airy_error({n}, p, x);
    if (stated.main_bow > 0.2) return;
    EXPECT_LT(errors(n, p, x, -2.0, 1.9).unpolarised, stated.main_bow) << n << " " << p << " " << x;
    EXPECT_LT(errors(n, p, x, 1.9, last_unit(n, p, x)).unpolarised, stated.fringes)
        << n << " " << p << " " << x;
}

TEST(UniformAiry, HigherOrdersKeepTheStatedError) {
    for (int p : {2, 3, 4, 5})
        for (double x : {300.0, 1000.0, 5000.0}) expect_stated_error(1.333, p, x);
}

// Prints the table of docs/rainbow-models.md.
TEST(LongUniformAiry, TableOfErrors) {
    for (int p : {2, 3, 4, 5, 6, 7})
        for (double n : {1.30, 1.325, 1.333, 1.345, 1.36})
            for (double x : {300.0, 1000.0, 3000.0, 5712.0, 20000.0}) {
                expect_stated_error(n, p, x);
                const Errors main = errors(n, p, x, -2.0, 1.9);
                const double end = last_unit(n, p, x);
                const Errors fringes = end > 2.5 ? errors(n, p, x, 1.9, end) : Errors{};
                const Errors airy = errors(n, p, x, -2.0, std::min(1.9, end), make_airy);
                fmt::print(
                    "| {} | {} | {:.0f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | "
                    "{:.3f} | {:.3f} | {:.3f} | {:.2f} | {:.2f} |\n",
                    p, n, x, 100.0 * main.perpendicular, 100.0 * main.parallel,
                    100.0 * main.unpolarised, 100.0 * main.largest, end,
                    100.0 * fringes.perpendicular, 100.0 * fringes.parallel,
                    100.0 * fringes.unpolarised, 100.0 * airy.perpendicular, 100.0 * airy.parallel);
            }
}

TEST(UniformAiry, BeyondTheGrazingRayOneRayIsLeft) {
    // Secondary at 60°, and the second way of p = 4 at 120°: single rays, with their phases, by
    // Airy functions (x = 5000) and without. A ray's amplitude is right to terms in 1/x.
    constexpr double kTimesX = 10.0;
    for (double x : {5000.0, 20000.0})
        for (int p : {3, 4}) {
            const std::vector<Angle> theta{(p == 3 ? 60.0 : 120.0) * deg};
            const auto found = amplitudes_of(*make_uniform_airy(of_order(p)), 1.333, x, theta);
            const auto exact = amplitudes_of(*make_debye(of_order(p)), 1.333, x, theta);
            EXPECT_LT(std::abs(found[0].perpendicular / exact[0].perpendicular - 1.0), kTimesX / x);
            EXPECT_LT(std::abs(found[0].parallel / exact[0].parallel - 1.0), kTimesX / x);
        }
}

/// (2/x²) ∫ ½ (|S_1|² + |S_2|²) sin θ dθ and the mean of cos θ, by midpoints: five at least for
/// each fringe.
Efficiencies integrals_over_sphere(const ScatteringModel& model, const Drop& drop) {
    const int count = 4000 + static_cast<int>(2.0 * drop.size_parameter);
    std::vector<Angle> theta;
    for (int i = 0; i < count; ++i) theta.push_back(180.0 * (i + 0.5) / count * deg);
    std::vector<Intensities> light(theta.size());
    model.intensities({1.333, 0.0}, {&drop, 1}, theta, light);
    double sum = 0.0, forward = 0.0;
    for (int i = 0; i < count; ++i) {
        const double flux = light[i].unpolarised() * sin(theta[i]);
        sum += flux, forward += flux * cos(theta[i]);
    }
    const double step = (180.0 * deg).to(rad) / count;
    const double q = 2.0 * sum * step / (drop.size_parameter * drop.size_parameter);
    return {q, q, forward / sum};
}

TEST(UniformAiry, EnergyIsThatOfTheRays) {
    // The whole sphere against its efficiency, also where the drop turns the bow. Measured at
    // x = 2000: 0.06 % for p = 2 and 0.09 % for p = 3, what is wrong at the drop's edge.
    constexpr double kEdge = 0.002;
    for (int p : {2, 3})
        for (double shift_deg : {0.0, 3.0}) {
            Drop drop{2000.0};
            drop.shifts[p] = shift_deg * deg;
            const auto model = make_uniform_airy(of_order(p));
            const Efficiencies q = model->efficiencies({1.333, 0.0}, drop);
            const Efficiencies found = integrals_over_sphere(*model, drop);
            EXPECT_NEAR(found.scattering / q.scattering, 1.0, kEdge) << p;
            EXPECT_EQ(q.extinction, q.scattering);
            if (!drop.is_sphere()) continue;
            EXPECT_NEAR(found.asymmetry, q.asymmetry, kEdge) << p;
        }
}

TEST(UniformAiry, ManyDropsAreEachForItself) {
    // As [drop][angle], with and without a shift, more angles than are worked on at once; and |S|²
    // of the amplitudes.
    constexpr double kRounding = 1e-12;
    std::vector<Drop> drops{{800.0}, {900.0}, {900.0}, {5000.0}};
    drops[2].shifts[3] = drops[3].shifts[3] = 2.0 * deg;
    std::vector<Angle> theta;
    for (int i = 0; i < 150; ++i) theta.push_back((105.0 + 0.4 * i) * deg);
    for (const MakeModel make : {make_uniform_airy, make_airy}) {
        const auto model = make(of_order(3));
        std::vector<Intensities> all(drops.size() * theta.size()), one(theta.size());
        std::vector<Amplitudes> s(theta.size());
        model->intensities({1.333, 0.0}, drops, theta, all);
        for (std::size_t d = 0; d < drops.size(); ++d) {
            model->intensities({1.333, 0.0}, {&drops[d], 1}, theta, one);
            dynamic_cast<const AmplitudeModel&>(*model).amplitudes({1.333, 0.0}, drops[d], theta,
                                                                   s);
            for (std::size_t i = 0; i < theta.size(); ++i) {
                const double found = all[d * theta.size() + i].perpendicular;
                if (std::isnan(found)) continue;
                EXPECT_NEAR(found, one[i].perpendicular, kRounding * found) << d << " " << i;
                EXPECT_NEAR(found, std::norm(s[i].perpendicular), kRounding * found);
            }
        }
    }
}

TEST(UniformAiry, RefusesWhatItCannotTreat) {
    EXPECT_THROW(make_uniform_airy(of_order(1)), InputError);
    EXPECT_THROW(make_uniform_airy(of_order(8)), InputError);
    const auto model = make_uniform_airy({});
    EXPECT_THROW(model->efficiencies({1.333, 1e-6}, {1000.0}), InputError);
    EXPECT_THROW(model->efficiencies({1.5, 0.0}, {1000.0}), InputError);
    for (double x : {0.0, -5.0, 5.0, 60000.0, std::nan("")})
        EXPECT_THROW(model->efficiencies({1.333, 0.0}, {x}), InputError) << x;
}

TEST(TwoRayRegion, FromTheDarkAxisToTheGrazingRay) {
    // Bows of the reference table; D of the grazing ray, p(π - 2 arcsin(1/n)).
    constexpr double kPrinted = 0.001;
    const struct {
        int p;
        double dark, bow, grazing;
    } rows[] = {{2, 0.0, 137.922, 165.573},
                {3, 180.0, 129.109, 111.640},
                {4, 180.0, 41.737, 28.853},
                {5, 0.0, 43.703, 53.934},
                {6, 0.0, 128.229, 136.720}};
    for (const auto& row : rows) {
        const TwoRayRegion region = two_ray_region({1.333}, row.p);
        EXPECT_EQ(region.dark.to(deg), row.dark) << row.p;
        EXPECT_NEAR(region.bow.to(deg), row.bow, kPrinted);
        EXPECT_NEAR(region.grazing.to(deg), row.grazing, kPrinted);
        EXPECT_TRUE(region.contains(region.bow));
        EXPECT_FALSE(region.contains((180.0 - row.dark) * deg));
    }
}

TEST(UniformBow, HasNoSeamsAndIsFinite) {
    // Where the second ray ends; and everywhere but where light of p >= 4 crosses the axis.
    constexpr double kSeam = 1e-5;
    const Drop drop{2000.0};
    for (int p = kLowestBow; p <= kHighestBow; ++p) {
        const UniformBow bow({1.333}, p);
        const auto at = [&](Angle theta) {
            Amplitudes s{};
            bow.add_amplitudes({&drop, 1}, {&theta, 1}, {&s, 1});
            return s;
        };
        const Angle end = two_ray_region({1.333}, p).grazing, step = 1e-7 * deg;
        const Amplitudes before = at(end - step), after = at(end + step);
        EXPECT_LT(std::abs(before.perpendicular / after.perpendicular - 1.0), kSeam) << p;
        EXPECT_LT(std::abs(before.parallel / after.parallel - 1.0), kSeam) << p;
        for (double theta = 0.0; theta <= 180.0; theta += 0.125) {
            const bool crosses = p >= 4 && drop.size_parameter * sin(theta * deg) < 4.0;
            if (crosses) continue;
            const Amplitudes s = at(theta * deg);
            EXPECT_TRUE(std::isfinite(std::abs(s.perpendicular) + std::abs(s.parallel)))
                << p << " " << theta;
        }
    }
}

TEST(UniformBow, LargeDropsBecomeRays) {
    // Beyond the bow's region, where light comes one way: ε² b / (sin θ |dD/db|) times x². What is
    // left of Airy functions is (ζ x^{2/3})^{-3/2} / 4.
    constexpr double kAt50000 = 2e-4;
    const struct {
        int p;
        Angle theta;
    } rows[] = {{3, 20.0 * deg}, {3, 60.0 * deg}, {4, 60.0 * deg}, {4, 100.0 * deg}};
    for (const auto& row : rows) {
        const Drop drop{50000.0};
        Amplitudes s{};
        UniformBow({1.333}, row.p).add_amplitudes({&drop, 1}, {&row.theta, 1}, {&s, 1});
        const Intensities rays = geometric_intensity({1.333}, row.p, row.theta);
        EXPECT_NEAR(std::norm(s.perpendicular) / (2.5e9 * rays.perpendicular), 1.0, kAt50000);
        EXPECT_NEAR(std::norm(s.parallel) / (2.5e9 * rays.parallel), 1.0, kAt50000);
    }
}

}  // namespace
}  // namespace dewbow
