// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_sizes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

using namespace unit;

const std::vector<std::string> kContinuous = {"normal:mean=0.5mm,width=10%",
                                              "normal:mean=10um,width=20%",
                                              "lognormal:mean=0.3mm,width=5%",
                                              "lognormal:mean=10um,width=50%",
                                              "gamma:mean=0.2mm,width=30%",
                                              "gamma:mean=5um,width=100%",
                                              "gamma:effective-radius=10um,effective-variance=0.1",
                                              "gamma:mean=0.1mm,width=4%",
                                              "deirmendjian:cloud-c1",
                                              "deirmendjian:haze-m",
                                              "deirmendjian:haze-l",
                                              "deirmendjian:alpha=8,gamma=3,mode=4um",
                                              "fog:strong-advection",
                                              "fog:moderate-spray",
                                              "rain:marshall-palmer,rate=1mm/h",
                                              "rain:marshall-palmer,rate=100mm/h",
                                              "rain:ulbrich,rate=20mm/h,shape=3"};

/// ∫ n r^power dr over ln r, by Gauss's rule in many panels: knows nothing of gamma functions.
double integral(const DropSizes& sizes, double power, Length from, Length to) {
    static const QuadratureRule rule = gauss_legendre(16);
    constexpr int kPanels = 400;
    const double a = std::log(from.to(m)), width = (std::log(to.to(m)) - a) / kPanels;
    double sum = 0.0;
    for (int i = 0; i < kPanels; ++i)
        sum += integrate(rule, a + i * width, a + (i + 1) * width, [&](double u) {
            return sizes.density(std::exp(u) * m) * std::exp((power + 1.0) * u);
        });
    return sum;
}
/// Where nothing lies beyond: raindrops have an end.
Length end_of(const DropSizes& sizes) {
    return sizes.describe().starts_with("rain") ? kLargestRaindrop : 10.0 * sizes.largest();
}
double integral(const DropSizes& sizes, double power) {
    return integral(sizes, power, 1e-10 * sizes.smallest(), end_of(sizes));
}

/// Of the oracle, over panels of a tenth of an e-fold.
constexpr double kIntegral = 1e-9;
/// A normal distribution counts the drops of negative radius, 3e-7 of the number at 20 %.
constexpr double kNegativeRadii = 1e-6;

double integral_error(const std::string& text) {
    return text.starts_with("normal") ? kNegativeRadii : kIntegral;
}

TEST(DropSizes, DensityAndMomentsAgree) {
    for (const std::string& text : kContinuous) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        for (const double power : {0.0, 1.0, 2.0, 7.0 / 3.0, 3.0, 6.0})
            EXPECT_NEAR(integral(*sizes, power) / sizes->mean_power(power), 1.0,
                        integral_error(text))
                << text << " " << power;
    }
}

TEST(DropSizes, LittleCrossSectionLiesOutside) {
    // The header promises 1e-6; too wide a range would cost radii.
    for (const std::string& text : kContinuous) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        const double whole = integral(*sizes, 2.0);
        EXPECT_LT(sizes->smallest(), sizes->largest()) << text;
        const double below =
            integral(*sizes, 2.0, 1e-10 * sizes->smallest(), sizes->smallest()) / whole;
        const double above = integral(*sizes, 2.0, sizes->largest(), end_of(*sizes)) / whole;
        EXPECT_LT(below + above, 1e-6) << text;
        EXPECT_GT(below + above, 1e-12) << text;
    }
}

