// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// A few roundings of values near 1.
constexpr double kRounding = 1e-14;

double value(const SpectrumPtr& spectrum, double lambda_nm) {
    return (*spectrum)(lambda_nm * unit::nm);
}

/// Every quarter nanometre from 300 to 900 nm.
std::vector<double> fine_grid() {
    std::vector<double> grid;
    for (int i = 0; i <= 2400; ++i) grid.push_back(300.0 + 0.25 * i);
    return grid;
}

std::vector<SpectrumPtr> one_of_each_kind() {
    return {make_constant(0.25),
            make_tabulated({400.0, 500.0, 600.0}, {1.0, 3.0, 2.0}, OutsideTable::hold),
            make_tabulated({400.0, 500.0, 600.0}, {1.0, 3.0, 2.0}, OutsideTable::zero),
            make_tabulated({400.0, 410.0, 600.0}, {1.0, 3.0, 2.0}, OutsideTable::hold),
            make_tabulated({555.0}, {4.0}, OutsideTable::hold),
            make_lines({{546.1 * unit::nm, 2.0}, {435.8 * unit::nm, 1.0}}),
            make_scaled(make_tabulated({400.0, 500.0}, {1.0, 3.0}, OutsideTable::zero), 0.5)};
}

TEST(Spectrum, LanesGiveWhatSingleWavelengthsGive) {
    const auto grid = fine_grid();
    for (const SpectrumPtr& spectrum : one_of_each_kind()) {
        std::vector<double> lanes(grid.size());
        spectrum->eval_lanes(grid, lanes);
        for (std::size_t i = 0; i < grid.size(); ++i) EXPECT_EQ(lanes[i], value(spectrum, grid[i]));
    }
}

TEST(Spectrum, MaxValueIsTheLargestVisibleValue) {
    for (const SpectrumPtr& spectrum : one_of_each_kind()) {
        double largest = 0.0;
        for (double lambda_nm : fine_grid()) {
            if (lambda_nm < kLambdaMin_nm || lambda_nm > kLambdaMax_nm) continue;
            largest = std::max(largest, value(spectrum, lambda_nm));
        }
        EXPECT_DOUBLE_EQ(spectrum->max_value(), largest);
    }
}

TEST(Spectrum, MaxValueLooksOnlyAtTheVisibleRange) {
    const auto spectrum =
        make_tabulated({300.0, 400.0, 500.0, 900.0}, {9.0, 1.0, 1.0, 8.0}, OutsideTable::hold);
    EXPECT_NEAR(spectrum->max_value(), 1.0 + 7.0 * 330.0 / 400.0, kRounding * 10);  // at 830 nm
}

TEST(Tabulated, IsLinearBetweenItsValues) {
    const auto regular = make_tabulated({400.0, 500.0, 600.0}, {1.0, 3.0, 2.0}, OutsideTable::hold);
    EXPECT_EQ(value(regular, 400.0), 1.0);
    EXPECT_NEAR(value(regular, 425.0), 1.5, kRounding);
    EXPECT_EQ(value(regular, 500.0), 3.0);
    EXPECT_NEAR(value(regular, 575.0), 2.25, kRounding);
    EXPECT_EQ(value(regular, 600.0), 2.0);
}

TEST(Tabulated, SaysZeroOrHoldsOutside) {
    const std::vector<std::vector<double>> grids{{400.0, 500.0, 600.0}, {400.0, 430.0, 600.0}};
    for (const auto& grid : grids) {
        const auto hold = make_tabulated(grid, {1.0, 3.0, 2.0}, OutsideTable::hold);
        const auto zero = make_tabulated(grid, {1.0, 3.0, 2.0}, OutsideTable::zero);
        EXPECT_EQ(value(hold, 399.0), 1.0);
        EXPECT_EQ(value(hold, 601.0), 2.0);
        EXPECT_EQ(value(zero, 399.0), 0.0);
        EXPECT_EQ(value(zero, 601.0), 0.0);
        EXPECT_EQ(value(zero, 400.0), 1.0);
        EXPECT_EQ(value(zero, 600.0), 2.0);
    }
}

TEST(Tabulated, OneKindOfGridGivesWhatTheOtherGives) {
    // The same broken line; a knot more makes the second grid irregular.
    const auto regular = make_tabulated({400.0, 500.0, 600.0}, {1.0, 3.0, 2.0}, OutsideTable::hold);
    const auto irregular =
        make_tabulated({400.0, 450.0, 500.0, 600.0}, {1.0, 2.0, 3.0, 2.0}, OutsideTable::hold);
    for (double lambda_nm : fine_grid()) {
        EXPECT_NEAR(value(regular, lambda_nm), value(irregular, lambda_nm), kRounding);
    }
}

TEST(Tabulated, RefusesWhatIsNoTable) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(make_tabulated({}, {}, OutsideTable::hold), InputError);
    EXPECT_THROW(make_tabulated({400.0}, {1.0, 2.0}, OutsideTable::hold), InputError);
    EXPECT_THROW(make_tabulated({400.0, 400.0}, {1.0, 2.0}, OutsideTable::hold), InputError);
    EXPECT_THROW(make_tabulated({500.0, 400.0}, {1.0, 2.0}, OutsideTable::hold), InputError);
    EXPECT_THROW(make_tabulated({400.0, nan}, {1.0, 2.0}, OutsideTable::hold), InputError);
    EXPECT_THROW(make_tabulated({400.0, 500.0}, {1.0, nan}, OutsideTable::hold), InputError);
}

double integral(const SpectrumPtr& spectrum) {
    constexpr double kStep_nm = 0.01;  // the boxes below end at whole multiples of it
    double sum = 0.0;
    for (int i = 0; i < 60000; ++i) sum += value(spectrum, 300.0 + (i + 0.5) * kStep_nm) * kStep_nm;
    return sum;
}

TEST(Lines, IntegrateToTheirStrength) {
    const auto lines = make_lines({{546.1 * unit::nm, 2.0}, {435.8 * unit::nm, 1.0}});
    constexpr double kOneCellOfFour = 1e-2 * 3.0;  // a cell more or less at the ends of a box
    EXPECT_NEAR(integral(lines), 3.0, kOneCellOfFour);
    EXPECT_EQ(value(lines, 546.1), 2.0);
    EXPECT_EQ(value(lines, 547.0), 0.0);
}

TEST(Lines, AddWhereTheyOverlap) {
    const auto lines =
        make_lines({{500.0 * unit::nm, 4.0}, {501.0 * unit::nm, 8.0}}, 4.0 * unit::nm);
    EXPECT_EQ(value(lines, 498.5), 1.0);
    EXPECT_EQ(value(lines, 500.5), 3.0);
    EXPECT_EQ(value(lines, 502.5), 2.0);
    EXPECT_EQ(lines->max_value(), 3.0);
    EXPECT_NEAR(integral(lines), 12.0, 0.06);
}

TEST(Lines, RefuseAWidthThatIsNone) {
    EXPECT_THROW(make_lines({{500.0 * unit::nm, 1.0}}, 0.0 * unit::nm), InputError);
    EXPECT_THROW(make_lines({{500.0 * unit::nm, INFINITY}}), InputError);
    EXPECT_EQ(make_lines({})->max_value(), 0.0);
}

TEST(Scaled, KeepsAConstantConstant) {
    const auto scaled = make_scaled(make_constant(3.0), 0.5);
    EXPECT_TRUE(scaled->is_constant());
    EXPECT_EQ(value(scaled, 500.0), 1.5);
    EXPECT_FALSE(make_scaled(one_of_each_kind()[1], 0.5)->is_constant());
}

}  // namespace
}  // namespace dewbow
