// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sun_position.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

/// The series' own error [Meeus, ch. 25], of each of altitude and azimuth.
constexpr double kSeries_deg = 0.01;

TEST(SunPosition, IsThatOfThePublishedExample) {
    // I. Reda & A. Andreas, Solar Energy 76, 577 (2004), Table A5.1: 17 October 2003, 12:30:30 in
    // Golden, Colorado. Their air is thinner, so that refraction is taken off again.
    const Place golden{39.742476 * deg, -105.1786 * deg};
    const SkyPosition sun = sun_position(parse_date_time("2003-10-17", "12:30:30", -7.0), golden);
    constexpr double kTrueAltitude_deg = 39.872046, kAzimuth_deg = 194.340241;
    EXPECT_NEAR((sun.altitude - refraction(kTrueAltitude_deg * deg)).to(deg), kTrueAltitude_deg,
                kSeries_deg);
    EXPECT_NEAR(sun.azimuth.to(deg), kAzimuth_deg, kSeries_deg);
    EXPECT_NEAR(sun.distance, 0.9965422974, 5e-5);
}

TEST(SunPosition, HasTheDeclinationOfAnAlmanac) {
    // From the north pole the altitude is the declination, less parallax. Meeus, example 25.b: 13
    // October 1992, 0h, from the complete theory: −7° 47′ 01.74″.
    const auto altitude = [](const char* date, const char* time) {
        const SkyPosition sun = sun_position(parse_date_time(date, time), {90.0 * deg, Angle{}});
        return sun.altitude.to(deg);
    };
    EXPECT_NEAR(altitude("1992-10-13", "00:00"), -7.783817 - 8.794 / 3600.0, kSeries_deg);
    // Equinoxes and solstices of the Astronomical Almanac, to the minute.
    const double horizon = refraction(Angle{}).to(deg);
    EXPECT_NEAR(altitude("2020-03-20", "03:50"), horizon, kSeries_deg);
    EXPECT_NEAR(altitude("2024-09-22", "12:44"), horizon, kSeries_deg);
    EXPECT_NEAR(altitude("2025-06-21", "02:42") - refraction(23.436 * deg).to(deg), 23.436,
                kSeries_deg);
}

TEST(SunPosition, GoesFromEastOverSouthToWest) {
    const Place munich{48.1 * deg, 11.6 * deg};
    const auto at = [&](const char* time) {
        return sun_position(parse_date_time("2026-06-21", time, 2.0), munich);
    };
    EXPECT_NEAR(at("05:14").altitude.to(deg), 0.0, 1.0);
    EXPECT_NEAR(at("05:14").azimuth.to(deg), 54.0, 2.0);
    EXPECT_NEAR(at("13:16").azimuth.to(deg), 180.0, 1.0);
    EXPECT_NEAR(at("13:16").altitude.to(deg), 90.0 - 48.1 + 23.44, 0.1);
    EXPECT_NEAR(at("21:17").azimuth.to(deg), 306.0, 2.0);
    // The same moment by another clock.
    EXPECT_DOUBLE_EQ(
        sun_position(parse_date_time("2026-06-21", "18:40", 2.0), munich).azimuth.to(deg),
        sun_position(parse_date_time("2026-06-21", "16:40", 0.0), munich).azimuth.to(deg));
    // South of the tropics it stands in the north at noon.
    const SkyPosition sydney =
        sun_position(parse_date_time("2026-06-21", "12:00", 10.0), {-33.9 * deg, 151.2 * deg});
    EXPECT_LT(std::abs(std::remainder(sydney.azimuth.to(deg), 360.0)), 3.0);
}

TEST(Refraction, IsThatOfTheTables) {
    // Minutes of arc at 1010 hPa and 10 °C, for true altitudes: Nautical Almanac, by apparent ones.
    EXPECT_NEAR(refraction(Angle{}).to(deg) * 60.0, 28.7, 0.5);
    EXPECT_NEAR(refraction(10.0 * deg).to(deg) * 60.0, 5.3, 0.15);
    EXPECT_NEAR(refraction(45.0 * deg).to(deg) * 60.0, 1.0, 0.05);
    EXPECT_NEAR(refraction(90.0 * deg).to(deg), 0.0, 1e-4);
    EXPECT_EQ(refraction(-2.0 * deg).to(deg), 0.0);
}

TEST(DirectionTo, HasNorthAtMinusZAndEastAtX) {
    const Vec3 north = direction_to(Angle{}, Angle{}).v, east = direction_to(Angle{}, 90.0 * deg).v;
    EXPECT_NEAR(north.z, -1.0, 1e-15);
    EXPECT_NEAR(east.x, 1.0, 1e-15);
    EXPECT_NEAR(direction_to(30.0 * deg, 250.0 * deg).v.y, 0.5, 1e-15);
    EXPECT_LT(direction_to(30.0 * deg, 250.0 * deg).v.x, 0.0);
    EXPECT_GT(direction_to(30.0 * deg, 250.0 * deg).v.z, 0.0);
}

std::string refusal(const char* date, const char* time) {
    try {
        sun_position(parse_date_time(date, time), {});
    } catch (const InputError& error) {
        return error.sentence();
    }
    return "accepted";
}

TEST(ParseDateTime, RefusesWhatTheCalendarHasNot) {
    EXPECT_EQ(refusal("2026-02-29", "12:00"), "there is no 29 February in 2026");
    EXPECT_EQ(refusal("2100-02-29", "12:00"), "there is no 29 February in 2100");
    EXPECT_EQ(refusal("2000-02-29", "12:00"), "accepted");
    EXPECT_EQ(refusal("2026-04-31", "12:00"), "there is no 31 April in 2026");
    EXPECT_EQ(refusal("2026-13-01", "12:00"), "there is no month 13 in \"2026-13-01\"");
    EXPECT_EQ(refusal("2026-01-00", "12:00"), "there is no 0 January in 2026");
    EXPECT_EQ(refusal("1492-10-12", "12:00"), "the year 1492; expected 1900 to 2100");
    for (const char* none : {"", "2026", "2026-06", "2026-6.5-1", "21.6.2026", "2026-06-21-1",
                             "2026-06-21 ", "-2026-06-21", "2026-nan-01"})
        EXPECT_EQ(refusal(none, "12:00"),
                  fmt::format("\"{}\" is no date; expected one like \"2026-06-21\"", none));
    EXPECT_EQ(refusal("2026-06-21", "24:00"),
              "there is no 24:00 o'clock; expected \"00:00\" to \"23:59\"");
    EXPECT_EQ(refusal("2026-06-21", "12:60"),
              "there is no 12:60 o'clock; expected \"00:00\" to \"23:59\"");
    EXPECT_EQ(refusal("2026-06-21", "noon"),
              "\"noon\" is no time; expected one like \"18:40\" or \"18:40:30\"");
}

}  // namespace
}  // namespace dewbow