TEST(DropSizes, MeanAndWidthAreAsAsked) {
    constexpr double kRounding = 1e-12;
    for (const char* text : {"normal:mean=0.4mm,width=15%", "lognormal:mean=0.4mm,width=15%",
                             "gamma:mean=0.4mm,width=15%"}) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        EXPECT_NEAR(mean_radius(*sizes).to(mm), 0.4, 0.4 * kRounding) << text;
        EXPECT_NEAR(relative_width(*sizes), 0.15, kRounding) << text;
        EXPECT_NEAR(mean_cross_section(*sizes).to(mm * mm),
                    std::numbers::pi * 0.16 * (1.0 + 0.15 * 0.15), kRounding)
            << text;
    }
    const DropSizesPtr hansen =
        parse_drop_sizes("gamma:effective-radius=10um,effective-variance=0.1");
    EXPECT_NEAR(effective_radius(*hansen).to(um), 10.0, 10.0 * kRounding);
    // v_eff = ⟨r²⟩⟨r⁴⟩ / ⟨r³⟩² − 1                                [Hansen & Travis 1974, eq. 2.54]
    EXPECT_NEAR(
        hansen->mean_power(2.0) * hansen->mean_power(4.0) / std::pow(hansen->mean_power(3.0), 2) -
            1.0,
        0.1, kRounding);
    EXPECT_EQ(relative_width(*single_drop_size(0.5 * mm)), 0.0);
    EXPECT_NEAR(effective_radius(*single_drop_size(0.5 * mm)).to(mm), 0.5, kRounding);
}

TEST(DropSizes, CloudC1IsDeirmendjians) {
    // n = 2.373 r⁶ e^{−1.5 r} per cm³ and µm, 100 drops per cm³; four digits. Mode 4 µm, and
    // r_eff = (α + 3) / b = 6 µm.                                   [Deirmendjian 1969, p. 78]
    const DropSizesPtr cloud = parse_drop_sizes("deirmendjian:cloud-c1");
    for (const double r : {1.0, 4.0, 10.0})
        EXPECT_NEAR(100.0 * cloud->density(r * um) * 1e-6,
                    2.373 * std::pow(r, 6) * std::exp(-1.5 * r), 3e-4 * 100.0 * 0.25)
            << r;
    EXPECT_GT(cloud->density(4.0 * um), cloud->density(3.9 * um));
    EXPECT_GT(cloud->density(4.0 * um), cloud->density(4.1 * um));
    EXPECT_NEAR(effective_radius(*cloud).to(um), 6.0, 1e-12);
    // The published b of haze M and L, with r in µm: n r^{−α} falls by e^{−b} from 0 to 1 µm.
    const struct {
        const char* name;
        double alpha, b;
    } hazes[] = {{"deirmendjian:haze-m", 1.0, 8.9443}, {"deirmendjian:haze-l", 2.0, 15.1186}};
    for (const auto& haze : hazes) {
        const DropSizesPtr sizes = parse_drop_sizes(haze.name);
        const double r = 1e-8;  // µm: b √r is 1e-3
        const double slope =
            std::log(sizes->density(r * um) * std::pow(r, -haze.alpha) / sizes->density(1.0 * um)) /
            (1.0 - std::sqrt(r));
        EXPECT_NEAR(slope, haze.b, 1e-4) << haze.name;
    }
}

TEST(DropSizes, FogsHaveTheirRadii) {
    // r_eff = (α + 3) / b with b = α / r_c: 0.3, 0.375, 1.5 and 3 per µm.
    const struct {
        const char* name;
        double effective_um;
    } fogs[] = {{"fog:strong-advection", 20.0},
                {"fog:moderate-advection", 16.0},
                {"fog:strong-spray", 6.0},
                {"fog:moderate-spray", 3.0}};
    for (const auto& fog : fogs)
        EXPECT_NEAR(effective_radius(*parse_drop_sizes(fog.name)).to(um), fog.effective_um, 1e-12)
            << fog.name;
}

