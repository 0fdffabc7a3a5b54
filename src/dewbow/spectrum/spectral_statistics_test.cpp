// SPDX-License-Identifier: Apache-2.0
// What the paper says of the sums of 13 samples [Musgrave 1989, 4.2.1], and the sizes of it: closed
// forms where jitter is independent, and the sampler itself against them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "dewbow/math/quadrature.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"
#include "dewbow/spectrum/spectral_samples.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {
namespace {

using Channels = std::array<double, 3>;

/// Sums of a dozen numbers between 0 and 1.
constexpr double kRounding = 1e-13;
/// Numbers that are known by two or three digits.
constexpr double kTwoDigits = 0.005, kThreeDigits = 0.0005;

// ---- closed forms ------------------------------------------------------------------------------
// The linear model's curves are straight within an interval, so that a sample that is uniform in it
// has a colour uniform between the nodes: a channel's sum over the set is its white plus a sum of
// independent numbers, each uniform over an interval centred at 0 as wide as the curve rises there.

/// How far the curves rise in each interval, as a share of white.
std::vector<Channels> rises() {
    std::vector<Channels> all;
    for (int k = 0; k < kPaperSamples; ++k) {
        const auto from = linear_spectrum_colour(double(k) / kPaperSamples);
        const auto to = linear_spectrum_colour((k + 1.0) / kPaperSamples);
        all.push_back({std::abs(to[0] - from[0]) / kPaperWhite,
                       std::abs(to[1] - from[1]) / kPaperWhite,
                       std::abs(to[2] - from[2]) / kPaperWhite});
    }
    return all;
}
std::vector<double> rises_of(std::size_t channel) {
    std::vector<double> widths;
    for (const Channels& rise : rises())
        if (rise[channel] > 0.0) widths.push_back(rise[channel]);
    return widths;
}

/// A sum of independent numbers, uniform with these widths around 0.
class UniformSum {
public:
    explicit UniformSum(std::vector<double> widths) : widths_(std::move(widths)) {}

