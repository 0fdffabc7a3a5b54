// SPDX-License-Identifier: Apache-2.0

// The job files of examples/farm, as far as they run without a farm: a task after the other, with
// the variables that Slurm sets and the numbers that OpenCue puts in. The oracle is the undivided
// render.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tiny_render.h"

namespace dewbow::faults {
namespace {

const std::string kFarm = DEWBOW_SOURCE_DIR "/examples/farm/";
const std::string kDewbow = std::string("DEWBOW=") + DEWBOW_BINARY;
const Words kPicture{kTinyScene, "--size", "48x32", "--spp", "18", "--quiet"};
constexpr int kSlices = 3;

class FarmFiles : public testing::Test {
protected:
    void run(const std::string& script, const Words& words, const Words& variables = {}) const {
        const Outcome outcome =
            run_program("/bin/bash", Words{kFarm + script} + words, folder_.path(),
                        {.environment = variables + Words{kDewbow}});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    }
    void expect_whole() const {
        EXPECT_EQ(pixels_of(folder_.path() / "ring.png"),
                  true_pixels("whole.png", {"--size", "48x32", "--spp", "18"}));
    }
    RenderFolder folder_;
};

TEST_F(FarmFiles, SlicesInAPlainLoop) {
    run("slices.sh", Words{std::to_string(kSlices), "ring.png"} + kPicture);
    expect_whole();
}

TEST_F(FarmFiles, GnuParallel) {
    if (find_tool("parallel").empty()) GTEST_SKIP() << "GNU parallel is not installed";
    run("parallel.sh", Words{std::to_string(kSlices), "ring.png"} + kPicture);
    expect_whole();
}

TEST_F(FarmFiles, SlurmArray) {
    for (int task = 1; task <= kSlices; ++task)
        run("slurm-array.sbatch", Words{"ring.png"} + kPicture,
            {fmt::format("SLURM_ARRAY_TASK_ID={}", task),
             fmt::format("SLURM_ARRAY_TASK_COUNT={}", kSlices), "SLURM_CPUS_PER_TASK=1"});
    run("slurm-merge.sbatch", {"ring.png", std::to_string(kSlices)});
    expect_whole();
}

/// `text` with XML's entities resolved.
std::string resolved(std::string text) {
    const std::pair<std::string, char> kEntities[] = {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}};
    for (const auto& [entity, character] : kEntities)
        for (std::size_t i = 0; (i = text.find(entity)) != std::string::npos;)
            text = text.substr(0, i) + character + text.substr(i + entity.size());
    return text;
}

/// The text between <cmd> and </cmd> of each layer.
std::vector<std::string> commands_of(const std::string& xml) {
    std::vector<std::string> commands;
    for (std::size_t at = 0; (at = xml.find("<cmd>", at)) != std::string::npos;) {
        at += 5;
        const std::string text = xml.substr(at, xml.find("</cmd>", at) - at);
        commands.push_back(resolved(text));
    }
    return commands;
}

TEST_F(FarmFiles, OpenCueFrames) {
    if (find_tool("python3").empty()) GTEST_SKIP() << "python3 is not installed";
    const Outcome job = run_program(find_tool("python3"),
                                    Words{kFarm + "opencue.py", "--dewbow", DEWBOW_BINARY,
                                          std::to_string(kSlices), "ring.png"} +
                                        kPicture,
                                    folder_.path());
    ASSERT_EQ(job.exit_code, 0) << job.standard_error;
    const std::vector<std::string> commands = commands_of(job.standard_output);
    ASSERT_EQ(commands.size(), 2u);
    const auto shell = [&](const std::string& command) {
        const Outcome outcome = run_program("/bin/sh", {"-c", command}, folder_.path());
        EXPECT_EQ(outcome.exit_code, 0) << command << '\n' << outcome.standard_error;
    };
    for (int frame = 1; frame <= kSlices; ++frame) {
        std::string command = commands[0];
        for (std::size_t i = 0; (i = command.find("#IFRAME#", i)) != std::string::npos;)
            command = command.substr(0, i) + std::to_string(frame) + command.substr(i + 8);
        shell(command);
    }
    shell(commands[1]);
    expect_whole();
}

}  // namespace
}  // namespace dewbow::faults
