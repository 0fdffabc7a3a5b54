// SPDX-License-Identifier: Apache-2.0

// States that are damaged or of another render (row F10): refused with the reason, and never a
// wrong picture. The file stays, for whoever can still use it.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <random>
#include <sstream>

#include "dewbow/render/state.h"
#include "job.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

/// Half a picture is kept in the folder.
class DamagedState : public testing::Test {
protected:
    void SetUp() override {
        const Outcome outcome = interrupt(job_, folder_, SIGINT);
        ASSERT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.standard_error;
        good_ = bytes_of(folder_.path() / kState);
        ASSERT_GT(good_.size(), 1000u);
    }

    /// What is wrong with how --resume takes these bytes; empty if it refuses them as it must.
    std::string faults_with(const std::string& bytes, const Words& phrases,
                            const Words& more = {}) const {
        folder_.put(kState, bytes);
        const auto before = folder_.snapshot();
        const Outcome outcome =
            run_program(DEWBOW_BINARY, job_.words(1, Words{"--resume"} + more), folder_.path());
        std::string faults = faults_of_answer(outcome, 1, Words{kState} + phrases);
        if (folder_.snapshot() != before) faults += "  * the folder is not as it was\n";
        return faults;
    }
    /// The bytes of the good state after a change.
    std::string changed(const std::function<void(RenderState&)>& change) const {
        RenderState state = state_from_bytes(good_, "good");
        change(state);
        return state_bytes(state);
    }
    void check_damage(int truncations, int flips) const;

    const Job job_{.samples_per_pixel = 120};
    RenderFolder folder_;
    std::string good_;
};
class LongDamagedState : public DamagedState {};

void DamagedState::check_damage(int truncations, int flips) const {
    for (int i = 0; i < truncations; ++i) {
        const std::size_t length = good_.size() * std::size_t(i) / std::size_t(truncations);
        EXPECT_EQ(faults_with(good_.substr(0, length), {}), "") << length << " bytes are left";
    }
    EXPECT_EQ(faults_with(good_.substr(0, good_.size() - 1), {}), "");
    EXPECT_EQ(faults_with(good_ + "x", {}), "");
    std::mt19937_64 random(10);
    for (int i = 0; i < flips; ++i) {
        // Half of them among the first bytes, where the structure is.
        const std::size_t byte = random() % (i % 2 == 0 ? good_.size() : 512);
        const int bit = int(random() % 8);
        std::string damaged = good_;
        damaged[byte] = char(damaged[byte] ^ (1 << bit));
        EXPECT_EQ(faults_with(damaged, {}), "") << "bit " << bit << " of byte " << byte;
    }
}

TEST_F(DamagedState, TruncatedOrWithABitTurned) { check_damage(8, 24); }
TEST_F(LongDamagedState, TruncatedOrWithABitTurned) { check_damage(41, 1000); }

TEST_F(DamagedState, TheGoodOneIsTaken) {
    const Outcome outcome = run_program(DEWBOW_BINARY, job_.words(1, {"--resume"}), folder_.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
}

/// Both values are named.
TEST_F(DamagedState, OfAnotherRender) {
    EXPECT_EQ(faults_with(good_, {"another render", "seed", "0", "7"}, {"--seed", "7"}), "");
    EXPECT_EQ(faults_with(good_, {"another render", "48", "47"}, {"--size", "47x48"}), "");
    EXPECT_EQ(faults_with(good_, {"another render", "120", "121"}, {"--spp", "121"}), "");
    EXPECT_EQ(faults_with(good_, {"another render", "packet 8", "packet 4"}, {"--packet", "4"}),
              "");
    EXPECT_EQ(faults_with(good_, {"another render", "bins"}, {"--spectral-bins", "3"}), "");
    EXPECT_EQ(faults_with(changed([](RenderState& s) { s.identity.fingerprint = "dewbow 0.0.1"; }),
                          {"another render", "fingerprint", "dewbow 0.0.1"}),
              "");
    folder_.put(kTinyScene, std::string(kTinySceneText) + "# and a ring\n");
    EXPECT_EQ(faults_with(good_, {"another render", "scene"}), "");
}

TEST_F(DamagedState, NoStateAtAll) {
    EXPECT_EQ(faults_with("", {}), "");
    EXPECT_EQ(faults_with(bytes_of(folder_.path() / kOutput), {}), "") << "a picture";
    EXPECT_EQ(faults_with(std::string(100'000, '\0'), {}), "");
    fs::remove(folder_.path() / kState);
    fs::create_directory(folder_.path() / kState);
    const auto before = folder_.snapshot();
    const Outcome outcome = run_program(DEWBOW_BINARY, job_.words(1, {"--resume"}), folder_.path());
    EXPECT_EQ(faults_of_answer(outcome, 1, {kState, "a folder"}), "");
    EXPECT_EQ(folder_.snapshot(), before);
}

/// Ten gigabytes of nothing behind a good beginning, in a tenth of that memory.
TEST_F(DamagedState, TenGigabytesOfHoles) {
    constexpr std::uintmax_t kHoles = std::uintmax_t{10} << 30;
    for (const std::string& beginning : {std::string(), good_}) {
        folder_.put(kState, beginning);
        fs::resize_file(folder_.path() / kState, kHoles);
        ASSERT_EQ(fs::file_size(folder_.path() / kState), kHoles);
        const Start start{.prepare = [] {
            constexpr rlim_t kMemory = rlim_t{2} << 30;
            const rlimit limit{kMemory, kMemory};
            return ::setrlimit(RLIMIT_AS, &limit) == 0;
        }};
        const Outcome outcome =
            run_program(DEWBOW_BINARY, job_.words(1, {"--resume"}), folder_.path(), start);
        EXPECT_EQ(faults_of_answer(outcome, 1, {kState}), "");
        EXPECT_EQ(fs::file_size(folder_.path() / kState), kHoles);
    }
    fs::remove(folder_.path() / kState);
}

}  // namespace
}  // namespace dewbow::faults
