// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/refraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

constexpr int kRandomCases = 1'000'000;

/// Numbers that depend on the case alone.
struct Case {
    double cos_i, n;  ///< cos_i in [0, 1), n log-uniform in [0.1, 10)
    explicit Case(std::uint32_t index) {
        const auto u = SampleKey(stream_key(7, 0, 0), index).two(0, Purpose::test);
        cos_i = u[0];
        n = std::pow(10.0, 2.0 * u[1] - 1.0);
    }
};

struct Amplitudes {
    long double r_parallel, r_perpendicular, t_parallel, t_perpendicular, cos_t;
};

/// The amplitude coefficients as the textbook has them, in the angles' cosines, evaluated in long
/// double: another formula than the tested one. Only below the critical angle.      [Born & Wolf
/// §1.5.2, eqs. 20, 21]
Amplitudes textbook_amplitudes(long double cos_i, long double n) {
    const long double cos_t = std::sqrt(1.0L - (1.0L - cos_i * cos_i) / (n * n));
    return {(n * cos_i - cos_t) / (n * cos_i + cos_t), (cos_i - n * cos_t) / (cos_i + n * cos_t),
            2.0L * cos_i / (n * cos_i + cos_t), 2.0L * cos_i / (cos_i + n * cos_t), cos_t};
}

bool is_total(double cos_i, double n) {
    const long double s = std::sqrt(1.0L - static_cast<long double>(cos_i) * cos_i);
    return s >= static_cast<long double>(n);
}

// ---- energy ----

/// Worst |R + T − 1|, weighted by q = n cos_t where that is below 1: an ulp in the cosine given is
/// 1/q ulp in q, and so in R, whatever the formula.
template <class T>
double worst_energy_error() {
    long double worst = 0.0L;
    for (int i = 0; i < kRandomCases; ++i) {
        const Case c(static_cast<std::uint32_t>(i));
        const T cos_i = static_cast<T>(c.cos_i), n = static_cast<T>(c.n);
        if (is_total(cos_i, n) || cos_i == T(0)) continue;
        const auto a = textbook_amplitudes(cos_i, n);
        const long double q = n * a.cos_t, through = q / cos_i;  // power through the same area
        const auto R = fresnel_dielectric(cos_i, n);
        const long double p = R.parallel + through * a.t_parallel * a.t_parallel - 1.0L;
        const long double s =
            R.perpendicular + through * a.t_perpendicular * a.t_perpendicular - 1.0L;
        worst = std::max({worst, std::min(q, 1.0L) * std::abs(p), std::min(q, 1.0L) * std::abs(s)});
    }
    return static_cast<double>(worst);
}

// [measured: 1.0e-15 and 3.0e-8] A float is the double result rounded: half an ulp below 1.
constexpr double kEnergyErrorDouble = 2e-15;
constexpr double kEnergyErrorFloat = 3.0e-8;

TEST(FresnelDielectric, KeepsEnergyInDouble) {
    EXPECT_LE(worst_energy_error<double>(), kEnergyErrorDouble);
}

TEST(FresnelDielectric, KeepsEnergyInFloat) {
    EXPECT_LE(worst_energy_error<float>(), kEnergyErrorFloat);
}

/// Schlick's approximation, which is close enough to be mistaken for the truth.
double schlick(double cos_i, double n) {
    const double r0 = (n - 1.0) / (n + 1.0);
    return r0 * r0 + (1.0 - r0 * r0) * std::pow(1.0 - cos_i, 5);
}

TEST(FresnelDielectric, IsNotSchlick) {
    double most = 0.0;
    for (double cos_i = 0.0; cos_i <= 1.0; cos_i += 0.01)
        most = std::max(
            most, std::abs(schlick(cos_i, 1.5) - fresnel_dielectric(cos_i, 1.5).unpolarised()));
    EXPECT_GT(most, 0.02);  // so that the energy test above has something to find
    EXPECT_LT(most, 0.08);
}

// ---- reciprocity ----

// cos_t carries 1 ulp in, and R moves by 1/cos_t² times that: within the margin, 1e3 ulp.
// [measured 1.1e-13]
constexpr double kTotalReflectionMargin = 0.999;  // of sin²theta_t
constexpr double kReciprocityError = 1e-11;

