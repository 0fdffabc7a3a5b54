// SPDX-License-Identifier: Apache-2.0

// Renders that are killed or told to stop, and go on (rows F1 to F3): one picture, whatever
// happened on the way, and nothing left beside it.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "dewbow/image/exr.h"
#include "job.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

constexpr int kMostThreads = 5;
/// Of a chain; about ten are needed.
constexpr int kMostRounds = 100;

/// The render as it is where nothing happens.
struct Undisturbed {
    explicit Undisturbed(const Job& job) {
        const RenderFolder folder;
        const auto began = std::chrono::steady_clock::now();
        const Outcome outcome = run_program(DEWBOW_BINARY, job.words(1), folder.path());
        took = std::chrono::steady_clock::now() - began;
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        pixels = pixels_of(folder.path() / kOutput);
        EXPECT_EQ(folder.snapshot().size(), 2u) << "the state was to be removed";
    }
    Seconds took{};
    std::string pixels;
};

void expect_done(const Outcome& outcome, const Folder& folder, const std::string& pixels) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels_of(folder.path() / kOutput), pixels);
    EXPECT_EQ(folder.snapshot().size(), 2u) << "there is more than scene and picture";
}

class Killed : public testing::Test {
protected:
    /// Sequences of one kill at a random moment and one resume.
    void at_random_moments(const Job& job, int sequences) {
        const Undisturbed undisturbed(job);
        int killed = 0, went_on = 0;
        for (int i = 0; i < sequences; ++i) {
            SCOPED_TRACE(i);
            const RenderFolder folder;
            killed += run_for(undisturbed.took * share_(random_), job, folder, 1).signal == SIGKILL;
            went_on += finished_units(folder) > 0;
            const Outcome second = run_program(
                DEWBOW_BINARY, job.words(threads_(random_), resume(folder)), folder.path());
            expect_done(second, folder, undisturbed.pixels);
        }
        EXPECT_GE(killed, std::max(1, sequences / 2))
            << "too many ended before they could be killed";
        EXPECT_GE(went_on, std::max(1, sequences / 4)) << "too few had anything to go on with";
    }

    Outcome run_for(Seconds time, const Job& job, const Folder& folder, int threads) {
        Program program(DEWBOW_BINARY, job.words(threads, resume(folder)), folder.path());
        std::this_thread::sleep_for(time);
        program.send(SIGKILL);
        return program.wait();
    }

    std::mt19937 random_{20261127};
    std::uniform_real_distribution<double> share_{0.0, 0.8};
    std::uniform_int_distribution<int> threads_{1, kMostThreads};
};
class LongKilled : public Killed {};

TEST_F(Killed, AtRandomMoments) { at_random_moments({}, 4); }
TEST_F(LongKilled, AtFiftyRandomMomentsOfSixSeconds) {
    at_random_moments({.samples_per_pixel = 2400, .checkpoint_every = Seconds(0.5)}, 50);
}

