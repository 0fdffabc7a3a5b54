// SPDX-License-Identifier: Apache-2.0
#include "child_process.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"
#include "scratch_folder.h"

namespace dewbow::bench {
namespace {

std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

TEST(ChildProcess, SaysHowItEnded) {
    const ScratchFolder folder;
    EXPECT_EQ(run_child(shell("exit 3"), folder.path()).exit_code, 3);
    EXPECT_EQ(run_child(shell("kill -9 $$"), folder.path()).exit_code, 128 + 9);
    EXPECT_THROW(run_child({"/no/such/program"}, folder.path()), InputError);
}

TEST(ChildProcess, RunsInItsFolderAndBelievesIt) {
    const ScratchFolder folder;
    run_child(shell("pwd; echo $PWD; echo twice >&2"), folder.path());
    const std::string path = folder.path().string();
    EXPECT_EQ(log_tail(folder.path()), path + '\n' + path + "\ntwice\n");
}

TEST(ChildProcess, CountsTheTimeOfItsOwnChildrenAndNotThatOfSleep) {
    const ScratchFolder folder;
    const ChildUsage asleep = run_child(shell("sleep 0.3"), folder.path());
    EXPECT_GE(asleep.wall_s, 0.3);
    EXPECT_LT(asleep.cpu_s, 0.2);
    const std::string count = "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done";
    const ChildUsage alone = run_child(shell(count), folder.path());
    const ChildUsage nested = run_child(shell("(" + count + "); true"), folder.path());
    EXPECT_GT(alone.cpu_s, 0.0);
    /// The loop takes about 50 ms; a shell that starts and stops takes a few.
    EXPECT_GT(nested.cpu_s, 0.3 * alone.cpu_s);
}

// What wait4 says would be the parent's peak: a child begins as its copy.
TEST(ChildProcess, MemoryIsItsOwn) {
    const std::vector<char> large(std::size_t(200) << 20, 'x');
    const ScratchFolder folder;
    const ChildUsage usage = run_child(shell("sleep 0.1"), folder.path());
    EXPECT_GT(usage.peak_memory_MiB, 0.1);
    EXPECT_LT(usage.peak_memory_MiB, 50.0);
    EXPECT_EQ(large[12345], 'x');
}

TEST(ChildProcess, FirstLineIsTheVersion) {
    EXPECT_EQ(first_line_of(shell("echo; echo one; echo two")), "one");
    EXPECT_EQ(first_line_of(shell("true")), "");
}

}  // namespace
}  // namespace dewbow::bench