    double sd() const {
        double variance = 0.0;
        for (double w : widths_) variance += w * w / 12.0;
        return std::sqrt(variance);
    }
    /// ∫ e^{itx} p(x) dx = Π sin(wt/2) / (wt/2)
    double characteristic(double t) const {
        double product = 1.0;
        for (double w : widths_) product *= t == 0.0 ? 1.0 : std::sin(0.5 * w * t) / (0.5 * w * t);
        return product;
    }
    /// P(sum <= x) = 1/2 + 1/π ∫ sin(tx)/t φ(t) dt.                             [Gil-Pelaez 1951]
    double cdf(double x) const {
        const auto integrand = [&](double t) { return std::sin(t * x) / t * characteristic(t); };
        return 0.5 + over_half_line(integrand) / std::numbers::pi;
    }
    /// E |sum| / copies of the sum of `copies` such sums = 2/π ∫ (1 − φ(t)) / t² dt.
    double mean_size_of_mean(int copies) const {
        const auto integrand = [&](double t) {
            return (1.0 - std::pow(characteristic(t / copies), copies)) / (t * t);
        };
        // Beyond the end φ is nought and 1/t² integrates to 1/end.
        return 2.0 / std::numbers::pi * (over_half_line(integrand) + 1.0 / kEnd);
    }

private:
    /// The widths are about 0.1, and φ falls at least as 1/t²: what is left out is below 1e-6.
    static constexpr double kEnd = 4000.0;
    static double over_half_line(const std::function<double(double)>& integrand) {
        constexpr int kPanels = 80;
        static const QuadratureRule kRule = gauss_legendre(32);
        double sum = 0.0;
        for (int i = 0; i < kPanels; ++i)
            sum += integrate(kRule, kEnd * i / kPanels, kEnd * (i + 1) / kPanels, integrand);
        return sum;
    }
    std::vector<double> widths_;
};

/// P(no channel's sum is above 1 + `margin`). Red and blue share the last interval and green none
/// with them, so that given that interval's sample all three are independent.
double chance_of_none_above(double margin) {
    const auto rise = rises();
    std::vector<double> red, blue;
    for (const Channels& r : rise) {
        EXPECT_TRUE(r[1] == 0.0 || (r[0] == 0.0 && r[2] == 0.0));
        if (&r == &rise.back()) continue;
        EXPECT_TRUE(r[0] == 0.0 || r[2] == 0.0);
        if (r[0] > 0.0) red.push_back(r[0]);
        if (r[2] > 0.0) blue.push_back(r[2]);
    }
    const double shared = rise.back()[0];
    EXPECT_EQ(shared, rise.back()[2]);
    const UniformSum red_rest(red), blue_rest(blue), green(rises_of(1));
    const auto both = [&](double x) {
        return red_rest.cdf(margin - x) * blue_rest.cdf(margin - x) / shared;
    };
    static const QuadratureRule kRule = gauss_legendre(16);
    const double red_and_blue =
        integrate(kRule, -0.5 * shared, 0.0, both) + integrate(kRule, 0.0, 0.5 * shared, both);
    return green.cdf(margin) * red_and_blue;
}

/// Above 255 when it is rounded.
constexpr double kOverflow = 0.5 / 255.0;

TEST(SpectralStatistics, ClosedForms) {
    const Channels sd{0.083, 0.048, 0.068};
    const Channels clamped{0.966, 0.981, 0.972}, clamped_16{0.992, 0.995, 0.993};
    for (std::size_t c = 0; c < 3; ++c) {
        const UniformSum sum(rises_of(c));
        EXPECT_NEAR(sum.sd(), sd[c], kThreeDigits);
        EXPECT_NEAR(sum.cdf(0.0), 0.5, kRounding);
        // E min(1 + s, 1) = 1 − E|s| / 2 for what is symmetric.
        EXPECT_NEAR(1.0 - 0.5 * sum.mean_size_of_mean(1), clamped[c], kThreeDigits);
        EXPECT_NEAR(1.0 - 0.5 * sum.mean_size_of_mean(16), clamped_16[c], kThreeDigits);
    }
    EXPECT_NEAR(1.0 - chance_of_none_above(0.0), 0.84, kTwoDigits);
    EXPECT_NEAR(1.0 - chance_of_none_above(kOverflow), 0.83, kTwoDigits);
}

TEST(SpectralStatistics, ClosedFormsAgreeWithElementaryOnes) {
    // E|s| of one uniform number of width w is w/4, of two w/3, of four 7w/15.  [Irwin 1927, Hall
    // 1927]
    constexpr double kQuadrature = 1e-6;
    EXPECT_NEAR(UniformSum({0.1}).mean_size_of_mean(1), 0.1 / 4.0, 1e-5);  // φ falls as 1/t only
    EXPECT_NEAR(UniformSum({0.1, 0.1}).mean_size_of_mean(1), 0.1 / 3.0, kQuadrature);
    EXPECT_NEAR(UniformSum({0.1, 0.1, 0.1, 0.1}).mean_size_of_mean(1), 0.7 / 15.0, kQuadrature);
    EXPECT_NEAR(UniformSum({0.1, 0.1}).cdf(0.05), 1.0 - 0.125, kQuadrature);
}

// ---- the sampler -------------------------------------------------------------------------------

constexpr int kSets = 1 << 18;
/// Each comparison is a false alarm with probability 6e-7; there are 14 in a run.
constexpr double kSigmas = 5.0;

/// The numbers of one set, from independent uniform ones.
using Offsets = std::function<void(std::vector<double>&)>;
void as_they_are(std::vector<double>&) {}

struct Measured {
    Channels sd{}, above{}, clamped{}, clamped_16{};
    double any_above = 0.0, overflow = 0.0;
};
Measured measure(const Offsets& change) {
    const PreparedSpectralSampling prepared(make_spectral_model({}), {.jitter = Jitter::both});
    std::mt19937_64 random(1989);
    std::vector<double> offsets(prepared.offset_count());
    std::vector<SpectralSample> samples(offsets.size());
    Measured m;
    Channels of_16{};
    for (int i = 0; i < kSets; ++i) {
        for (double& u : offsets) u = double(random() >> 11) * 0x1p-53;
        change(offsets);
        draw_spectral_samples(prepared, offsets, samples);
        Channels sum{};
        for (const SpectralSample& sample : samples)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += sample.rgb[c];
        const double most = std::max({sum[0], sum[1], sum[2]});
        m.any_above += (most > 1.0) / double(kSets);
        m.overflow += (most >= 1.0 + kOverflow) / double(kSets);
        for (std::size_t c = 0; c < 3; ++c) {
            m.sd[c] += (sum[c] - 1.0) * (sum[c] - 1.0) / kSets;
            m.above[c] += (sum[c] > 1.0) / double(kSets);
            m.clamped[c] += std::min(sum[c], 1.0) / kSets;
            of_16[c] += sum[c] / 16.0;
            if (i % 16 != 15) continue;
            m.clamped_16[c] += std::min(of_16[c], 1.0) / (kSets / 16);
            of_16[c] = 0.0;
        }
    }
    for (double& value : m.sd) value = std::sqrt(value);
    return m;
}

/// The largest distance from the closed forms, in standard errors.
double worst_deviation(const Measured& m) {
    double worst = 0.0;
    const auto compare = [&](double measured, double expected, double error) {
        worst = std::max(worst, std::abs(measured - expected) / error);
    };
    const auto compare_chance = [&](double measured, double p) {
        compare(measured, p, std::sqrt(p * (1.0 - p) / kSets));
    };
    for (std::size_t c = 0; c < 3; ++c) {
        const UniformSum sum(rises_of(c));
        const double sd = sum.sd();
        // The kurtosis of such sums is at most 3, and a clamped sum has half the variance at most.
        compare(m.sd[c], sd, sd / std::sqrt(2.0 * kSets));
        compare_chance(m.above[c], 0.5);
        const double error = sd / std::sqrt(2.0 * kSets);
        compare(m.clamped[c], 1.0 - 0.5 * sum.mean_size_of_mean(1), error);
        compare(m.clamped_16[c], 1.0 - 0.5 * sum.mean_size_of_mean(16), error);
    }
    compare_chance(m.any_above, 1.0 - chance_of_none_above(0.0));
    compare_chance(m.overflow, 1.0 - chance_of_none_above(kOverflow));
    return worst;
}

TEST(SpectralStatistics, IndependentJitterIsAsTheClosedFormsSay) {
    EXPECT_LT(worst_deviation(measure(as_they_are)), kSigmas);
}

TEST(SpectralStatistics, PlantedFaultsAreSeen) {
    const Offsets faults[] = {
        // only over the middle 98 % of the interval
        [](auto& u) {
            for (double& x : u) x = 0.01 + 0.98 * x;
        },
        // one offset for two intervals
        [](auto& u) { u[4] = u[3]; },
        // the last interval, which red and blue share, taken twice
        [](auto& u) { u[6] = u[12]; },
        // only over the first 98 % of the interval
        [](auto& u) {
            for (double& x : u) x = 0.98 * x;
        },
    };
    for (const Offsets& fault : faults) EXPECT_GT(worst_deviation(measure(fault)), 2.0 * kSigmas);
}

// ---- common offsets and other numbers of samples ----------------------------------------------

/// The least and greatest sum of a set over common offsets, a channel each.
struct Range {
    Channels least{9.0, 9.0, 9.0}, greatest{-9.0, -9.0, -9.0};
    void add(const Channels& sum) {
        for (std::size_t c = 0; c < 3; ++c) {
            least[c] = std::min(least[c], sum[c]);
            greatest[c] = std::max(greatest[c], sum[c]);
        }
    }
};
constexpr int kOffsets = 2000;

Range range_over_offsets(const SpectralModelSettings& settings, const SpectralSampling& sampling) {
    const PreparedSpectralSampling prepared(make_spectral_model(settings), sampling);
    std::vector<SpectralSample> samples(std::size_t(sampling.samples));
    Range range;
    for (int i = 0; i < kOffsets; ++i) {
        const double offset = (i + 0.5) / kOffsets;
        draw_spectral_samples(prepared, {&offset, 1}, samples);
        Channels sum{};
        for (const SpectralSample& sample : samples)
            for (std::size_t c = 0; c < 3; ++c) sum[c] += sample.rgb[c];
        range.add(sum);
    }
    return range;
}

void expect_range(const Range& range, const Channels& least, const Channels& greatest,
                  double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(range.least[c], least[c], tolerance) << c;
        EXPECT_NEAR(range.greatest[c], greatest[c], tolerance) << c;
    }
}

