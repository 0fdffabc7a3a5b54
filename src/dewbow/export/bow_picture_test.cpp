// SPDX-License-Identifier: Apache-2.0
#include "dewbow/export/bow_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;
/// The table's hat functions against 0.5 nm steps over its ends, and rounding to 8 bits with ±1 of
/// dither.
constexpr int kCodes = 2;

/// P of both polarisations at 91 angles from 90° and 81 wavelengths.
template <class Phase>
ScatteringTable table_of(Phase phase) {
    ScatteringTable table;
    for (int i = 0; i <= 90; ++i) table.angles.push_back((90.0 + i) * unit::deg);
    for (int j = 0; j <= 80; ++j) table.wavelengths.push_back((380.0 + 5.0 * j) * unit::nm);
    for (const Angle angle : table.angles)
        for (const Wavelength lambda : table.wavelengths)
            table.phase.push_back(phase(angle.to(unit::deg), lambda.to(unit::nm)));
    table.efficiencies.assign(table.wavelengths.size(), {1.0, 1.0, 0.5});
    return table;
}

/// Drops that scatter all wavelengths alike are white under every illuminant, and Y is P Q_sca.
TEST(BowColours, WhiteIsWhite) {
    for (const char* name : {"D65", "A", "E", "FL2"}) {
        const SpectrumPtr light = find_illuminant(name);
        ScatteringTable table = table_of([](double, double) { return Intensities{3.0, 1.0}; });
        for (Efficiencies& q : table.efficiencies) q.scattering = 2.0;
        const BowColours bow = bow_colours(table, *light, *light);
        EXPECT_NEAR(bow.unpolarised(40)[1], 4.0, 4.0 * kRounding) << name;
        EXPECT_NEAR(bow.perpendicular[40][1], 6.0, 6.0 * kRounding) << name;
        const DisplaySettings settings = settings_for({bow.unpolarised(40)}, *light);
        const auto rgb = srgb8_from_xyz(bow.unpolarised(40), settings, 3, 5);
        for (int c = 0; c < 3; ++c) EXPECT_GE(int(rgb[std::size_t(c)]), 255 - kCodes) << name;
    }
}

/// A phase function that is linear in the wavelength is integrated exactly: by sums in steps of
/// 0.1 nm instead of hat functions of 5 nm.
TEST(BowColours, IntegrateBetweenWavelengths) {
    constexpr double kSteps = 1e-5;  // of midpoint sums in 0.5 and 0.1 nm steps
    const SpectrumPtr light = find_illuminant("D65");
    const auto phase = [](double nm) { return (nm - 380.0) / 400.0; };
    const BowColours bow = bow_colours(table_of([&](double, double nm) {
                                           return Intensities{phase(nm), phase(nm)};
                                       }),
                                       *light, *light);
    std::array<double, 3> sum{};
    double white = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double nm = 380.05 + 0.1 * k, power = (*light)(nm * unit::nm);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += phase(nm) * power * cie_xyz_bar(nm)[c];
        white += power * cie_xyz_bar(nm)[1];
    }
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(bow.unpolarised(7)[c], sum[c] / white, kSteps * sum[c] / white) << c;
}

/// What is brighter in the red looks red; a weaker, redder light makes it darker and redder.
TEST(BowColours, FollowWavelengths) {
    const SpectrumPtr white = find_illuminant("D65");
    const ScatteringTable table = table_of([](double angle, double nm) {
        const double p = angle < 135.0 ? double(nm > 600.0) : double(nm < 480.0);
        return Intensities{p, p};
    });
    const BowColours bow = bow_colours(table, *white, *white);
    EXPECT_GT(bow.unpolarised(10)[0], 10.0 * bow.unpolarised(10)[2]);
    EXPECT_GT(bow.unpolarised(80)[2], 5.0 * bow.unpolarised(80)[0]);
    const SpectrumPtr low_sun = make_tabulated({380.0, 780.0}, {0.0, 50.0}, OutsideTable::hold);
    const BowColours low = bow_colours(table, *low_sun, *white);
    EXPECT_LT(low.unpolarised(80)[1] / low.unpolarised(10)[1],
              bow.unpolarised(80)[1] / bow.unpolarised(10)[1]);
}

TEST(BowColours, NeedSomethingVisible) {
    ScatteringTable table = table_of([](double, double) { return Intensities{1.0, 1.0}; });
    for (Wavelength& lambda : table.wavelengths) lambda += 500.0 * unit::nm;
    const SpectrumPtr white = find_illuminant("D65");
    EXPECT_THROW(bow_colours(table, *white, *white), InputError);
}

TEST(ColourAt, IsLinearBetweenAnglesAndHeldBeyond) {
    const std::vector<Angle> angles{10.0 * unit::deg, 20.0 * unit::deg};
    const std::vector<Colour<Xyz>> colours{{{1, 2, 3}}, {{3, 2, 1}}};
    EXPECT_NEAR(colour_at(angles, colours, 12.5 * unit::deg)[0], 1.5, kRounding);
    EXPECT_EQ(colour_at(angles, colours, 5.0 * unit::deg)[2], 3.0);
    EXPECT_EQ(colour_at(angles, colours, 25.0 * unit::deg)[2], 1.0);
}