TEST(FresnelDielectric, ReflectsAlikeFromBothSides) {
    double worst = 0.0;
    int compared = 0;
    for (int i = 0; i < kRandomCases; ++i) {
        const Case c(static_cast<std::uint32_t>(i));
        const double cos2_t = cos2_transmitted(c.cos_i, c.n);
        if (!(cos2_t >= 1.0 - kTotalReflectionMargin) ||
            c.cos_i * c.cos_i < 1.0 - kTotalReflectionMargin)
            continue;
        const auto there = fresnel_dielectric(c.cos_i, c.n);
        const auto back = fresnel_dielectric(std::sqrt(cos2_t), 1.0 / c.n);
        worst = std::max({worst, std::abs(there.parallel - back.parallel),
                          std::abs(there.perpendicular - back.perpendicular)});
        ++compared;
    }
    EXPECT_LE(worst, kReciprocityError);
    EXPECT_GT(compared, kRandomCases / 2);
}

// ---- closed forms ----

constexpr double kUlps = 4 * std::numeric_limits<double>::epsilon();

TEST(FresnelDielectric, IsTheSquaredContrastAtNormalIncidence) {
    for (double n : {0.1, 0.4, 0.66, 0.75, 0.99, 1.0003, 1.333, 1.5, 2.417, 10.0}) {
        const double expected = std::pow((n - 1.0) / (n + 1.0), 2);
        const auto R = fresnel_dielectric(1.0, n);
        EXPECT_NEAR(R.parallel / expected, 1.0, kUlps) << n;
        EXPECT_EQ(R.parallel, R.perpendicular) << n;
    }
}

TEST(FresnelDielectric, HasNoParallelReflectionAtBrewstersAngle) {
    for (double n : {0.4, 0.75, 1.333, 1.5, 2.417, 10.0}) {
        const double cos_b = cos(brewster_angle({n}));
        // r_parallel is some ulps there, and R its square.
        EXPECT_LE(fresnel_dielectric(cos_b, n).parallel, 1e-30) << n;
        // Away from it there is reflection: by r' = dr/dtheta = (n⁴ − 1) / (2 n³) a degree.
        const double at_one_degree = std::pow((std::pow(n, 4) - 1) / (2 * n * n * n) * 0.01745, 2);
        const double off = cos(brewster_angle({n}) - 1.0 * unit::deg);
        EXPECT_NEAR(fresnel_dielectric(off, n).parallel / at_one_degree, 1.0, 0.6) << n;
    }
}

TEST(FresnelDielectric, ReflectsAllBeyondTheCriticalAngle) {
    for (double n : {0.1, 0.4, 1 / 1.5, 0.75, 0.9, 0.999999}) {
        const Angle critical = critical_angle({n}).value();
        const double step = 1e-9;
        const auto beyond = fresnel_dielectric(cos(critical + step * unit::rad), n);
        const auto before = fresnel_dielectric(cos(critical - step * unit::rad), n);
        EXPECT_EQ(beyond.parallel, 1.0) << n;
        EXPECT_EQ(beyond.perpendicular, 1.0) << n;
        EXPECT_LT(before.parallel, 1.0) << n;
        EXPECT_LT(before.perpendicular, 1.0) << n;
        EXPECT_LT(cos2_transmitted(cos(critical + step * unit::rad), n), 0.0) << n;
    }
}

TEST(FresnelDielectric, ReflectsNothingWhereThereIsNoInterface) {
    for (double cos_i : {0.0, 1e-300, 1e-200, 1e-8, 0.3, 1.0}) {
        EXPECT_EQ(fresnel_dielectric(cos_i, 1.0).unpolarised(), 0.0) << cos_i;
        const float narrow = static_cast<float>(cos_i);
        EXPECT_EQ(fresnel_dielectric(narrow, 1.0f).unpolarised(), 0.0f) << cos_i;
        EXPECT_EQ(fresnel_conductor(cos_i, std::complex(1.0, 0.0)).unpolarised(), 0.0) << cos_i;
    }
}

TEST(FresnelDielectric, ReflectsAllAtGrazingIncidence) {
    for (double n : {0.2, 0.9, 1.0 + 1e-15, 1.0 + 1e-6, 1.5, 10.0}) {
        EXPECT_NEAR(fresnel_dielectric(0.0, n).parallel, 1.0, kUlps) << n;
        EXPECT_NEAR(fresnel_dielectric(0.0, n).perpendicular, 1.0, kUlps) << n;
    }
}

// ---- everywhere ----

template <class T>
void expect_reflectance(T value, T cos_i, T n) {
    EXPECT_TRUE(value >= T(0) && value <= T(1)) << value << " at cos " << cos_i << ", n " << n;
}

