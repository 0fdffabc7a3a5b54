// SPDX-License-Identifier: Apache-2.0

// Calls of the system that fail (rows F7, F8): strace makes each call that touches the folder fail
// in turn, libfiu some at random. Whatever fails, an exit code of 0 means a whole picture, and any
// other one the old picture or the whole new one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

namespace fs = std::filesystem;

/// One call that the program makes: strace counts them by name, from 1.
struct Call {
    std::string name;
    int index = 0;
    std::string line;
};

/// The calls of a log of strace that name `folder`.
std::vector<Call> calls_within(const fs::path& folder, const std::string& log) {
    std::map<std::string, int> counts;
    std::vector<Call> calls;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find('('));
        const int index = ++counts[name];
        if (line.find(folder.string()) != std::string::npos) calls.push_back({name, index, line});
    }
    return calls;
}

class InjectedFaults : public testing::Test {
protected:
    static constexpr const char* kTraced =
        "trace=openat,write,fsync,fchmod,rename,renameat2,link,close,flock,unlink";

    void SetUp() override {
        folder_.put("ring.png", "an older picture");
        folder_.put("ring.exr", "another older picture");
        for (const char* name : {"ring.png", "ring.exr"}) outputs_[name] = true_pixels(name);
        before_ = folder_.snapshot();
    }

    /// Writes both pictures by absolute names, so that strace's lines tell the folder.
    Words render() const {
        Words words = tiny_render({"--threads", "1"});
        words[1] = (folder_.path() / words[1]).string();
        for (const auto& [name, pixels] : outputs_)
            words = words + Words{"-o", (folder_.path() / name).string()};
        return words;
    }
    Outcome run_traced(const fs::path& strace, const Words& faults) const {
        const Words watch{"-y", "-o", log().string(), "-e", kTraced};
        return run_program(strace, watch + faults + Words{DEWBOW_BINARY} + render(), logs_.path());
    }
    fs::path log() const { return logs_.path() / "log"; }
    std::string logged() const { return logs_.snapshot()[log().string()]; }
    /// The folder as it was before any render.
    void restore() const {
        for (const auto& [path, bytes] : folder_.snapshot()) fs::remove(path);
        for (const auto& [path, bytes] : before_)
            folder_.put(fs::path(path).filename().string(), bytes);
    }

    RenderFolder folder_;
    Folder logs_;
    std::map<std::string, std::string> outputs_, before_;
};

/// EINTR is no failure, only a call to be made again.
TEST_F(InjectedFaults, EveryCallInTurn) {
    const fs::path strace = find_tool("strace");
    if (strace.empty()) GTEST_SKIP() << "there is no strace to make calls fail with";
    const Outcome clean = run_traced(strace, {});
    const std::vector<Call> calls = calls_within(folder_.path(), logged());
    if (calls.empty()) GTEST_SKIP() << "strace may not trace here: " << clean.standard_error;
    ASSERT_EQ(losses(before_, folder_, clean, outputs_), "");

    std::map<std::string, int> injected, noticed;
    for (const Call& call : calls) {
        for (const std::string error : {"EIO", "ENOSPC", "EINTR"}) {
            SCOPED_TRACE(error + " from " + call.line);
            restore();
            const Outcome outcome = run_traced(
                strace,
                {"-e", fmt::format("inject={}:error={}:when={}", call.name, error, call.index)});
            ASSERT_NE(logged().find("(INJECTED)"), std::string::npos);
            ++injected[call.name];
            noticed[call.name] += outcome.exit_code != 0;
            // What cannot be removed stays; nothing else may.
            if (call.name != "unlink") {
                EXPECT_EQ(losses(before_, folder_, outcome, outputs_), "");
            }
            if (error == "EINTR") {
                EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
            }
        }
    }
    for (const char* name : {"openat", "write", "fsync", "rename", "close"}) {
        EXPECT_GE(injected[name], 6) << name;
        EXPECT_GE(noticed[name], 1) << name;
    }
}

/// Of libfiu's names: open and close, read and write (also short ones), flush and rename; not
/// unlink, which would only leave behind what was to be removed.
const Words kRandomPoints{"oc/*", "rw/*", "sync/*", "dir/rename"};
constexpr double kProbability = 0.1;

class RandomFaults : public InjectedFaults {
protected:
    /// One run for each seed from 1 to `seeds`.
    void run(int seeds) const {
        const fs::path fiu_run = find_tool("fiu-run");
        if (fiu_run.empty()) GTEST_SKIP() << "there is no fiu-run to make calls fail with";
        Words words{"-x"};
        for (const std::string& point : kRandomPoints)
            words = words + Words{"-c", fmt::format("enable_random name=posix/io/{},probability={}",
                                                    point, kProbability)};
        words = words + Words{DEWBOW_BINARY} + render();
        int noticed = 0;
        for (int seed = 1; seed <= seeds; ++seed) {
            SCOPED_TRACE(fmt::format("FIU_PRNG_SEED={}", seed));
            restore();
            const Outcome outcome =
                run_program(fiu_run, words, logs_.path(),
                            {.environment = {fmt::format("FIU_PRNG_SEED={}", seed)}});
            EXPECT_EQ(losses(before_, folder_, outcome, outputs_), "");
            noticed += outcome.exit_code != 0;
        }
        EXPECT_GE(noticed, 1) << "no fault fired";
        EXPECT_LT(noticed, seeds) << "only what always fails was tried";
    }
};
class LongRandomFaults : public RandomFaults {};

TEST_F(RandomFaults, OneCallInTen) { run(12); }
TEST_F(LongRandomFaults, OneCallInTen) { run(300); }

}  // namespace
}  // namespace dewbow::faults