/// Light of a bow vibrates along it: at the top a vertical polariser takes it away, at the sides it
/// lets it through. Two crossed polarisers together pass what passes without one.
TEST(Polariser, TakesTheBowAwayWhereItsAxisCrossesIt) {
    const PolarisationShares top = behind_polariser(0.0 * unit::deg, 0.0 * unit::deg);
    EXPECT_NEAR(top.perpendicular, 0.0, kRounding);
    EXPECT_NEAR(top.parallel, 0.5, kRounding);
    const PolarisationShares side = behind_polariser(0.0 * unit::deg, 90.0 * unit::deg);
    EXPECT_NEAR(side.perpendicular, 0.5, kRounding);
    for (const double clock : {-70.0, 10.0, 55.0}) {
        const auto a = behind_polariser(20.0 * unit::deg, clock * unit::deg);
        const auto b = behind_polariser(110.0 * unit::deg, clock * unit::deg);
        EXPECT_NEAR(a.perpendicular + b.perpendicular, 0.5, kRounding);
        EXPECT_NEAR(a.parallel + b.parallel, 0.5, kRounding);
    }
}

/// A thin white ring at 42° from the antisolar point.
BowAround ring() {
    const SpectrumPtr white = find_illuminant("D65");
    const ScatteringTable table = table_of([](double angle, double) {
        const double p = std::abs(angle - 138.0) < 0.5 ? 1.0 : 0.0;
        return Intensities{p, 0.0};
    });
    return {{Angle{}}, {bow_colours(table, *white, *white)}};
}

TEST(SkyPicture, HasTheBowAboveTheHorizonAndGroundBelow) {
    const BowAround bow = ring();
    SkyView view;
    view.sun_altitude = 20.0 * unit::deg;
    view.half_width = 50.0 * unit::deg;
    view.top = 50.0 * unit::deg;
    view.width = 100;
    view.height = 60;
    const DisplaySettings settings = settings_for(
        colours_between(bow, 30.0 * unit::deg, 60.0 * unit::deg), *find_illuminant("D65"));
    const Image8 image = sky_picture(bow, {}, view, settings);
    const auto green = [&](int x, int y) {
        return int(image.rgb[(std::size_t(y) * 100 + x) * 3 + 1]);
    };
    EXPECT_GT(green(50, 8), 100);  // 42° above the middle, of which 20° are below the horizon
    EXPECT_LT(green(50, 0), 5);
    EXPECT_LT(green(50, 20), 5);
    EXPECT_EQ(green(50, 35), 36);  // 15° above the antisolar point: ground
    EXPECT_EQ(green(50, 29), green(49, 29));
    EXPECT_LT(green(50, 28), 5);  // 21.5°: sky
    // At the top the light vibrates level: a level polariser passes it, an upright one does not.
    BowLook level, upright;
    level.polariser = 90.0 * unit::deg;
    upright.polariser = 0.0 * unit::deg;
    const Image8 with = sky_picture(bow, level, view, settings);
    const Image8 without = sky_picture(bow, upright, view, settings);
    const std::size_t top = (8 * 100 + 50) * 3 + 1;
    EXPECT_GT(int(with.rgb[top]), 100);
    EXPECT_LT(int(without.rgb[top]), 20);
}

TEST(StripPicture, GoesFromLeftToRight) {
    const BowAround bow = ring();
    StripView view;
    view.left = 32.0 * unit::deg;
    view.right = 52.0 * unit::deg;
    view.width = 20;
    view.height = 2;
    const DisplaySettings settings =
        settings_for(colours_between(bow, view.left, view.right), *find_illuminant("D65"));
    const Image8 image = strip_picture(bow, {}, view, settings);
    for (int x = 0; x < 20; ++x) {
        const bool lit = x == 9 || x == 10;  // 41.5° and 42.5°
        EXPECT_EQ(image.rgb[std::size_t(x) * 3] > 50, lit) << x;
    }
}

/// The first bow lies at the bottom; a faint one is shown as bright as a strong one.
TEST(LeePicture, MakesEveryRowAsBrightAsItCanBe) {
    const SpectrumPtr white = find_illuminant("D65");
    const auto bow = [&](double brightness, double where) {
        return bow_colours(table_of([=](double angle, double) {
                               const double p = std::abs(angle - where) < 0.5 ? brightness : 0.0;
                               return Intensities{p, p};
                           }),
                           *white, *white);
    };
    LeeView view;
    view.left = 32.0 * unit::deg;
    view.right = 52.0 * unit::deg;
    view.width = 21;
    view.height = 4;
    const Image8 image = lee_picture({bow(1e-6, 138.0), bow(1.0, 140.0)}, {}, view, *white);
    const auto red = [&](int x, int y) { return int(image.rgb[(std::size_t(y) * 21 + x) * 3]); };
    for (const int y : {2, 3}) EXPECT_GT(red(10, y), 240) << y;  // 42°: below
    for (const int y : {0, 1}) EXPECT_GT(red(8, y), 240) << y;   // 40°: above
    EXPECT_LT(red(10, 0), 5);
    EXPECT_LT(red(8, 3), 5);
}

}  // namespace
}  // namespace dewbow