template <class T>
void expect_reflectances_everywhere() {
    const T least = std::numeric_limits<T>::min(), eps = std::numeric_limits<T>::epsilon();
    const T cosines[] = {0,           std::numeric_limits<T>::denorm_min(),
                         least,       eps * eps,
                         eps,         T(1e-4),
                         T(0.1),      T(0.5),
                         T(0.9),      1 - eps,
                         1 - eps / 2, 1};
    const T indices[] = {std::numeric_limits<T>::denorm_min(),
                         least,
                         eps * eps,
                         eps,
                         T(1e-3),
                         T(0.5),
                         T(0.70710678118),
                         T(0.9),
                         1 - eps,
                         1 - eps / 2,
                         1,
                         1 + eps,
                         T(1.1),
                         2,
                         10};
    for (T cos_i : cosines)
        for (T n : indices) {
            EXPECT_FALSE(std::isnan(cos2_transmitted(cos_i, n))) << cos_i << ' ' << n;
            const auto R = fresnel_dielectric(cos_i, n);
            expect_reflectance(R.parallel, cos_i, n);
            expect_reflectance(R.perpendicular, cos_i, n);
            for (T k : {T(0), least, eps, T(0.1), T(1), T(10)}) {
                const auto C = fresnel_conductor(cos_i, std::complex<T>(n, k));
                expect_reflectance(C.parallel, cos_i, n);
                expect_reflectance(C.perpendicular, cos_i, n);
            }
        }
}

TEST(Fresnel, IsAReflectanceEverywhere) {
    expect_reflectances_everywhere<float>();
    expect_reflectances_everywhere<double>();
}

// ---- float against double, double against long double, where it is hard ----

/// R_perpendicular in long double, from the difference that cancels least: 64 bits against the 53
/// tested.
long double precise_perpendicular(long double cos_i, long double n) {
    const long double q2 = (n - 1.0L) * (n + 1.0L) + cos_i * cos_i;
    if (q2 < 0.0L) return 1.0L;
    const long double r = (n - 1.0L) * (n + 1.0L) / std::pow(cos_i + std::sqrt(q2), 2.0L);
    return r * r;
}

/// Worst |R − R_precise| over cosines within `width` above `from`, log-spaced down to 1e-9 `width`.
template <class T>
double worst_error_near(T from, T n, double width) {
    double worst = 0.0;
    for (double d = width; d > 1e-9 * width; d *= 0.97) {
        const T cos_i = static_cast<T>(from + d);
        const double error = std::abs(static_cast<double>(
            fresnel_dielectric(cos_i, n).perpendicular - precise_perpendicular(cos_i, n)));
        worst = std::max(worst, error);
    }
    return worst;
}

// In double, q² is good to an ulp of 1 and R to 4/q of that: 1e-10 where the scan begins, 1e-11 off
// the critical cosine. A float result is the double one rounded, half an ulp below 1.
// [measured: 3.7e-11 near the critical angle, 1.0e-15 near grazing, float 3.0e-8 at both]
constexpr double kNearCriticalDouble = 1e-10;
constexpr double kNearGrazingDouble = 2e-15;
constexpr double kFloatHalfUlp = 3.0e-8;

TEST(FresnelDielectric, IsPreciseNearGrazingIncidence) {
    for (double n : {1.0 + 1e-12, 1.0 + 1e-6, 1.0003, 1.333, 2.417}) {
        EXPECT_LE(worst_error_near<double>(0.0, n, 0.1), kNearGrazingDouble) << n;
        EXPECT_LE(worst_error_near<float>(0.0f, static_cast<float>(n), 0.1), kFloatHalfUlp) << n;
    }
}

TEST(FresnelDielectric, IsPreciseNearTheCriticalAngle) {
    for (double n : {0.4, 1 / 1.5, 0.75, 0.9, 0.9999}) {
        const double critical = std::sqrt((1.0 - n) * (1.0 + n));
        EXPECT_LE(worst_error_near<double>(critical, n, 0.01), kNearCriticalDouble) << n;
        const float n_f = static_cast<float>(n), critical_f = static_cast<float>(critical);
        EXPECT_LE(worst_error_near<float>(critical_f, n_f, 0.01), kFloatHalfUlp) << n;
    }
}

// The textbook's 1 − sin²/n² is off by ε there, many times the value; the tested form by some ulps
// of it.
TEST(Cos2Transmitted, DoesNotCancelNearGrazingIncidence) {
    for (double delta : {1e-15, 1e-12, 1e-9, 1e-6})
        for (double cos_i : {0.0, 1e-9, 1e-6, 1e-3}) {
            const double n = 1.0 + delta;
            const long double exact = ((static_cast<long double>(n) - 1.0L) * (n + 1.0L) +
                                       static_cast<long double>(cos_i) * cos_i) /
                                      (static_cast<long double>(n) * n);
            EXPECT_NEAR(cos2_transmitted(cos_i, n) / static_cast<double>(exact), 1.0, kUlps)
                << delta << ' ' << cos_i;
        }
}