/// Kills when the state was kept twice, until the render is done. A program that began anew each
/// time would never end.
TEST_F(Killed, AgainAndAgainUntilItIsDone) {
    const Job job{.samples_per_pixel = 240};
    const Undisturbed undisturbed(job);
    const RenderFolder folder;
    const auto file_number = [&] {
        struct stat info {};
        return ::stat((folder.path() / kState).c_str(), &info) == 0 ? info.st_ino : 0;
    };
    int kills = 0;
    Outcome outcome;
    for (int round = 0; round < kMostRounds && outcome.exit_code != 0; ++round) {
        Program program(DEWBOW_BINARY, job.words(threads_(random_), resume(folder)), folder.path());
        ino_t last = file_number();
        for (int kept = 0; kept < 2 && program.runs();) {
            const ino_t now = file_number();
            kept += now != last;
            last = now;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        program.send(SIGKILL);
        outcome = program.wait();
        kills += outcome.signal == SIGKILL;
        ASSERT_TRUE(outcome.exit_code == 0 || outcome.signal == SIGKILL) << outcome.standard_error;
    }
    EXPECT_GE(kills, 2);
    expect_done(outcome, folder, undisturbed.pixels);
}

/// In the moment that matters most: half of a state is on the disk.
TEST_F(Killed, WhileItWritesItsState) {
    const Job job{.samples_per_pixel = 40, .checkpoint_every = Seconds(1e-6)};
    const Undisturbed undisturbed(job);
    const auto half_written = [](const Folder& folder) {
        for (const fs::directory_entry& entry : fs::directory_iterator(folder.path()))
            if (entry.path().extension() == ".tmp") return true;
        return false;
    };
    int left_half = 0;
    for (int i = 0; i < 40 && left_half < 3; ++i) {
        const RenderFolder folder;
        Program program(DEWBOW_BINARY, job.words(2), folder.path());
        // Not the first temporary file, which is the lock's.
        while (program.runs() && !fs::exists(folder.path() / kState)) continue;
        while (program.runs() && !half_written(folder)) continue;
        program.send(SIGKILL);
        program.wait();
        if (!half_written(folder)) continue;
        ++left_half;
        const Outcome second =
            run_program(DEWBOW_BINARY, job.words(threads_(random_), resume(folder)), folder.path());
        expect_done(second, folder, undisturbed.pixels);
    }
    EXPECT_GE(left_half, 1) << "no kill met a state that was being written";
}

// ---- signals -----------------------------------------------------------------------------------

std::string attribute(const fs::path& picture, const std::string& name) {
    for (const Attribute& fact : decode_exr(bytes_of(picture), "picture").attributes)
        if (fact.name == name)
            if (const auto* text = std::get_if<std::string>(&fact.value)) return *text;
    return "not there";
}

TEST(Signalled, PartialPictureSaysSoAndResumeEndsIt) {
    const Job job;
    const Undisturbed undisturbed(job);
    for (const int signal : {SIGINT, SIGTERM}) {
        SCOPED_TRACE(signal);
        const RenderFolder folder;
        const Outcome outcome = interrupt(job, folder, signal);
        EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.standard_error;
        EXPECT_NE(outcome.standard_output.find("\"complete\":false"), std::string::npos)
            << outcome.standard_output;
        EXPECT_EQ(attribute(folder.path() / kOutput, "dewbow:complete"), "false");
        EXPECT_NE(pixels_of(folder.path() / kOutput), undisturbed.pixels);
        EXPECT_GT(finished_units(folder), 0u);

        const Outcome second =
            run_program(DEWBOW_BINARY, job.words(1, {"--resume", "--json"}), folder.path());
        expect_done(second, folder, undisturbed.pixels);
        EXPECT_NE(second.standard_output.find("\"complete\":true"), std::string::npos);
        EXPECT_EQ(attribute(folder.path() / kOutput, "dewbow:complete"), "true");
    }
}

/// A FIFO that nobody reads holds the program at its end for ever; the first signal does not end
/// it, because it would lose the picture.
TEST(Signalled, SecondSignalEndsAtOnce) {
    constexpr Seconds kAtOnce{0.5};
    for (const int second : {SIGINT, SIGTERM}) {
        const RenderFolder folder;
        ASSERT_EQ(::mkfifo((folder.path() / kOutput).c_str(), 0666), 0);
        Program program(DEWBOW_BINARY, tiny_render({"--json", "-o", kOutput}), folder.path());
        std::this_thread::sleep_for(Seconds(0.5));
        ASSERT_TRUE(program.runs());
        program.send(SIGINT);
        std::this_thread::sleep_for(Seconds(0.2));
        ASSERT_TRUE(program.runs()) << "one signal was enough; the second is not tried";
        program.send(second);
        const auto sent = std::chrono::steady_clock::now();
        const Outcome outcome = program.wait();
        EXPECT_LT(std::chrono::steady_clock::now() - sent, kAtOnce);
        EXPECT_EQ(outcome.exit_code, 128 + second) << outcome.standard_error;
    }
}

}  // namespace
}  // namespace dewbow::faults
