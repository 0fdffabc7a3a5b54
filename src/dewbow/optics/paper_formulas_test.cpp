// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_formulas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/math/least_squares.h"
#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

const PaperFormula& formula(const std::string& text) {
    for (const PaperFormula& row : paper_formulas())
        if (row.text == text) return row;
    throw std::out_of_range(text);
}
IndexInAir glass(const char* name) { return index_in_air(make_dispersion(find_glass(name).data)); }

/// Worst error over the paper's spectrum of the formula that is fitted there.
double worst(const std::string& text, const char* name) {
    const auto samples = index_samples(glass(name), kPaperSpectrum);
    return index_error(formula(text).fit(samples), samples).worst;
}

constexpr const char* kSellmeierPrinted = "n² = 1 + b λ²/(c² − λ²), b > 0";
constexpr const char* kSellmeier = "n² = 1 + b λ²/(λ² − c²)";
constexpr const char* kHartmannPrinted = "n = 1 + b/(c − λ)";
constexpr const char* kHartmann = "n = n0 + b/(λ − c)^1.2";
constexpr const char* kHerzberger = "n = a + bλ² + cL + dL², L = 1/(λ² − 0.028), λ in µm";
constexpr const char* kHerzbergerPrinted = "n = a + bλ² + cL + dL², L = 1/(λ² − 0.028), λ in nm";

/// A formula written out here, and constants of it.
struct Case {
    const char* text;
    std::vector<double> constants;
    double (*index)(const std::vector<double>& c, double l);
};
double L(double l) { return 1.0 / (l * l - 0.028); }
const Case kCases[] = {
    {kSellmeierPrinted,
     {0.9, 1.1},
     [](const std::vector<double>& c, double l) {
         return std::sqrt(1.0 + c[0] * l * l / (c[1] * c[1] - l * l));
     }},
    {kSellmeier,
     {1.27, 0.11},
     [](const std::vector<double>& c, double l) {
         return std::sqrt(1.0 + c[0] * l * l / (l * l - c[1] * c[1]));
     }},
    {"n² = 1 + b λ²/(λ² − c²) − d λ²",
     {1.27, 0.11, 0.013},
     [](const std::vector<double>& c, double l) {
         return std::sqrt(1.0 + c[0] * l * l / (l * l - c[1] * c[1]) - c[2] * l * l);
     }},
    {"n = a + b/λ²",
     {1.3239, 0.0031163},
     [](const std::vector<double>& c, double l) { return c[0] + c[1] / (l * l); }},
    {"n = a + b/λ² + c/λ⁴",
     {1.5, 0.004, 1e-4},
     [](const std::vector<double>& c, double l) {
         return c[0] + c[1] / (l * l) + c[2] / (l * l * l * l);
     }},
    {kHartmannPrinted,
     {-0.25, 0.1},
     [](const std::vector<double>& c, double l) { return 1.0 + c[0] / (c[1] - l); }},
    {kHartmann,
     {1.48, 0.0068, 0.12},
     [](const std::vector<double>& c, double l) { return c[0] + c[1] / std::pow(l - c[2], 1.2); }},
    {"n = a + b/λ + c/λ²",
     {1.5, 0.005, 0.002},
     [](const std::vector<double>& c, double l) { return c[0] + c[1] / l + c[2] / (l * l); }},
    {"n = a + b/λ + c/λ^3.5",
     {1.49, 0.01, 3e-4},
     [](const std::vector<double>& c, double l) {
         return c[0] + c[1] / l + c[2] / (l * l * l * std::sqrt(l));
     }},
    {kHerzberger,
     {1.507, -0.0035, 0.0035, -4e-5},
     [](const std::vector<double>& c, double l) {
         return c[0] + c[1] * l * l + c[2] * L(l) + c[3] * L(l) * L(l);
     }},
};
/// Of constants that enter the index a thousandth as strongly as the first.
constexpr double kRecovered = 1e-5, kFitted = 1e-9;

TEST(PaperFormulas, RecoverTheirOwnConstants) {
    for (const Case& row : kCases) {
        std::vector<IndexSample> samples;
        for (double nm = 380.0; nm < 800.0; nm += 10.0)
            samples.push_back({nm, row.index(row.constants, 1e-3 * nm)});
        const FittedFormula fit = formula(row.text).fit(samples);
        ASSERT_EQ(fit.constants.size(), row.constants.size()) << row.text;
        for (std::size_t k = 0; k < row.constants.size(); ++k)
            EXPECT_NEAR(fit.constants[k], row.constants[k], kRecovered) << row.text << " " << k;
        EXPECT_LT(index_error(fit, samples).worst, kFitted) << row.text;
    }
}

// The constants are the two-point fit through n(480.0) = 1.3374 and n(670.8) = 1.3308, to the
// figures that the paper gives.
TEST(PaperFormulas, CauchysOfWaterAreATwoPointFit) {
    const std::vector<IndexSample> points{{480.0, 1.3374}, {670.8, 1.3308}};
    const FittedFormula fit = formula("n = a + b/λ²").fit(points);
    EXPECT_NEAR(fit.constants[0], 1.3239, 5.1e-5);
    EXPECT_NEAR(fit.constants[1], 3116.3e-6, 5.1e-8);
}