TEST(Cos2Transmitted, IsPreciseForAMuchRarerMedium) {
    for (double n : {1e-6, 1e-3, 0.1, 0.7})
        for (double share : {0.0, 0.3, 0.9}) {  // sin²theta_t wanted
            const double one_minus_cos = 0.5 * share * n * n;
            const double cos_i = 1.0 - one_minus_cos;
            const long double s2 = (1.0L - cos_i) * (1.0L + cos_i);
            const long double exact = 1.0L - s2 / (static_cast<long double>(n) * n);
            EXPECT_NEAR(cos2_transmitted(cos_i, n), static_cast<double>(exact), kUlps) << n;
        }
}

// ---- metals ----

// At 589.3 nm; reflectance in whole per cent. [Born & Wolf, Principles of Optics, 7th ed.,
// table 14.1]
struct PublishedMetal {
    const char* name;
    double n, k, reflectance;
};
constexpr PublishedMetal kPublishedMetals[] = {{"silver", 0.20, 3.44, 0.94},
                                               {"magnesium", 0.37, 4.42, 0.93},
                                               {"gold", 0.47, 2.83, 0.82},
                                               {"aluminium", 1.44, 5.23, 0.83}};
constexpr double kPublishedReflectanceError =
    0.0055;  // half a per cent, and the rounding of n and k

TEST(FresnelConductor, MatchesPublishedReflectances) {
    for (const auto& metal : kPublishedMetals) {
        const auto R = fresnel_conductor(1.0, std::complex(metal.n, metal.k));
        EXPECT_NEAR(R.unpolarised(), metal.reflectance, kPublishedReflectanceError) << metal.name;
    }
}

/// The textbook's complex amplitudes, in long double.
Reflectance<double> textbook_conductor(long double cos_i, std::complex<long double> n) {
    const long double s2 = 1.0L - cos_i * cos_i;
    const std::complex<long double> cos_t = std::sqrt(1.0L - s2 / (n * n));
    const auto r_p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
    const auto r_s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
    return {static_cast<double>(std::norm(r_p)), static_cast<double>(std::norm(r_s))};
}

constexpr double kConductorError = 2e-15;  // measured 1.0e-15

TEST(FresnelConductor, EqualsTheComplexAmplitudes) {
    double worst = 0.0;
    for (int i = 0; i < kRandomCases / 10; ++i) {
        const Case c(static_cast<std::uint32_t>(i));
        const double k =
            10.0 *
            SampleKey(stream_key(8, 0, 0), static_cast<std::uint32_t>(i)).one(0, Purpose::test);
        const auto R = fresnel_conductor(c.cos_i, std::complex(c.n, k));
        const auto expected = textbook_conductor(c.cos_i, {c.n, k});
        worst = std::max({worst, std::abs(R.parallel - expected.parallel),
                          std::abs(R.perpendicular - expected.perpendicular)});
    }
    EXPECT_LE(worst, kConductorError);
}

TEST(FresnelConductor, IsADielectricWithoutAbsorption) {
    for (int i = 0; i < kRandomCases / 10; ++i) {
        const Case c(static_cast<std::uint32_t>(i));
        const auto dielectric = fresnel_dielectric(c.cos_i, c.n);
        const auto conductor = fresnel_conductor(c.cos_i, std::complex(c.n, 0.0));
        ASSERT_NEAR(conductor.parallel, dielectric.parallel, kConductorError)
            << c.cos_i << ' ' << c.n;
        ASSERT_NEAR(conductor.perpendicular, dielectric.perpendicular, kConductorError)
            << c.cos_i << ' ' << c.n;
    }
}

// ---- angles ----

constexpr double kAngleError_rad = 1e-15;

TEST(RefractionAngle, ObeysSnellsLaw) {
    for (double n : {0.4, 0.75, 1.0003, 1.333, 2.417})
        for (double i_deg = 0.0; i_deg <= 90.0; i_deg += 0.5) {
            const Angle i = i_deg * unit::deg;
            const auto t = refraction_angle(i, {n});
            ASSERT_EQ(t.has_value(), sin(i) <= n) << i_deg << ' ' << n;
            if (t) {
                EXPECT_NEAR(n * sin(*t), sin(i), kUlps) << i_deg << ' ' << n;
            }
        }
}