TEST(DropSizes, MarshallAndPalmersRainFalls) {
    // The rate of 8000 drops / m³ mm that fall at 17.67 (D/cm)^0.67 m/s [Atlas & Ulbrich 1977]
    // comes out near the rate put in, for 1 to 25 mm/h, Marshall and Palmer's range. Theirs was a
    // fit.
    constexpr double kOwnRange = 0.2;
    for (const double rate : {1.0, 5.0, 25.0}) {
        const double slope_per_mm = 4.1 * std::pow(rate, -0.21);
        const DropSizesPtr rain = marshall_palmer_drop_sizes(rate);
        // Drops a cubic metre, all sizes up to the cut.
        const double number = 8000.0 / slope_per_mm * (1.0 - std::exp(-5.0 * slope_per_mm));
        // mm/h = 3600 s/h · 1e3 mm/m · volume in m³ · speed in m/s
        const double fallen = 3600.0 * 1e3 * number * std::numbers::pi / 6.0 * 17.67 *
                              std::pow(2.0, 3.67) * std::pow(100.0, 0.67) * rain->mean_power(3.67);
        EXPECT_NEAR(fallen / rate, 1.0, kOwnRange) << rate;
        EXPECT_NEAR(rain->number_per_m3().value_or(0.0) / number, 1.0, 1e-9);
        EXPECT_NEAR(std::log(rain->density(0.5 * mm) / rain->density(1.0 * mm)), slope_per_mm,
                    1e-12);
        EXPECT_EQ(rain->density(2.501 * mm), 0.0);
    }
}

TEST(DropSizes, UlbrichsRainFallsAtItsRate) {
    // Next to nothing of the volume lies beyond the cut at 5 mm/h.
    for (const double shape : {0.0, 2.0, 5.0}) {
        const DropSizesPtr rain = ulbrich_drop_sizes(5.0, shape);
        // N0 from the tail of small drops: N(D) = N0 D^μ e^{−ΛD}, here per number of all.
        const double slope_per_cm =
            2.0 *
            (std::log(rain->density(0.4 * mm) / rain->density(0.8 * mm)) + shape * std::log(2.0)) /
            0.08 / 2.0;
        const double number = 6e4 * std::exp(3.2 * shape) * std::tgamma(shape + 1.0) /
                              std::pow(slope_per_cm, shape + 1.0);
        const double fallen = 3600.0 * 1e3 * number * std::numbers::pi / 6.0 * 17.67 *
                              std::pow(2.0, 3.67) * std::pow(100.0, 0.67) * rain->mean_power(3.67);
        EXPECT_NEAR(fallen / 5.0, 1.0, 2e-3) << shape;
        EXPECT_NEAR(rain->number_per_m3().value_or(0.0) / number, 1.0, 2e-3) << shape;
    }
    // Heavier rain has larger drops; a larger μ has fewer small ones.
    EXPECT_GT(effective_radius(*ulbrich_drop_sizes(50.0, 2.0)),
              effective_radius(*ulbrich_drop_sizes(5.0, 2.0)));
    EXPECT_LT(relative_width(*ulbrich_drop_sizes(5.0, 4.0)),
              relative_width(*ulbrich_drop_sizes(5.0, 1.0)));
}

TEST(ParseDropSizes, DescriptionsParseAgain) {
    for (const std::string& text : kContinuous) {
        const DropSizesPtr sizes = parse_drop_sizes(text);
        const DropSizesPtr again = parse_drop_sizes(sizes->describe());
        EXPECT_EQ(sizes->describe(), again->describe());
        EXPECT_NEAR(again->mean_power(2.0) / sizes->mean_power(2.0), 1.0, 1e-12) << text;
    }
    EXPECT_EQ(parse_drop_sizes(" 0.5 mm ")->describe(), "0.5mm");
    EXPECT_EQ(parse_drop_sizes("10µm")->describe(), "10um");

    EXPECT_NEAR(parse_drop_sizes("1e-5m")->largest() / parse_drop_sizes("10um")->largest(), 1.0,
                1e-15);
    EXPECT_EQ(parse_drop_sizes("normal: mean = 0.5mm , width = 0.1")->describe(),
              "normal:mean=0.5mm,width=10%");
}

std::string refusal(const std::string& text) {
    try {
        parse_drop_sizes(text);
    } catch (const InputError& error) {
        return error.sentence() + " | " + error.hint();
    }
    return "accepted";
}