const SpectralSampling kCorrelated{.jitter = Jitter::both, .correlated = true};

TEST(SpectralStatistics, ThirteenAtACommonOffsetAreWhiteWithTheLinearModel) {
    const Channels one{1.0, 1.0, 1.0};
    for (auto spacing : {SpectralSpacing::frequency, SpectralSpacing::wavelength})
        expect_range(range_over_offsets({.spacing = spacing}, kCorrelated), one, one, kRounding);
}

TEST(SpectralStatistics, OtherNumbersOfFixedSamplesTintWhite) {
    const auto tint = [](int samples) {
        return PreparedSpectralSampling(make_spectral_model({}), {.samples = samples}).raw_tint();
    };
    const Channels five{1.127, 0.932, 1.083}, seven{1.128, 0.995, 1.061};
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(tint(5)[c], five[c], kThreeDigits);
        EXPECT_NEAR(tint(7)[c], seven[c], kThreeDigits);
        for (int multiple : {13, 26, 39, 104}) EXPECT_NEAR(tint(multiple)[c], 1.0, kRounding);
        EXPECT_NEAR(tint(31)[c], 1.0, 0.0035);
        EXPECT_GT(std::abs(tint(31)[c] - 1.0), 0.0005);
    }
}

TEST(SpectralStatistics, OtherCurvesAreWhiteOnlyOnAverage) {
    // On sRGB, evenly in wavelength, and on the default monitor, evenly in frequency.
    expect_range(range_over_offsets({SpectralColours::empirical, SpectralSpacing::wavelength,
                                     NegativeColours::clamp, "srgb"},
                                    kCorrelated),
                 {0.987, 0.996, 0.959}, {1.008, 1.004, 1.026}, kThreeDigits);
    expect_range(range_over_offsets({.colours = SpectralColours::empirical}, kCorrelated),
                 {0.990, 0.984, 0.993}, {1.009, 1.010, 1.014}, kThreeDigits);
    expect_range(range_over_offsets({.colours = SpectralColours::cie}, kCorrelated),
                 {0.959, 0.994, 0.989}, {1.027, 1.007, 1.009}, kThreeDigits);
}