// Best constants for water at 20 °C in air over 405–670 nm, computed apart from this program:
// 1.32415, 3057.9 nm² with a worst error of 1.4e-4; 1.323514, 3403.31 nm², −4.3486e7 nm⁴ with
// 6.6e-5. Another grid of wavelengths moves b by a thousandth.
TEST(PaperFormulas, CauchysBestConstantsOfWater) {
    constexpr double kGrid = 2e-3;
    const auto samples = index_samples(glass("water"), kPaperWaterData);
    const FittedFormula two = formula("n = a + b/λ²").fit(samples);
    EXPECT_NEAR(two.constants[0], 1.32415, 6e-6);
    EXPECT_NEAR(two.constants[1] / 3057.9e-6, 1.0, kGrid);
    EXPECT_NEAR(index_error(two, samples).worst, 1.4e-4, 5e-6);
    const FittedFormula three = formula("n = a + b/λ² + c/λ⁴").fit(samples);
    EXPECT_NEAR(three.constants[0], 1.323514, 6e-6);
    EXPECT_NEAR(three.constants[1] / 3403.31e-6, 1.0, kGrid);
    EXPECT_NEAR(three.constants[2] / -4.3486e-5, 1.0, kGrid);
    EXPECT_NEAR(index_error(three, samples).worst, 6.6e-5, 2e-6);
}

// With b > 0 the printed Sellmeier has n < 1 beyond c, and rises with λ before it.
TEST(PaperFormulas, SellmeierAsPrintedIsNoGlass) {
    for (const char* name : {"water", "schott/N-BK7", "gem/diamond"}) {
        EXPECT_GT(worst(kSellmeierPrinted, name), 0.2) << name;
        EXPECT_LT(worst(kSellmeier, name), 6e-4) << name;
        const auto samples = index_samples(glass(name), kPaperSpectrum);
        const FittedFormula fit = formula(kSellmeierPrinted).fit(samples);
        EXPECT_GT(fit.constants[0], 0.0);
        EXPECT_GT(fit.index(800.0), fit.index(380.0));
    }
}

// Without n0 the curve is all but straight: its pole lies micrometres below 0.
TEST(PaperFormulas, HartmannAsPrintedIsAllButStraight) {
    for (const char* name : {"water", "schott/N-BK7", "schott/SF11"}) {
        EXPECT_GT(worst(kHartmannPrinted, name), 20.0 * worst(kHartmann, name)) << name;
        const auto samples = index_samples(glass(name), kPaperSpectrum);
        EXPECT_LT(formula(kHartmannPrinted).fit(samples).constants[1], -1.0) << name;
    }
}

// 0.028 nm² is nothing beside λ².
TEST(PaperFormulas, HerzbergerWithoutItsUnitIsASeries) {
    const auto samples = index_samples(glass("schott/SF11"), kPaperSpectrum);
    const FittedFormula fit = formula(kHerzbergerPrinted).fit(samples);
    for (const IndexSample& s : samples) {
        const double x = s.air_nm * s.air_nm;
        EXPECT_NEAR(fit.index(s.air_nm),
                    fit.constants[0] + fit.constants[1] * x + fit.constants[2] / x +
                        fit.constants[3] / (x * x),
                    1e-7);
    }
    EXPECT_GT(worst(kHerzbergerPrinted, "schott/SF11"), 2.0 * worst(kHerzberger, "schott/SF11"));
}

// ---- straight lines, by ways that share nothing with the fits ----

struct Point {
    double x, n;  ///< 1/λ in air, in 1/µm, which f is a line of but for the dispersion of air
};
std::vector<Point> points_of(const char* name) {
    std::vector<Point> points;
    const IndexInAir n = glass(name);
    for (double nm = 380.0; nm <= 800.0; nm += 1.0) points.push_back({1e3 / nm, n(nm)});
    return points;
}
/// Of least squares: cov(x, n) / var(x).
double regression_slope(const std::vector<Point>& points) {
    double mean = 0.0, variance = 0.0, covariance = 0.0;
    for (const Point& p : points) mean += p.x / double(points.size());
    for (const Point& p : points) {
        variance += (p.x - mean) * (p.x - mean);
        covariance += (p.x - mean) * p.n;
    }
    return covariance / variance;
}
/// How far lines of a slope are off at worst: the one through the points' mean, and the nearest.
struct LineError {
    double through_mean, nearest;
};
LineError line_error(const std::vector<Point>& points, double slope) {
    double mean = 0.0, least = INFINITY, most = -INFINITY;
    for (const Point& p : points) {
        const double left = p.n - slope * p.x;
        mean += left / double(points.size());
        least = std::min(least, left), most = std::max(most, left);
    }
    return {std::max(most - mean, mean - least), 0.5 * (most - least)};
}

// "The plot of refractive index vs. frequency is not perfectly straight, but curved." The line of
// least squares, and the one of all lines that is least off at worst. The numbers are computed
// apart from this program, from published coefficients.
TEST(PaperFormulas, NoStraightLineIsAGlass) {
    struct Curved {
        const char* name;
        double least_squares, any;
    };
    constexpr double kOfAir = 1e-4, kApart = 1e-3;  // as shares of the error
    for (const auto& [name, least_squares, any] :
         {Curved{"water", 1.0255e-3, 5.254e-4}, Curved{"schott/N-BK7", 1.7005e-3, 9.153e-4},
          Curved{"schott/SF11", 1.3515e-2, 7.059e-3}}) {
        const std::vector<Point> points = points_of(name);
        const double slope = regression_slope(points);
        const double regression = line_error(points, slope).through_mean;
        EXPECT_NEAR(worst("n = a + b f", name) / regression, 1.0, kOfAir) << name;
        EXPECT_NEAR(regression / least_squares, 1.0, kApart) << name;
        const auto nearest = [&](double s) { return line_error(points, s).nearest; };
        EXPECT_NEAR(nearest(find_minimum(nearest, 0.0, 3.0 * slope)) / any, 1.0, kApart) << name;
    }
}

}  // namespace
}  // namespace dewbow
