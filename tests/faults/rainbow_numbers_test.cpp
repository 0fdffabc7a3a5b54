// SPDX-License-Identifier: Apache-2.0

// One sphere by number: what scripts read from `dewbow rainbow --json`.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dewbow/base/file.h"
#include "run_program.h"

namespace dewbow::faults {
namespace {

using nlohmann::json;

/// Of 25 digits, against sums of 1000 waves in double: relative to the larger of S1 and S2.
constexpr double kRounding = 1e-10;

json answer(const std::vector<std::string>& words) {
    const Folder folder;
    std::vector<std::string> arguments{"rainbow", "--json"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    return json::parse(outcome.standard_output);
}

/// re and im of tests/reference/mie_water_50_digits.csv for x = 1000, by "quantity,angle".
std::map<std::string, std::complex<double>> reference() {
    std::map<std::string, std::complex<double>> values;
    std::istringstream lines(
        read_file(std::string(DEWBOW_SOURCE_DIR) + "/tests/reference/mie_water_50_digits.csv"));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        std::string x, quantity, angle, re, im;
        std::getline(fields, x, ',');
        std::getline(fields, quantity, ',');
        std::getline(fields, angle, ',');
        std::getline(fields, re, ',');
        std::getline(fields, im, ',');
        if (x == "1000") values[quantity + "," + angle] = {std::stod(re), std::stod(im)};
    }
    return values;
}

std::complex<double> complex_of(const json& pair) { return {pair[0], pair[1]}; }

TEST(RainbowNumbers, MieIsThatOfFiftyDigits) {
    const auto expected = reference();
    const json sphere = answer({"--model", "mie", "--size-parameter", "1000", "--index", "1.333",
                                "--angles", "0,5,60,77.7,90,120,138,180", "--amplitudes"});
    EXPECT_NEAR(sphere["Q_ext"].get<double>(), expected.at("qext,").real(), kRounding);
    std::size_t compared = 0;
    for (const json& row : sphere["amplitudes"]) {
        std::ostringstream angle;
        angle << row["angle_deg"].get<double>();
        const auto s1 = expected.find("S1," + angle.str()), s2 = expected.find("S2," + angle.str());
        if (s1 == expected.end() || s2 == expected.end()) continue;
        const double size = std::max(std::abs(s1->second), std::abs(s2->second));
        EXPECT_LT(std::abs(complex_of(row["S1"]) - s1->second), kRounding * size) << angle.str();
        EXPECT_LT(std::abs(complex_of(row["S2"]) - s2->second), kRounding * size) << angle.str();
        ++compared;
    }
    EXPECT_EQ(compared, 8u);
}

/// Without --amplitudes their squares; by other models the same layout.
TEST(RainbowNumbers, IntensitiesAreSquaresOfAmplitudes) {
    for (const char* model : {"mie", "debye", "airy", "uniform_airy"}) {
        std::vector<std::string> words{"--model", model,   "--size-parameter", "500",
                                       "--index", "1.333", "--angles",         "138,141"};
        if (model != std::string("mie")) words.insert(words.end(), {"--order", "2"});
        const json intensities = answer(words)["intensities"];
        words.push_back("--amplitudes");
        const json amplitudes = answer(words)["amplitudes"];
        ASSERT_EQ(amplitudes.size(), 2u) << model;
        for (std::size_t i = 0; i < 2; ++i) {
            const double s1 = std::norm(complex_of(amplitudes[i]["S1"]));
            EXPECT_NEAR(intensities[i]["S1_squared"].get<double>(), s1, 1e-9 * s1) << model;
        }
    }
}

}  // namespace
}  // namespace dewbow::faults