TEST(ParseDropSizes, RefusesWithOneSentence) {
    const struct {
        const char *text, *refusal;
    } cases[] = {
        {"0mm", "radius of drops is 0 mm; expected 1 nm to 10 mm | "},
        {"-1mm", "radius of drops is -1 mm; expected 1 nm to 10 mm | "},
        {"nanmm", "radius of drops is nan mm; expected 1 nm to 10 mm | "},
        {"infmm", "radius of drops is inf mm; expected 1 nm to 10 mm | "},
        {"1m", "radius of drops is 1000 mm; expected 1 nm to 10 mm | "},
        {"0.5", "radius 0.5 has no unit; expected one such as 0.5mm | "},
        {"0.5mn", "radius 0.5mn has the unknown unit \"mn\" | did you mean \"nm\"?"},
        {"norml:mean=1mm,width=10%", "unknown drop sizes \"norml\" | did you mean \"normal\"?"},
        {"normal:mean=1mm", "normal drop sizes without width; expected one such as width=10% | "},
        {"normal:maen=1mm,width=10%",
         "normal drop sizes without mean; expected one such as mean=0.5mm | \"maen\" is nearly "
         "mean"},
        {"normal:mean=1mm,width=10%,order=2",
         "normal drop sizes have no order, or not with the others or twice | expected one of mean, "
         "width"},
        {"normal:mean=0mm,width=10%", "mean radius of drops is 0 mm; expected 1 nm to 10 mm | "},
        {"normal:mean=1mm,width=0%", "width 0 of normal drop sizes; expected above 0 to 20% | "},
        {"normal:mean=1mm,width=nan", "width nan of normal drop sizes; expected above 0 to 20% | "},
        {"normal:mean=1mm,width=wide",
         "width \"wide\" is no share; expected one such as 10% or 0.1 | "},
        {"normal:mean=1mm,width=50%",
         "width 0.5 of normal drop sizes; expected above 0 to 20% | wider ones would have drops of "
         "negative radius: lognormal and gamma have none"},
        {"deirmendjian:cloud-c2", "unknown deirmendjian \"cloud-c2\" | did you mean \"cloud-c1\"?"},
        {"deirmendjian:alpha=-1,gamma=1,mode=1um", "alpha -1 of drop sizes; expected 0.1 to 20 | "},
        {"fog",
         "fog without its kind; expected one such as fog:strong-advection | expected one of "
         "strong-advection, moderate-advection, strong-spray, moderate-spray"},
        {"fog:strong-advection,rate=1mm/h",
         "fog drop sizes have no rate, or not with the others or twice | "},
        {"rain:marshall-palmer",
         "rain drop sizes without rate; expected one such as rate=5mm/h | "},
        {"rain:marshall-plamer,rate=5mm/h",
         "unknown rain \"marshall-plamer\" | did you mean \"marshall-palmer\"?"},
        {"rain:marshall-palmer,rate=5",
         "rate \"5\" is no rain rate; expected one such as 5mm/h | "},
        {"rain:marshall-palmer,rate=0mm/h", "rain rate 0 mm/h; expected 0.01 to 300 mm/h | "},
        {"rain:ulbrich,rate=5mm/h,shape=-1", "shape -1 of Ulbrich's raindrops; expected 0 to 6 | "},
        {"gamma:effective-radius=10um,effective-variance=0.5",
         "effective variance 0.5; expected above 0 to 1/3 | "},
        {"gamma:effective-radius=10um,effective-variance=0.1,mean=1mm",
         "gamma drop sizes have no mean, or not with the others or twice | expected one of "
         "effective-radius, effective-variance"},
    };
    for (const auto& c : cases) EXPECT_EQ(refusal(c.text), c.refusal) << c.text;
    EXPECT_TRUE(refusal("").starts_with("no drop sizes | expected a radius such as 0.5mm"));
    EXPECT_TRUE(refusal("fish").starts_with("unknown drop sizes \"fish\" | expected a radius"));
    EXPECT_TRUE(refusal(":").starts_with("no drop sizes | "));
}

}  // namespace
}  // namespace dewbow
