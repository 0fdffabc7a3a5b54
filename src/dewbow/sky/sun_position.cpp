// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sun_position.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"

namespace dewbow {

namespace {

constexpr int kFirstYear = 1900, kLastYear = 2100;
constexpr std::array<const char*, 12> kMonths = {"January",   "February", "March",    "April",
                                                 "May",       "June",     "July",     "August",
                                                 "September", "October",  "November", "December"};

bool is_leap(int year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

int days_of(int month, int year) {
    constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month == 2 && is_leap(year) ? 29 : kDays[std::size_t(month - 1)];
}

/// The numbers between `separator`s, as many as `count`; false if the text is anything else.
bool split_numbers(std::string_view text, char separator, std::span<double> out, std::size_t least,
                   std::size_t& count) {
    count = 0;
    while (count < out.size()) {
        const std::size_t end = text.find(separator);
        const std::string_view part = text.substr(0, end);
        if (part.empty() || part.find_first_not_of("0123456789.") != part.npos) return false;
        const auto number = parse_number<double>(part);
        if (!number) return false;
        out[count++] = *number;
        if (end == text.npos) return count >= least;
        text.remove_prefix(end + 1);
    }
    return false;
}

bool is_whole(double value) { return value == std::floor(value); }

void parse_date(std::string_view text, DateTime& when) {
    std::array<double, 3> n{};
    std::size_t count = 0;
    if (!split_numbers(text, '-', n, 3, count) || !is_whole(n[0]) || !is_whole(n[1]) ||
        !is_whole(n[2]))
        throw InputError(fmt::format("\"{}\" is no date; expected one like \"2026-06-21\"", text));
    if (n[0] < kFirstYear || n[0] > kLastYear)
        throw InputError(
            fmt::format("the year {}; expected {} to {}", n[0], kFirstYear, kLastYear));
    when.year = int(n[0]);
    if (n[1] < 1 || n[1] > 12)
        throw InputError(fmt::format("there is no month {} in \"{}\"", n[1], text));
    when.month = int(n[1]);
    if (n[2] < 1 || n[2] > days_of(when.month, when.year))
        throw InputError(fmt::format("there is no {} {} in {}", n[2],
                                     kMonths[std::size_t(when.month - 1)], when.year));
    when.day = int(n[2]);
}

void parse_time(std::string_view text, DateTime& when) {
    std::array<double, 3> n{};
    std::size_t count = 0;
    if (!split_numbers(text, ':', n, 2, count) || !is_whole(n[0]) || !is_whole(n[1]))
        throw InputError(
            fmt::format("\"{}\" is no time; expected one like \"18:40\" or \"18:40:30\"", text));
    if (n[0] > 23 || n[1] > 59 || n[2] >= 60)
        throw InputError(
            fmt::format("there is no {} o'clock; expected \"00:00\" to \"23:59\"", text));
    when.hour = int(n[0]);
    when.minute = int(n[1]);
    when.second = n[2];
}

double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }
double turned_to_360(double degrees) { return degrees - 360.0 * std::floor(degrees / 360.0); }

/// Julian date of a moment, UTC.                                           [Meeus, eq. 7.1]
double julian_date(const DateTime& when) {
    const int early = when.month <= 2 ? 1 : 0;
    const double y = when.year - early, m = when.month + 12 * early;
    const double century = std::floor(y / 100.0);
    const double midnight = std::floor(365.25 * (y + 4716.0)) + std::floor(30.6001 * (m + 1.0)) +
                            when.day + 2.0 - century + std::floor(century / 4.0) - 1524.5;
    const double hours = when.hour + when.minute / 60.0 + when.second / 3600.0 - when.utc_offset_h;
    return midnight + hours / 24.0;
}

/// How far uniform time is ahead of clocks, in days: about a minute, 69 s in 2020. It moves the sun
/// by a thousandth of a degree.
constexpr double kDeltaT_days = 69.0 / 86400.0;

/// Place of the sun against the equinox of date.
struct Ecliptic {
    double longitude;  ///< apparent, degrees
    double obliquity;  ///< degrees
    double distance;   ///< astronomical units
    double nutation;   ///< of longitude, degrees
};

Ecliptic ecliptic_of_sun(double julian) {
    const double t = (julian + kDeltaT_days - 2451545.0) / 36525.0;  // centuries since J2000
    const double mean = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
    const double eccentricity = 0.016708634 - t * (0.000042037 + t * 0.0000001267);
    const double m = radians(anomaly);
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * std::sin(m) +
                          (0.019993 - t * 0.000101) * std::sin(2.0 * m) +
                          0.000289 * std::sin(3.0 * m);
    const double node = radians(125.04452 - t * 1934.136261);
    const double moon = radians(218.3165 + t * 481267.8813);
    const double sun = radians(mean);
    const double nutation = (-17.20 * std::sin(node) - 1.32 * std::sin(2.0 * sun) -
                             0.23 * std::sin(2.0 * moon) + 0.21 * std::sin(2.0 * node)) /
                            3600.0;
    const double tilt = (9.20 * std::cos(node) + 0.57 * std::cos(2.0 * sun) +
                         0.10 * std::cos(2.0 * moon) - 0.09 * std::cos(2.0 * node)) /
                        3600.0;
    const double distance = 1.000001018 * (1.0 - eccentricity * eccentricity) /
                            (1.0 + eccentricity * std::cos(m + radians(centre)));
    constexpr double kAberration = 20.4898 / 3600.0;
    return {mean + centre + nutation - kAberration / distance,
            23.43929111 - t * (0.0130041667 + t * 1.64e-7) + tilt, distance, nutation};
}

/// Apparent sidereal time at Greenwich, degrees.                           [Meeus, eq. 12.4]
double sidereal_time(double julian, const Ecliptic& sun) {
    const double days = julian - 2451545.0, t = days / 36525.0;
    return 280.46061837 + 360.98564736629 * days + t * t * 0.000387933 +
           sun.nutation * std::cos(radians(sun.obliquity));
}

}  // namespace

DateTime parse_date_time(std::string_view date, std::string_view time, double utc_offset_h) {
    DateTime when;
    parse_date(date, when);
    parse_time(time, when);
    when.utc_offset_h = utc_offset_h;
    return when;
}

Angle refraction(Angle true_altitude) {
    const double h = true_altitude.to(unit::deg);
    if (h < -1.0) return {};
    return 1.02 / 60.0 / std::tan(radians(h + 10.3 / (h + 5.11))) * unit::deg;
}

SkyPosition sun_position(const DateTime& when, const Place& where) {
    if (when.year < kFirstYear || when.year > kLastYear)
        throw InputError(
            fmt::format("the year {}; expected {} to {}", when.year, kFirstYear, kLastYear));
    const double latitude = where.latitude.to(unit::rad);
    if (!(std::abs(where.latitude.to(unit::deg)) <= 90.0))
        throw InputError(fmt::format("the latitude {:.6g}°; expected -90° to 90°",
                                     where.latitude.to(unit::deg)));
    if (!(std::abs(where.longitude.to(unit::deg)) <= 180.0))
        throw InputError(fmt::format("the longitude {:.6g}°; expected -180° to 180°",
                                     where.longitude.to(unit::deg)));
    const double julian = julian_date(when);
    const Ecliptic sun = ecliptic_of_sun(julian);
    const double l = radians(sun.longitude), e = radians(sun.obliquity);
    const double right_ascension = std::atan2(std::cos(e) * std::sin(l), std::cos(l));
    const double declination = std::asin(std::sin(e) * std::sin(l));
    const double hour_angle =
        radians(sidereal_time(julian, sun)) + where.longitude.to(unit::rad) - right_ascension;
    // Towards the sun: up, and along the horizon towards north and east.
    const double up =
        std::clamp(std::sin(latitude) * std::sin(declination) +
                       std::cos(latitude) * std::cos(declination) * std::cos(hour_angle),
                   -1.0, 1.0);
    const double north = std::cos(latitude) * std::sin(declination) -
                         std::sin(latitude) * std::cos(declination) * std::cos(hour_angle);
    const double east = -std::cos(declination) * std::sin(hour_angle);
    const double seen_from_centre = degrees(std::asin(up));
    const double parallax = 8.794 / 3600.0 / sun.distance * std::sqrt(1.0 - up * up);
    const Angle altitude = (seen_from_centre - parallax) * unit::deg;
    return {altitude + refraction(altitude),
            turned_to_360(degrees(std::atan2(east, north))) * unit::deg, sun.distance};
}

Dir<World> direction_to(Angle altitude, Angle azimuth) {
    return {{cos(altitude) * sin(azimuth), sin(altitude), -cos(altitude) * cos(azimuth)}};
}

}  // namespace dewbow
