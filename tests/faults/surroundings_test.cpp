// SPDX-License-Identifier: Apache-2.0

// What surrounds a program and must not matter (row F21): locales, time zones, clocks that are
// wrong or are set, closed streams. The same pixels, and no program that waits in a circle.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

/// Of the processor. The render itself takes a few hundredths.
constexpr double kMostCpuSeconds = 2.0;

/// Renders both formats and describes a summary of what it said about the film.
std::string faults_of_render(const fs::path& program, const Words& before, const Start& start) {
    const RenderFolder folder;
    const auto files = folder.snapshot();
    const Outcome outcome = run_program(
        program, before + tiny_render({"-o", "ring.png", "-o", "ring.exr"}), folder.path(), start);
    std::string faults =
        losses(files, folder, outcome,
               {{"ring.png", true_pixels("ring.png")}, {"ring.exr", true_pixels("ring.exr")}});
    if (outcome.exit_code != 0)
        faults +=
            "it ended with " + std::to_string(outcome.exit_code) + ": " + outcome.standard_error;
    if (outcome.cpu_seconds > kMostCpuSeconds) faults += "it was busy for long";
    return faults;
}

// ---- locales and time zones --------------------------------------------------------------------

/// German has a comma in numbers, Turkish an i without a dot for I.
TEST(Surroundings, Locales) {
    const fs::path localedef = find_tool("localedef"), printf = find_tool("printf");
    if (localedef.empty() || printf.empty()) GTEST_SKIP() << "there is no localedef";
    const Folder locales;
    for (const std::string language : {"de_DE", "tr_TR"}) {
        const std::string name = language + ".UTF-8";
        run_program(localedef, {"-i", language, "-f", "UTF-8", (locales.path() / name).string()},
                    locales.path());
        if (!fs::exists(locales.path() / name)) GTEST_SKIP() << "no source of locales is installed";
        const Start start{.environment = {"LOCPATH=" + locales.path().string(), "LC_ALL=" + name}};
        ASSERT_EQ(run_program(printf, {"%.1f", "1,5"}, locales.path(), start).standard_output,
                  "1,5");
        EXPECT_EQ(faults_of_render(DEWBOW_BINARY, {}, start), "") << name;
        const Words curve{"rainbow", "--radius", "0.5mm", "--model", "airy", "--json"};
        EXPECT_EQ(run_program(DEWBOW_BINARY, curve, locales.path(), start).standard_output,
                  run_program(DEWBOW_BINARY, curve, locales.path()).standard_output);
    }
}

TEST(Surroundings, TimeZones) {
    for (const char* zone : {"TZ=Pacific/Apia", "TZ=", "TZ=:/nowhere", "TZ=UTC+24"})
        EXPECT_EQ(faults_of_render(DEWBOW_BINARY, {}, {.environment = {zone}}), "") << zone;
}

TEST(Surroundings, NoVariablesAtAll) {
    const fs::path env = find_tool("env");
    ASSERT_FALSE(env.empty());
    EXPECT_EQ(faults_of_render(env, {"-i", DEWBOW_BINARY}, {}), "");
}

// ---- clocks ------------------------------------------------------------------------------------

class Clocks : public testing::Test {
protected:
    void SetUp() override {
        faketime_ = find_tool("faketime");
        if (faketime_.empty()) GTEST_SKIP() << "there is no faketime to set clocks with";
        const Folder folder;
        const Outcome outcome =
            run_program(faketime_, {"2038-01-20 00:00:00", "date", "+%Y"}, folder.path());
        if (outcome.standard_output != "2038\n")
            GTEST_SKIP() << "faketime does not work here: " << outcome.standard_error;
    }
    fs::path faketime_;
};

TEST_F(Clocks, OtherCenturies) {
    for (const char* date : {"2038-01-20 00:00:00", "1970-01-02 00:00:00", "2200-01-01 00:00:00"})
        EXPECT_EQ(faults_of_render(faketime_, {date, DEWBOW_BINARY}, {}), "") << date;
}

/// The clock of the day is set back by a day in the middle of a render. The program measures by
/// another one, which nobody sets.
TEST_F(Clocks, SetBackByADay) {
    const RenderFolder folder;
    const Words preload{"-c",
                        "LD_PRELOAD=$(faketime 2030-01-01 env | sed -n s/^LD_PRELOAD=//p) "
                        "exec \"$@\"",
                        "sh"};
    folder.put("clock", "+0");
    const Start start{
        .environment = {"FAKETIME_TIMESTAMP_FILE=" + (folder.path() / "clock").string(),
                        "FAKETIME_NO_CACHE=1", "FAKETIME_DONT_FAKE_MONOTONIC=1"}};
    const auto words = [](const std::string& time) {
        return Words{"render", kTinyScene, "--size", "16x16",    "--spp",  "16777216",
                     "--time", time,       "-o",     "ring.png", "--json", "--quiet"};
    };
    const auto began = std::chrono::steady_clock::now();
    const fs::path sh = find_tool("sh");
    const auto day = [&] {
        return run_program(sh, preload + Words{"date", "+%j"}, folder.path(), start)
            .standard_output;
    };
    const std::string today = day();
    Program program(sh, preload + Words{DEWBOW_BINARY} + words("1s"), folder.path(), start);
    while (program.runs() && !fs::exists(folder.path() / ".ring.png.lock"))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    folder.put("clock", "-1d");
    const Outcome outcome = program.wait();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_NE(outcome.standard_output.find("\"reason\":\"time\""), std::string::npos)
        << outcome.standard_output;
    EXPECT_NE(day(), today);
    EXPECT_GT(took.count(), 0.9);
    EXPECT_LT(took.count(), 0.5 * kPatience);
}

// ---- streams -----------------------------------------------------------------------------------

TEST(Surroundings, ClosedStreams) {
    for (const std::vector<int>& streams :
         std::vector<std::vector<int>>{{0}, {1}, {2}, {0, 1}, {0, 1, 2}}) {
        const Start start{.prepare = [streams] {
            for (const int stream : streams) ::close(stream);
            return ::fcntl(streams[0], F_GETFD) < 0;
        }};
        EXPECT_EQ(faults_of_render(DEWBOW_BINARY, {}, start), "") << streams.size();
    }
}

/// `dewbow … | true`: the reader has what it wanted.
TEST(Surroundings, ReaderOfStandardOutputHasGone) {
    const RenderFolder folder;
    const auto before = folder.snapshot();
    const Start start{.prepare = [] {
        int ends[2];
        if (::pipe(ends) != 0 || ::dup2(ends[1], 1) != 1) return false;
        ::close(ends[0]);
        ::close(ends[1]);
        std::signal(SIGPIPE, SIG_IGN);
        const bool broken = ::write(1, "x", 1) < 0 && errno == EPIPE;
        std::signal(SIGPIPE, SIG_DFL);
        return broken;
    }};
    const Outcome outcome =
        run_program(DEWBOW_BINARY, tiny_render({"--json", "-o", "ring.png"}), folder.path(), start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(losses(before, folder, outcome, {{"ring.png", true_pixels("ring.png")}}), "");
}

}  // namespace
}  // namespace dewbow::faults
