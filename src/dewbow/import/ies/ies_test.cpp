// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/ies/ies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/file.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-12;

/// What stands in a file behind its label lines; each part can be made wrong.
struct Parts {
    std::string labels = "IESNA:LM-63-2002\n[TEST] none\n";
    std::string tilt = "TILT=NONE\n";
    std::string counts = "1 1000 1 3 1";
    std::string type = " 1 2 0 0 0\n";
    std::string ballast = "1 1 20\n";
    std::string vertical = "0 45 90\n";
    std::string horizontal = "0\n";
    std::string candela = "100 50 0\n";

    std::string text() const {
        return labels + tilt + counts + type + ballast + vertical + horizontal + candela;
    }
};

IesFile parse(const Parts& parts) { return parse_ies("lamp.ies", parts.text()); }

/// I0 cos θ in steps of 90°/intervals, whose flux is π I0.
Parts lambertian(int intervals) {
    Parts parts;
    parts.counts = fmt::format("1 {} 1 {} 1", kPi * 100.0, intervals + 1);
    parts.vertical = parts.candela = "";
    for (int i = 0; i <= intervals; ++i) {
        const double theta_deg = 90.0 * i / intervals;
        parts.vertical += fmt::format("{}{}", theta_deg, i % 10 == 9 ? "\r\n" : " ");
        parts.candela +=
            fmt::format("{}, ", std::max(0.0, 100.0 * std::cos(theta_deg * kPi / 180)));
    }
    return parts;
}

TEST(Ies, HasTheLumensThatALambertianFileStates) {
    constexpr int kIntervals = 90;
    const IesFile ies = parse(lambertian(kIntervals));
    const double h = 0.5 * kPi / kIntervals;  // chords of a cosine miss h²/12 of it
    EXPECT_NEAR(ies.web->flux_lm() / *ies.lumens_per_lamp, 1.0 - h * h / 12.0, h * h * h * h);
    EXPECT_EQ(ies.web->max_intensity_cd(), 100.0);
    EXPECT_EQ(ies.symmetry, IesSymmetry::axial);
    EXPECT_TRUE(ies.diagnostics.empty());
}

TEST(Ies, ScalesByMultiplierAndBallast) {
    Parts parts;
    parts.counts = "2 -1 3 3 1";
    parts.ballast = "0.5 0.25 20\n";
    const IesFile now = parse(parts);
    EXPECT_EQ(now.web->max_intensity_cd(), 100.0 * 3.0 * 0.5);
    EXPECT_FALSE(now.lumens_per_lamp.has_value());
    EXPECT_EQ(now.lamps, 2);
    parts.labels = "IESNA91\n";  // until 1995 the second number is a factor, too
    EXPECT_EQ(parse(parts).web->max_intensity_cd(), 100.0 * 3.0 * 0.5 * 0.25);
}

TEST(Ies, KnowsItsVersions) {
    Parts parts;
    for (const char* version : {"IESNA91", "IESNA:LM-63-1995", "IESNA:LM-63-2002"}) {
        parts.labels = std::string(version) + "\r\n";
        EXPECT_EQ(parse(parts).version, version);
        EXPECT_TRUE(parse(parts).diagnostics.empty());
    }
    parts.labels = "a downlight of 1988\n";
    EXPECT_EQ(parse(parts).version, "LM-63-1986");
    parts.labels = "";
    EXPECT_EQ(parse(parts).version, "LM-63-1986");
    parts.labels = "IESNA:LM-63-3000\n";
    ASSERT_EQ(parse(parts).diagnostics.size(), 1u);
    EXPECT_NE(parse(parts).diagnostics[0].text.find("IESNA:LM-63-3000"), std::string::npos);
}

/// A web of `horizontal`, whose intensity at θ = 90° is 1, 2, 3… in the order of the file.
IesFile numbered(const std::string& horizontal, int rows) {
    Parts parts;
    parts.counts = fmt::format("1 -1 1 2 {}", rows);
    parts.vertical = "0 90\n";
    parts.horizontal = horizontal + "\n";
    parts.candela = "";
    for (int row = 1; row <= rows; ++row) parts.candela += fmt::format("7 {}\n", row);
    return parse(parts);
}