TEST(RefractionAngle, IsTheIncidenceWithoutAnInterface) {
    for (double i_deg : {0.0, 1.0, 45.0, 89.0, 89.999999, 90.0})
        EXPECT_NEAR(refraction_angle(i_deg * unit::deg, {1.0})->to(unit::deg), i_deg, 1e-13)
            << i_deg;
}

TEST(CriticalAngle, IsWhereTheRefractedRayGrazes) {
    EXPECT_FALSE(critical_angle({1.0}).has_value());
    EXPECT_FALSE(critical_angle({1.5}).has_value());
    for (double n : {0.1, 0.5, 0.75, 0.99})
        EXPECT_NEAR(critical_angle({n})->to(unit::rad), std::asin(n), kAngleError_rad) << n;
    EXPECT_NEAR(critical_angle({1.0 / 1.5})->to(unit::deg), 41.8103,
                5e-5);  // glass to air, as known
}

TEST(BrewsterAngle, IsWhereReflectedAndRefractedRaysAreAtRightAngles) {
    for (double n : {0.4, 1.333, 1.5168, 2.417}) {
        const Angle i = brewster_angle({n});
        const Angle t = refraction_angle(i, {n}).value();
        EXPECT_NEAR((i + t).to(unit::deg), 90.0, 1e-13) << n;
    }
}

// ---- a prism, traced ----

struct Ray2 {
    double x, y;
};

/// The direction after an interface with unit normal `normal` (against `d`); from the vector form
/// of Snell's law in the plane, which knows neither angles nor asin.
std::optional<Ray2> refracted(Ray2 d, Ray2 normal, double n) {
    const double cos_i = -(d.x * normal.x + d.y * normal.y);
    const double tangent_x = d.x + cos_i * normal.x, tangent_y = d.y + cos_i * normal.y;
    const double s2 = (tangent_x * tangent_x + tangent_y * tangent_y) / (n * n);
    if (s2 > 1.0) return std::nullopt;
    const double cos_t = std::sqrt(1.0 - s2);
    return Ray2{tangent_x / n - cos_t * normal.x, tangent_y / n - cos_t * normal.y};
}

/// Deviation of a ray in rad through a prism of apex angle `apex` (above), entering at `incidence`
/// from below the left face's normal.
std::optional<double> traced_deviation(double apex, double n, double incidence) {
    const Ray2 left{-std::cos(apex / 2), std::sin(apex / 2)};
    const Ray2 right{std::cos(apex / 2), std::sin(apex / 2)};
    // Minus the normal, turned up by the incidence: counted from the normal away from the apex.
    const double a = std::atan2(-left.y, -left.x) + incidence;
    const Ray2 d{std::cos(a), std::sin(a)};
    const auto inside = refracted(d, left, n);
    if (!inside) return std::nullopt;
    const auto out = refracted(*inside, {-right.x, -right.y}, 1.0 / n);
    if (!out) return std::nullopt;
    return std::abs(std::atan2(d.x * out->y - d.y * out->x, d.x * out->x + d.y * out->y));
}

constexpr double kDeviationError_rad = 1e-14;

TEST(MinimumDeviation, IsTheLeastOfAllTracedRays) {
    for (double apex_deg : {20.0, 45.0, 60.0})
        for (double n : {1.333, 1.5168, 1.7}) {
            const double apex = apex_deg * unit::deg.to(unit::rad);
            const double expected =
                minimum_deviation(apex_deg * unit::deg, {n}).value().to(unit::rad);
            const double best_incidence = std::asin(n * std::sin(apex / 2));
            EXPECT_NEAR(traced_deviation(apex, n, best_incidence).value(), expected,
                        kDeviationError_rad);
            double least = std::numeric_limits<double>::infinity();
            for (double i = 0.0; i < std::numbers::pi / 2; i += 1e-4)
                least = std::min(least, traced_deviation(apex, n, i).value_or(least));
            EXPECT_GE(least, expected - kDeviationError_rad) << apex_deg << ' ' << n;
            EXPECT_NEAR(least, expected, 1e-8) << apex_deg << ' ' << n;  // half a step, squared
            for (double side : {-1.0, 1.0}) {
                const double beside = best_incidence + side * unit::deg.to(unit::rad);
                EXPECT_GT(traced_deviation(apex, n, beside).value(), expected + 1e-5);
            }
        }
}

TEST(MinimumDeviation, IsNothingWhereNoRayPasses) {
    EXPECT_FALSE(minimum_deviation(60.0 * unit::deg, {2.1}).has_value());
    EXPECT_TRUE(minimum_deviation(60.0 * unit::deg, {1.9}).has_value());
}

}  // namespace
}  // namespace dewbow