TEST(SpectralStatistics, TailoredSamplesAreLessWhiteAtACommonOffset) {
    SpectralSampling tailored = kCorrelated;
    tailored.tailored = true;
    expect_range(range_over_offsets({}, tailored), {0.943, 0.994, 0.940}, {1.070, 1.013, 1.062},
                 kThreeDigits);
    expect_range(range_over_offsets({.colours = SpectralColours::cie}, tailored),
                 {0.871, 0.990, 0.872}, {1.125, 1.019, 1.128}, kThreeDigits);
}

TEST(SpectralStatistics, UniformLanesUnderEqualEnergyAreWhiteOnlyOnAverage) {
    const auto range_of = [](int lanes) {
        const auto white = rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(*make_constant(1.0)));
        const std::vector<double> ones(std::size_t(lanes), 1.0);
        Range range;
        for (int i = 0; i < kOffsets; ++i) {
            const auto packet = sample_wavelengths(WavelengthSampling::uniform, lanes,
                                                   (i + 0.5) / (kOffsets * double(lanes)));
            const auto sum = rgb_from_xyz<LinearSrgb>(xyz_from_lanes(packet, ones));
            range.add({sum[0] / white[0], sum[1] / white[1], sum[2] / white[2]});
        }
        return range;
    };
    expect_range(range_of(8), {0.90, 0.92, 0.79}, {1.10, 1.08, 1.15}, kTwoDigits);
    expect_range(range_of(16), {0.995, 0.997, 0.958}, {1.005, 1.003, 1.038}, 0.0011);
}