TEST(Ies, UnfoldsSymmetries) {
    struct Case {
        const char* horizontal;
        int rows;
        IesSymmetry symmetry;
        double at[8];  ///< at 0, 45, 90 … 315 deg
    };
    constexpr Case kCases[] = {
        {"0", 1, IesSymmetry::axial, {1, 1, 1, 1, 1, 1, 1, 1}},
        {"0 45 90", 3, IesSymmetry::quadrant, {1, 2, 3, 2, 1, 2, 3, 2}},
        {"0 45 90 135 180", 5, IesSymmetry::bilateral, {1, 2, 3, 4, 5, 4, 3, 2}},
        {"90 135 180 225 270", 5, IesSymmetry::bilateral_90, {3, 2, 1, 2, 3, 4, 5, 4}},
        {"0 45 90 135 180 225 270 315 360", 9, IesSymmetry::none, {1, 2, 3, 4, 5, 6, 7, 8}},
        {"0 45 90 135 180 225 270 315", 8, IesSymmetry::none, {1, 2, 3, 4, 5, 6, 7, 8}},
    };
    for (const Case& expected : kCases) {
        const IesFile ies = numbered(expected.horizontal, expected.rows);
        EXPECT_EQ(ies.symmetry, expected.symmetry) << expected.horizontal;
        for (int i = 0; i < 8; ++i) {
            const double phi = i * kPi / 4.0;
            EXPECT_NEAR(ies.web->intensity_cd(0.5 * kPi, phi), expected.at[i], kRounding * 10)
                << expected.horizontal << " at " << 45 * i;
        }
    }
}

TEST(Ies, SaysWhatItRepairs) {
    EXPECT_EQ(numbered("0 90 180 270", 4).diagnostics.size(), 1u);     // no row at 360
    EXPECT_EQ(numbered("0 90 180 270 360", 5).diagnostics.size(), 1u)  // 1 at 0, 5 at 360
        << "ends that differ";
    EXPECT_EQ(numbered("0 90 180 270 360", 5).web->intensity_cd(0.5 * kPi, 0.0), 1.0);
}

TEST(Ies, PassesOverTiltAndSaysSo) {
    Parts parts;
    parts.tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8\n";
    const IesFile included = parse(parts);
    EXPECT_EQ(included.web->max_intensity_cd(), 100.0);
    ASSERT_EQ(included.diagnostics.size(), 1u);
    EXPECT_EQ(included.diagnostics[0].place.line, 3u);
    parts.tilt = "TILT=other.tlt\n";
    ASSERT_EQ(parse(parts).diagnostics.size(), 1u);
    EXPECT_NE(parse(parts).diagnostics[0].text.find("other.tlt"), std::string::npos);
}

