// SPDX-License-Identifier: Apache-2.0

// Two renders to one file (row F11): the second refuses and names the first; what a killed one has
// left locks nothing. With flock, and on a file system that has none, for which strace stands in.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "dewbow/base/file_lock.h"
#include "dewbow/base/process_identity.h"
#include "tiny_render.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOutput = "ring.png";
constexpr const char* kLock = ".ring.png.lock";

/// Renders for an hour, if it is let.
const Words kEndless{"render", kTinyScene, "--size",  "16x16", "--time", "3600s",
                     "--spp",  "16777216", "--quiet", "-o",    kOutput};

bool wait_for(const fs::path& file, const Program& maker) {
    while (maker.runs()) {
        if (fs::exists(file)) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

/// The number that the lock file names.
int owner_of(const Folder& folder) {
    const std::string text = folder.snapshot()[(folder.path() / kLock).string()];
    const std::size_t at = text.find("\npid ");
    return at == std::string::npos ? 0 : std::atoi(text.c_str() + at + 5);
}

/// How the program is run: as it is, or where flock is not known.
struct System {
    std::string name;
    fs::path program;
    Words before;
};

class LockedOutput : public testing::Test {
protected:
    Outcome run(const System& system, const Words& words) const {
        return run_program(system.program, system.before + words, folder_.path());
    }
    void check(const System& system) const;

    RenderFolder folder_;
};

void LockedOutput::check(const System& system) const {
    const std::string pixels = true_pixels(kOutput);
    folder_.put(kOutput, "an older picture");
    const auto before = folder_.snapshot();
    Program first(system.program, system.before + kEndless, folder_.path());
    ASSERT_TRUE(wait_for(folder_.path() / kLock, first)) << first.wait().standard_error;
    const int pid = owner_of(folder_);

    const Outcome second = run(system, tiny_render({"-o", kOutput}));
    EXPECT_EQ(second.exit_code, 1);
    EXPECT_NE(second.standard_error.find(fmt::format("ring.png: another process writes this file: "
                                                     "number {} on {}, since 2",
                                                     pid, this_process().host)),
              std::string::npos)
        << second.standard_error;
    fs::create_symlink(kOutput, folder_.path() / "link.png");
    EXPECT_EQ(run(system, tiny_render({"-o", "link.png"})).exit_code, 1);
    fs::remove(folder_.path() / "link.png");
    EXPECT_EQ(run(system, tiny_render({"-o", "other.png"})).exit_code, 0);
    EXPECT_EQ(pixels_of(folder_.path() / "other.png"), pixels);
    fs::remove(folder_.path() / "other.png");

    ASSERT_GT(pid, 1);
    ASSERT_EQ(::kill(pid, SIGKILL), 0);
    first.wait();
    EXPECT_TRUE(fs::exists(folder_.path() / kLock)) << "the lock that was to be stale is gone";
    const Outcome third = run(system, tiny_render({"-o", kOutput}));
    EXPECT_EQ(third.exit_code, 0);
    EXPECT_NE(third.standard_error.find("left this file without finishing it"), std::string::npos);
    EXPECT_EQ(losses(before, folder_, third, {{kOutput, pixels}}), "");
}

TEST_F(LockedOutput, SecondIsRefusedAndStaleLockTakenOver) { check({"flock", DEWBOW_BINARY, {}}); }

TEST_F(LockedOutput, WithoutFlock) {
    const fs::path strace = find_tool("strace");
    if (strace.empty()) GTEST_SKIP() << "there is no strace to take flock away with";
    const std::string log = (folder_.path() / "log").string();
    const Words before{
        "-f", "-o", log, "-e", "trace=flock", "-e", "inject=flock:error=ENOLCK", DEWBOW_BINARY};
    const Outcome probe = run({"", strace, before}, tiny_render({"-o", "probe.png"}));
    const std::string calls = folder_.snapshot()[log];
    if (calls.find("flock(") == std::string::npos)
        GTEST_SKIP() << "strace may not trace here: " << probe.standard_error;
    ASSERT_NE(calls.find("(INJECTED)"), std::string::npos) << calls;
    fs::remove(folder_.path() / "probe.png");
    fs::remove(log);
    Words silent = before;
    silent[2] = "/dev/null";
    check({"no flock", strace, silent});
}

/// Whether a process of another machine still runs, nobody here can tell.
TEST_F(LockedOutput, WithoutFlockAnotherMachinesLockHolds) {
    const fs::path strace = find_tool("strace");
    if (strace.empty()) GTEST_SKIP() << "there is no strace to take flock away with";
    const std::string lock =
        "dewbow lock 1\npid 7\nhost elsewhere\nsince 2026-01-02 03:04:05 UTC\n";
    folder_.put(kLock, lock);
    const Words without_flock{"-f",         "-o", "/dev/null", "-e", "inject=flock:error=ENOLCK",
                              DEWBOW_BINARY};
    const auto before = folder_.snapshot();
    const Outcome refused =
        run_program(strace, without_flock + tiny_render({"-o", kOutput}), folder_.path());
    if (refused.exit_code == 0) GTEST_SKIP() << "strace may not trace here";
    EXPECT_EQ(faults_of_answer(refused, 1,
                               {"number 7 on elsewhere, since 2026-01-02 03:04:05 UTC",
                                "if it does not run any more, remove", kLock}),
              "");
    EXPECT_EQ(folder_.snapshot(), before);
    // With flock, that nobody holds it is known.
    const Outcome taken = run_program(DEWBOW_BINARY, tiny_render({"-o", kOutput}), folder_.path());
    EXPECT_EQ(taken.exit_code, 0) << taken.standard_error;
}

TEST_F(LockedOutput, OneFileByTwoNamesIsNoQuarrel) {
    const Outcome outcome = run_program(
        DEWBOW_BINARY, tiny_render({"-o", kOutput, "-o", "./ring.png"}), folder_.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels_of(folder_.path() / kOutput), true_pixels(kOutput));
    EXPECT_FALSE(fs::exists(folder_.path() / kLock));
}

}  // namespace
}  // namespace dewbow::faults