// ---- tailored samples --------------------------------------------------------------------------

Channels roots(const Channels& squares) {
    return {std::sqrt(squares[0]), std::sqrt(squares[1]), std::sqrt(squares[2])};
}

/// Standard deviation of the sampler's white, its offsets on a grid.
Channels sampled_sd(SpectralColours colours, bool tailored) {
    const PreparedSpectralSampling prepared(make_spectral_model({.colours = colours}),
                                            {.jitter = Jitter::both, .tailored = tailored});
    Channels variance{};
    constexpr int kSteps = 400;
    for (int k = 0; k < kPaperSamples; ++k) {
        Channels mean{}, square{};
        for (int i = 0; i < kSteps; ++i) {
            const auto rgb = prepared.sample(k, (i + 0.5) / kSteps).rgb;
            for (std::size_t c = 0; c < 3; ++c) {
                mean[c] += rgb[c] / kSteps;
                square[c] += rgb[c] * rgb[c] / kSteps;
            }
        }
        for (std::size_t c = 0; c < 3; ++c) variance[c] += square[c] - mean[c] * mean[c];
    }
    return roots(variance);
}

/// One of 13 intervals of equal area under s = |r| + |g| + |b|. For each channel d, integrals over
/// its part of f.
struct EqualArea {
    double width = 0.0, area = 0.0;
    Channels d{}, d_squared{}, d_squared_over_s{};
};
/// By sums over f: no quantile is looked for.
std::vector<EqualArea> equal_areas(SpectralColours colours) {
    constexpr int kCells = 1 << 16;  // the bounds of intervals move by half a cell at most
    constexpr double kWidth = 1.0 / kCells;
    const auto model = make_spectral_model({.colours = colours});
    const auto s_of = [](const MonitorRgb& d) {
        return std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
    };
    double whole = 0.0, below = 0.0;
    for (int i = 0; i < kCells; ++i) whole += kWidth * s_of(model->density((i + 0.5) * kWidth));
    std::vector<EqualArea> intervals(kPaperSamples);
    for (int i = 0; i < kCells; ++i) {
        const MonitorRgb d = model->density((i + 0.5) * kWidth);
        const double s = s_of(d);
        EqualArea& at = intervals[std::size_t(kPaperSamples * (below + 0.5 * kWidth * s) / whole)];
        below += kWidth * s;
        at.width += kWidth;
        at.area += kWidth * s;
        for (std::size_t c = 0; c < 3; ++c) {
            at.d[c] += kWidth * d[c];
            at.d_squared[c] += kWidth * d[c] * d[c];
            at.d_squared_over_s[c] += kWidth * d[c] * d[c] / s;
        }
    }
    return intervals;
}
/// A sample with the density s within its interval carries area d/s.
Channels tailored_sd(SpectralColours colours) {
    Channels variance{};
    for (const EqualArea& k : equal_areas(colours))
        for (std::size_t c = 0; c < 3; ++c)
            variance[c] += k.area * k.d_squared_over_s[c] - k.d[c] * k.d[c];
    return roots(variance);
}
/// One that is spread evenly within it carries width d.
Channels evenly_spread_sd(SpectralColours colours) {
    Channels variance{};
    for (const EqualArea& k : equal_areas(colours))
        for (std::size_t c = 0; c < 3; ++c)
            variance[c] += k.width * k.d_squared[c] - k.d[c] * k.d[c];
    return roots(variance);
}

void expect_sd(const Channels& sd, const Channels& expected, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(sd[c], expected[c], tolerance) << c;
}

