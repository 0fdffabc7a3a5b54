// SPDX-License-Identifier: Apache-2.0

// What scripts read from `dewbow spectrum`.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "dewbow/base/file.h"
#include "run_program.h"

namespace dewbow::faults {
namespace {

using nlohmann::json;
constexpr const char* kChannels[] = {"red", "green", "blue"};

std::string printed(std::vector<std::string> words) {
    const Folder folder;
    words.insert(words.begin(), {"spectrum", "--json"});
    const Outcome outcome = run_program(DEWBOW_BINARY, words, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    return outcome.standard_output;
}

TEST(SpectrumNumbers, WhiteOfIndependentJitterIsThatOfTheClosedForms) {
    // Closed forms of SpectralStatistics. Five standard errors of so many independent sets, each a
    // false alarm with probability 6e-7; the sets are stratified, which only helps.
    constexpr int kSets = 65536;
    const double sd[] = {0.5 / 6.0, std::sqrt(4.0 / 48.0) / 6.0, std::sqrt(2.0 / 12.0) / 6.0};
    const json white =
        json::parse(printed({"--jitter", "both", "--sets", std::to_string(kSets)}))["white"];
    for (std::size_t c = 0; c < 3; ++c) {
        const json& channel = white[kChannels[c]];
        EXPECT_NEAR(channel["mean"].get<double>(), 1.0, 5.0 * sd[c] / std::sqrt(kSets));
        EXPECT_NEAR(channel["sd"].get<double>(), sd[c], 5.0 * sd[c] / std::sqrt(2.0 * kSets));
        EXPECT_NEAR(channel["above_1"].get<double>(), 0.5, 5.0 * 0.5 / std::sqrt(kSets));
        EXPECT_LT(channel["mean_clamped"].get<double>(), 1.0 - 0.2 * sd[c]);
    }
    EXPECT_NEAR(white["any_channel_above_1"].get<double>(), 0.84, 0.01);
}

TEST(SpectrumNumbers, AreThoseOfTheSeed) {
    const std::vector<std::string> words{"--jitter", "both", "--sets", "64", "--seed"};
    const auto with_seed = [&](const std::string& seed) {
        std::vector<std::string> all = words;
        all.push_back(seed);
        return printed(all);
    };
    EXPECT_EQ(with_seed("1"), with_seed("1"));
    EXPECT_NE(with_seed("1"), with_seed("2"));
}

TEST(SpectrumNumbers, CommonOffsetsAreWhiteAndNothingIsAboveIt) {
    const json white = json::parse(printed({"--jitter", "both", "--correlated"}))["white"];
    EXPECT_EQ(white["any_channel_above_1"].get<double>(), 0.0);
    for (const char* channel : kChannels) {
        EXPECT_NEAR(white[channel]["least"].get<double>(), 1.0, 1e-12);
        EXPECT_NEAR(white[channel]["greatest"].get<double>(), 1.0, 1e-12);
    }
}

TEST(SpectrumNumbers, CurvesOfTheTableHaveUnitArea) {
    // Trapezoids between 1300 rows; the curves' slopes jump at 38 nodes, most of them rows.
    constexpr double kTolerance = 1e-4;
    const Folder folder;
    const Outcome outcome = run_program(
        DEWBOW_BINARY, {"spectrum", "--colours", "empirical", "-o", "curves.csv"}, folder.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    std::istringstream lines(read_file(folder.path() / "curves.csv"));
    std::vector<double> before;
    double area[3] = {};
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || !(std::isdigit(line[0]))) continue;
        std::istringstream fields(line);
        std::vector<double> row;
        for (std::string field; std::getline(fields, field, ',');) row.push_back(std::stod(field));
        ASSERT_EQ(row.size(), 5u) << line;
        for (std::size_t c = 0; c < 3 && !before.empty(); ++c)
            area[c] += 0.5 * std::abs(row[0] - before[0]) * (row[2 + c] + before[2 + c]);
        before = row;
    }
    for (const double channel : area) EXPECT_NEAR(channel, 1.0, kTolerance);
}

}  // namespace
}  // namespace dewbow::faults
