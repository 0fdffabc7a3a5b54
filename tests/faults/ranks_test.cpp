// SPDX-License-Identifier: Apache-2.0

// `mpirun -n N dewbow render …` (rows F22 and F23): any number of ranks gives the same film, also
// when one is killed or stopped; when rank 0 is killed, --resume goes on. Judged by the film's hash
// and --json, never by mpirun's exit code.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

using nlohmann::json;

/// root may use mpirun; more ranks than processors may be started, and do not block each other.
const Start kMpi{.environment = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                                 "OMPI_MCA_rmaps_base_oversubscribe=1",
                                 "OMPI_MCA_mpi_yield_when_idle=1"}};

/// About a second of one processor: long enough for faults to meet it.
const Words kLong{"render",
                  kTinyScene,
                  "--size",
                  "64x48",
                  "--spp",
                  "600",
                  "--quiet",
                  "--json",
                  "--threads",
                  "1",
                  "-o",
                  "ring.png",
                  "--checkpoint-every",
                  "0.1s"};
constexpr const char* kCheckpoint = "ring.png.dewbow";

class Ranks : public testing::Test {
protected:
    void SetUp() override {
        if (!DEWBOW_HAS_MPI) GTEST_SKIP() << "dewbow was built without MPI";
        mpirun_ = find_tool("mpirun");
        if (mpirun_.empty()) GTEST_SKIP() << "mpirun is not installed";
    }

    /// Each rank writes its number into a file before it becomes dewbow.
    std::unique_ptr<Program> start(int ranks, const Words& words) const {
        return std::make_unique<Program>(
            mpirun_,
            Words{"--mca", "orte_abort_on_non_zero_status", "0", "-n", std::to_string(ranks), "sh",
                  "-c", "echo $$ > pid-$OMPI_COMM_WORLD_RANK; exec \"$0\" \"$@\"", DEWBOW_BINARY} +
                words,
            folder_.path(), kMpi);
    }
    Outcome alone(const Words& words) const {
        return run_program(DEWBOW_BINARY, words, folder_.path());
    }
    std::string true_hash(const Words& words) const {
        const Outcome outcome = alone(words);
        return json::parse(outcome.standard_output).at("film_hash");
    }
    bool exists(const std::string& name) const {
        return std::filesystem::exists(folder_.path() / name);
    }
    int pid_of(int rank) const {
        std::ifstream file(folder_.path() / fmt::format("pid-{}", rank));
        int pid = 0;
        file >> pid;
        return pid;
    }
    /// Waits until the render is under way, as its checkpoint tells, and sends `signal` to a rank.
    void strike(const Program& program, int rank, int signal) const {
        while (program.runs() && !exists(kCheckpoint))
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ASSERT_GT(pid_of(rank), 1);
        ASSERT_EQ(::kill(pid_of(rank), signal), 0) << "the fault did not fire";
    }
    void check_loss(int signal) const;

    RenderFolder folder_;
    std::filesystem::path mpirun_;
};

TEST_F(Ranks, AnyNumberOfThemGivesTheSameFilm) {
    const Words words = tiny_render(
        {"--size", "48x32", "--spp", "18", "--json", "--threads", "1", "-o", "ring.png"});
    const std::string hash = true_hash(words);
    const std::string pixels = pixels_of(folder_.path() / "ring.png");
    for (const int ranks : {1, 2, 3, 4, 8}) {
        std::filesystem::remove(folder_.path() / "ring.png");
        const Outcome outcome = start(ranks, words)->wait();
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        const json report = json::parse(outcome.standard_output);  // rank 0 alone prints
        EXPECT_EQ(report.at("film_hash"), hash) << ranks;
        EXPECT_EQ(report.at("complete"), true);
        EXPECT_EQ(pixels_of(folder_.path() / "ring.png"), pixels);
        if (ranks > 1) {
            EXPECT_EQ(report.at("ranks").at("units_of_rank").size(), std::size_t(ranks));
        }
    }
}

void Ranks::check_loss(int signal) const {
    const std::string hash = true_hash(kLong);
    const std::string pixels = pixels_of(folder_.path() / "ring.png");
    std::filesystem::remove(folder_.path() / "ring.png");
    const auto program = start(3, kLong);
    strike(*program, 1, signal);
    const Outcome outcome = program->wait();
    const json report = json::parse(outcome.standard_output);
    EXPECT_EQ(report.at("ranks").at("lost_ranks"), json::array({1})) << "the fault did not fire";
    EXPECT_EQ(report.at("film_hash"), hash);
    EXPECT_EQ(report.at("complete"), true);
    EXPECT_EQ(pixels_of(folder_.path() / "ring.png"), pixels);
    EXPECT_NE(outcome.standard_error.find("rank 1 does not answer, and is lost"), std::string::npos)
        << outcome.standard_error;
    EXPECT_FALSE(exists(kCheckpoint));
    ::kill(pid_of(1), SIGKILL);  // if mpirun has not
}

TEST_F(Ranks, OneThatIsKilledIsMadeUpFor) { check_loss(SIGKILL); }
TEST_F(Ranks, OneThatIsStoppedIsMadeUpFor) { check_loss(SIGSTOP); }

TEST_F(Ranks, WhenRankZeroIsKilledResumeGoesOn) {
    const std::string hash = true_hash(kLong);
    std::filesystem::remove(folder_.path() / "ring.png");
    {
        const auto program = start(3, kLong);
        strike(*program, 0, SIGKILL);
        program->send(SIGTERM);  // the others would wait for rank 0 for half a minute
        const Outcome outcome = program->wait();
        EXPECT_EQ(outcome.standard_output, "") << "the fault did not fire";
    }
    EXPECT_FALSE(exists("ring.png"));
    ASSERT_TRUE(exists(kCheckpoint));
    const Outcome outcome = alone(kLong + Words{"--resume"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(json::parse(outcome.standard_output).at("film_hash"), hash);
}

TEST_F(Ranks, WhatIsWrongIsSaidOnce) {
    const Outcome outcome = start(3, {"render", "none.toml", "-o", "ring.png"})->wait();
    const std::string& text = outcome.standard_error;
    const std::size_t first = text.find("none.toml: ");
    ASSERT_NE(first, std::string::npos) << text;
    EXPECT_EQ(text.find("none.toml: ", first + 1), std::string::npos) << text;
    EXPECT_EQ(text.find("MPI_ABORT"), std::string::npos) << text;
}

TEST(RanksWithoutMpi, AreRefused) {
    if (DEWBOW_HAS_MPI) GTEST_SKIP() << "dewbow was built with MPI";
    const RenderFolder folder;
    const Start two{.environment = {"OMPI_COMM_WORLD_RANK=0", "OMPI_COMM_WORLD_SIZE=2"}};
    const Outcome outcome =
        run_program(DEWBOW_BINARY, tiny_render({"-o", "ring.png"}), folder.path(), two);
    EXPECT_EQ(faults_of_answer(outcome, 1, {"built without MPI", "--slice"}), "");
}

}  // namespace
}  // namespace dewbow::faults