std::string error_of(const std::string& text) {
    try {
        parse_ies("lamp.ies", text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Ies, RefusesWrongFilesByLineAndColumn) {
    struct Row {
        const char* name;
        Parts parts;
        const char* place;
        const char* says;
    };
    const auto with = [](std::string Parts::*part, const char* text) {
        Parts parts;
        parts.*part = text;
        return parts;
    };
    const std::vector<Row> rows{
        {"no TILT", with(&Parts::tilt, ""), ":7:1:", "no line that begins with TILT="},
        {"empty TILT", with(&Parts::tilt, "TILT=\n"), ":3:1:", "names nothing"},
        {"tilt geometry", with(&Parts::tilt, "TILT=INCLUDE\n4 1 0 1\n"), ":4:1:", "geometry is 4"},
        {"tilt order", with(&Parts::tilt, "TILT=INCLUDE\n1 2 9 3 1 1\n"), ":4:7:", "3 after 9"},
        {"no lamp", with(&Parts::counts, "0 1000 1 3 1"), ":4:1:", "number of lamps is 0"},
        {"half a lamp", with(&Parts::counts, "1.5 1000 1 3 1"), ":4:1:", "whole number"},
        {"negative lumens", with(&Parts::counts, "1 -0.5 1 3 1"), ":4:3:", "-0.5"},
        {"no multiplier", with(&Parts::counts, "1 1000 0 3 1"), ":4:8:", "multiplier is 0"},
        {"huge count", with(&Parts::counts, "1 1000 1 3 1e300"), ":4:12:", "1000000"},
        {"count too large for the file", with(&Parts::counts, "1 1000 1 1000000 1"),
         ":5:5:", "1000000 vertical angles cannot stand in the "},
        {"one vertical angle", with(&Parts::counts, "1 1000 1 1 1"), ":4:10:", "vertical angles"},
        {"type B", with(&Parts::type, " 2 2 0 0 0\n"), ":4:14:", "type B"},
        {"type A", with(&Parts::type, " 3 2 0 0 0\n"), ":4:14:", "type A"},
        {"type 7", with(&Parts::type, " 7 2 0 0 0\n"), ":4:14:", "photometric type is 7"},
        {"units", with(&Parts::type, " 1 3 0 0 0\n"), ":4:16:", "type of units is 3"},
        {"infinite size", with(&Parts::type, " 1 2 0 inf 0\n"), ":4:20:", "the length is inf"},
        {"ballast", with(&Parts::ballast, "-1 1 20\n"), ":5:1:", "ballast factor is -1"},
        {"a word", with(&Parts::vertical, "0 forty 90\n"), ":6:3:", "\"forty\" stands where"},
        {"vertical order", with(&Parts::vertical, "0 90 45\n"), ":6:6:", "45 after 90"},
        {"vertical range", with(&Parts::vertical, "0 90 270\n"), ":6:6:", "270"},
        {"NaN angle", with(&Parts::vertical, "0 nan 90\n"), ":6:3:", "nan"},
        {"horizontal range", with(&Parts::horizontal, "400\n"), ":7:1:", "400"},
        {"negative intensity", with(&Parts::candela, "100 -5 0\n"),
         ":8:5:", "intensity 2 of 3 is -5"},
        {"NaN intensity", with(&Parts::candela, "100 nan 0\n"), ":8:5:", "nan"},
        {"dark", with(&Parts::candela, "0 0 0\n"), ":8:5:", "all intensities are 0"},
        {"too few", with(&Parts::candela, "100 50\n"), ":9:1:", "the file ends where intensity 3"},
        {"too many", with(&Parts::candela, "100 50 0 3\n"), ":8:10:", "\"3\" follows"},
    };
    for (const Row& row : rows) {
        const std::string error = error_of(row.parts.text());
        EXPECT_NE(error.find(std::string("lamp.ies") + row.place), std::string::npos)
            << row.name << ": " << error;
        EXPECT_NE(error.find(row.says), std::string::npos) << row.name << ": " << error;
    }
}

TEST(Ies, RefusesRangesOfHorizontalAnglesThatMeanNothing) {
    for (const char* horizontal : {"0 120", "30 90", "90 180", "90 270"}) {
        Parts parts;
        parts.counts = "1 1000 1 3 2";
        parts.horizontal = std::string(horizontal) + "\n";
        parts.candela += "100 50 0\n";
        EXPECT_NE(error_of(parts.text()).find("horizontal angles"), std::string::npos)
            << horizontal << ": " << error_of(parts.text());
    }
}

TEST(Ies, ReadsTheDownlightOfTheExamples) {
    const IesFile ies =
        parse_ies("downlight.ies", read_file(DEWBOW_SOURCE_DIR "/examples/downlight.ies"));
    EXPECT_TRUE(ies.diagnostics.empty());
    // 1000 cd cos⁴θ shines 2π/5 · 1000 lm. Its chords enclose more: with steps h the share is
    // h²/12 ∫ f″ sin / ∫ f sin = h²/3, and another term of order h⁴.
    const double h = 5.0 * kPi / 180.0;
    const double flux_lm = 2.0 * kPi / 5.0 * 1000.0;
    EXPECT_NEAR(ies.web->flux_lm() / flux_lm, 1.0 + h * h / 3.0, 10.0 * h * h * h * h);
    EXPECT_NEAR(*ies.lumens_per_lamp, flux_lm, 0.1) << "as the file states";
    constexpr double kLastDigit = 0.051;
    for (double theta_deg : {0.0, 30.0, 60.0, 85.0}) {
        const double theta = theta_deg * kPi / 180.0;
        EXPECT_NEAR(ies.web->intensity_cd(theta, 1.0), 1000.0 * std::pow(std::cos(theta), 4),
                    kLastDigit);
    }
}

// Whatever is cut off, there is an error and nothing else.
TEST(Ies, RefusesEveryBeginningOfAFile) {
    const std::string whole = Parts{}.text();
    ASSERT_EQ(error_of(whole), "no error");
    for (std::size_t bytes = 0; bytes + 2 < whole.size(); ++bytes) {
        EXPECT_NE(error_of(whole.substr(0, bytes)), "no error") << bytes;
    }
}

TEST(Ies, TakesAnyBytes) {
    const std::string whole = lambertian(6).text();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        for (char c : {'\0', '-', '9', 'e', '\n', '\xff', '.'}) {
            std::string damaged = whole;
            damaged[i] = c;
            error_of(damaged);  // read or refused: no crash, no other exception
        }
    }
}

}  // namespace
}  // namespace dewbow
