// SPDX-License-Identifier: Apache-2.0

// `--estimator caustics`: training, camera paths and light paths give the same pixels on any number
// of threads, in slices, interrupted and resumed, on ranks, and a crop has those of the whole.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "dewbow/image/exr.h"
#include "tiny_render.h"

namespace dewbow::faults {
namespace {

constexpr const char* kScene = "caustics.toml";
/// Light of several kinds, so that there is a choice; something rough, so that weights matter.
constexpr const char* kSceneText = R"(
camera = { position = [0, 2, 2.4], look_at = [0, 0, 0] }

[materials]
flint = { type = "glass", glass = "N-SF66" }
frosted = { type = "glass", glass = "N-BK7", roughness = 0.3 }
paper = { type = "diffuse", reflectance = 0.7 }
lamp = { type = "black", emission = 20 }

[[shapes]]
type = "sphere"
radius_m = 0.3
material = "flint"
position = [0, 0.4, 0]

[[shapes]]
type = "box"
width_m = 0.3
height_m = 0.3
depth_m = 0.3
material = "frosted"
position = [0.6, 0.2, 0]

[[shapes]]
type = "plane"
material = "paper"
rotate_x_deg = -90

[[shapes]]
type = "disc"
radius_m = 0.1
material = "lamp"
position = [0.5, 2, 0]
rotate_x_deg = 90

[[lights]]
type = "distant"
direction = [0.4, -1, -0.2]
angular_radius_deg = 0.2666
irradiance = 3
)";

/// 6144 · 4 light paths a pass: several units of them.
const Words kPicture{"render",   kScene,   "--estimator",
                     "caustics", "--size", "48x32",
                     "--quiet",  "--set",  "render.caustics.light_paths=4"};

class CausticsBits : public testing::Test {
protected:
    CausticsBits() { folder_.put(kScene, kSceneText); }
    Outcome run(const Words& more, int samples = 18) const {
        return run_program(DEWBOW_BINARY,
                           kPicture + Words{"--spp", fmt::format("{}", samples)} + more,
                           folder_.path());
    }
    std::string pixels(const std::string& name) const { return pixels_of(folder_.path() / name); }
    /// Of the render to which nothing happens, on one thread.
    std::string true_pixels(int samples = 18) const {
        const Outcome outcome = run({"--threads", "1", "-o", "true.exr"}, samples);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        return pixels("true.exr");
    }

    Folder folder_;
};

TEST_F(CausticsBits, OnAnyNumberOfThreads) {
    const std::string expected = true_pixels();
    for (const char* threads : {"2", "5"}) {
        EXPECT_EQ(run({"--threads", threads, "-o", "new.exr"}).exit_code, 0);
        EXPECT_EQ(pixels("new.exr"), expected) << threads << " threads";
    }
    EXPECT_EQ(run({"--seed", "1", "-o", "new.exr"}).exit_code, 0);
    EXPECT_NE(pixels("new.exr"), expected) << "another seed";
    EXPECT_EQ(run({"--set", "render.caustics.light_paths=0", "-o", "new.exr"}).exit_code, 0);
    EXPECT_NE(pixels("new.exr"), expected) << "no light paths";
}

TEST_F(CausticsBits, InSlices) {
    const std::string expected = true_pixels();
    Words merge{"merge"};
    for (const int k : {3, 1, 4, 2}) {
        const std::string name = fmt::format("{}.dewbow", k);
        const Outcome outcome = run({"--slice", fmt::format("{}/4", k), "-o", name});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
        merge.push_back(name);
    }
    const Outcome outcome =
        run_program(DEWBOW_BINARY, merge + Words{"-o", "new.exr"}, folder_.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels("new.exr"), expected);
}

TEST_F(CausticsBits, InterruptedAndResumed) {
    constexpr int kSamples = 240;
    const std::string expected = true_pixels(kSamples);
    const Words words{"--checkpoint-every", "0.05s", "-o", "new.exr"};
    Program program(
        DEWBOW_BINARY,
        kPicture + Words{"--spp", fmt::format("{}", kSamples), "--threads", "2"} + words,
        folder_.path());
    while (program.runs() && !std::filesystem::exists(folder_.path() / "new.exr.dewbow"))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(SIGTERM);
    ASSERT_EQ(program.wait().exit_code, 143) << "it was done before it was told to stop";
    EXPECT_NE(pixels("new.exr"), expected);
    const Outcome outcome = run(words + Words{"--resume", "--threads", "3"}, kSamples);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels("new.exr"), expected);
}

TEST_F(CausticsBits, OnRanks) {
    const std::filesystem::path mpirun = find_tool("mpirun");
    if (!DEWBOW_HAS_MPI || mpirun.empty()) GTEST_SKIP() << "there is no MPI";
    const std::string expected = true_pixels();
    const Start start{
        .environment = {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
                        "OMPI_MCA_rmaps_base_oversubscribe=1", "OMPI_MCA_mpi_yield_when_idle=1"}};
    const Outcome outcome = run_program(mpirun,
                                        Words{"-n", "3", DEWBOW_BINARY} + kPicture +
                                            Words{"--spp", "18", "--threads", "1", "-o", "new.exr"},
                                        folder_.path(), start);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(pixels("new.exr"), expected);
}

TEST_F(CausticsBits, ACropIsAPartOfTheWhole) {
    true_pixels();
    const Outcome outcome = run({"--crop", "7,9,21x17", "-o", "crop.exr"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    const auto image = [&](const std::string& name) {
        return decode_exr(bytes_of(folder_.path() / name), name).image;
    };
    const Image whole = image("true.exr"), crop = image("crop.exr");
    ASSERT_EQ(crop.width, 21);
    for (const Channel& channel : crop.channels)
        for (int y = 0; y < crop.height; ++y)
            for (int x = 0; x < crop.width; ++x)
                ASSERT_EQ(
                    channel.values[std::size_t(y * crop.width + x)],
                    whole.find(channel.name)->values[std::size_t((y + 9) * whole.width + x + 7)])
                    << channel.name << " at " << x << ", " << y;
}

}  // namespace
}  // namespace dewbow::faults