/// Numbers that were integrated in closed form between the nodes of the linear curves, apart from
/// this program, to four digits and a half cell of equal_areas().
constexpr double kClosedForm = 0.00001;

TEST(SpectralStatistics, NoiseOfWhiteTailoredAndNot) {
    const auto expect = [](SpectralColours colours, bool tailored, const Channels& expected) {
        expect_sd(sampled_sd(colours, tailored), expected, kThreeDigits);
    };
    expect(SpectralColours::linear, false, {0.083, 0.048, 0.068});
    expect(SpectralColours::linear, true, {0.042, 0.057, 0.044});
    expect(SpectralColours::empirical, false, {0.159, 0.115, 0.103});
    expect(SpectralColours::empirical, true, {0.034, 0.067, 0.057});
    expect(SpectralColours::cie, false, {0.284, 0.180, 0.168});
    expect(SpectralColours::cie, true, {0.065, 0.065, 0.069});
}

TEST(SpectralStatistics, TailoredNoiseIsThatOfIntegralsOverTheSpectrum) {
    // The sampler's density is constant within its 3328 cells.
    constexpr double kOfCells = 1e-4;
    for (auto colours : {SpectralColours::linear, SpectralColours::empirical, SpectralColours::cie})
        expect_sd(sampled_sd(colours, true), tailored_sd(colours), kOfCells);
    expect_sd(tailored_sd(SpectralColours::linear), {0.04226, 0.05656, 0.04368}, kClosedForm);
}

TEST(SpectralStatistics, EvenlySpreadWithinEqualAreasIsNoisierThanNotTailored) {
    const Channels sd = evenly_spread_sd(SpectralColours::linear);
    expect_sd(sd, {0.12328, 0.05057, 0.07698}, kClosedForm);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_GT(sd[c], UniformSum(rises_of(c)).sd()) << c;
}

TEST(SpectralStatistics, WhiteLosesVioletFirstAndTurnsGreenishYellow) {
    // "edges which are blurred by dispersion such that they should appear with the color sequence
    // yellow-orange-red-black, actually appear greenish-yellow-red-black"
    const PreparedSpectralSampling prepared(make_spectral_model({}), {});
    const Channels expected[kPaperSamples] = {
        {.92, 1, .92},   {.75, 1, .75}, {.63, 1, .58}, {.58, 1, .42}, {.58, .96, .25},
        {.58, .83, .08}, {.58, .67, 0}, {.58, .50, 0}, {.54, .33, 0}, {.42, .17, 0},
        {.25, .04, 0},   {.08, 0, 0},   {0, 0, 0}};
    Channels left{1.0, 1.0, 1.0};
    for (int gone = 0; gone < kPaperSamples; ++gone) {
        const auto rgb = prepared.sample(kPaperSamples - 1 - gone, 0.0).rgb;
        for (std::size_t c = 0; c < 3; ++c) {
            left[c] -= rgb[c];
            EXPECT_NEAR(left[c], expected[gone][c], kTwoDigits + 1e-12) << gone << ' ' << c;
        }
    }
}

TEST(SpectralStatistics, ColorimetricCurvesHaveNoGreenEdge) {
    // How far green gets above red while violet, blue, green… are taken away.
    const auto greenest = [](SpectralColours colours) {
        const PreparedSpectralSampling prepared(
            make_spectral_model({.colours = colours, .monitor = "srgb"}), {});
        double most = 0.0, green_above_red = 0.0;
        for (int k = kPaperSamples - 1; k >= 0; --k) {
            const auto rgb = prepared.sample(k, 0.0).rgb;
            green_above_red += rgb[0] - rgb[1];
            most = std::max(most, green_above_red);
        }
        return most;
    };
    EXPECT_NEAR(greenest(SpectralColours::linear), 0.42, kTwoDigits);
    EXPECT_NEAR(greenest(SpectralColours::cie), 0.16, kTwoDigits);
    EXPECT_NEAR(greenest(SpectralColours::empirical), 0.03, kTwoDigits);
}

}  // namespace
}  // namespace dewbow
