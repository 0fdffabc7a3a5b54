// SPDX-License-Identifier: Apache-2.0
#include "measurement.h"

#include <gtest/gtest.h>

#include "dewbow_contestants.h"
#include "exact_picture.h"
#include "report.h"
#include "scratch_folder.h"

namespace dewbow::bench {
namespace {

const std::filesystem::path kScenes = std::filesystem::path(DEWBOW_SOURCE_DIR) / "bench" / "scenes";
constexpr int kSize = 16;

Programs our_programs() {
    const std::map<std::string, std::filesystem::path> named = {{"dewbow", DEWBOW_BINARY}};
    return Programs(named);
}

class Smoke : public testing::Test {
protected:
    Smoke() {
        contestants_.push_back(find_path(our_programs()));
        plan_.samples_per_pixel = {4, 64};
        plan_.repeats = 2;
        plan_.references.folder = folder_.path();
        plan_.references.truth_samples = 256;
    }
    Measurements measure_scene(const std::string& name) {
        std::vector<BenchScene> scenes;
        scenes.push_back(load_bench_scene(kScenes / (name + ".toml"), kSize, kSize));
        return measure(scenes, contestants_, plan_, [](const std::string&) {});
    }

    ScratchFolder folder_;
    std::vector<ContestantPtr> contestants_;
    Plan plan_;
};

TEST_F(Smoke, MoreSamplesCostMoreAndErrLess) {
    const Measurements all = measure_scene("disc");
    ASSERT_EQ(all.results.size(), 2u);
    ASSERT_EQ(all.runs.size(), 4u);
    const Result &few = all.results[0], &many = all.results[1];
    EXPECT_GT(few.cpu_s, 0.0);
    EXPECT_GT(few.memory_MiB, 1.0);
    // Sixteen times the samples of a method that is unbiased: MSE falls sixteenfold, and by more
    // thanks to stratification.
    EXPECT_LT(many.over("whole").truth.mse, few.over("whole").truth.mse / 4.0);
    EXPECT_LT(many.over("whole").truth.flip, few.over("whole").truth.flip);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(many.card[c], 1.0, 0.02);
    const std::string report = report_of(all, plan_, {});
    EXPECT_NE(report.find("| path |  | 64 |"), std::string::npos) << report;
    EXPECT_NE(json_lines_of(all, plan_, {}).find("\"cpu_s\""), std::string::npos);
    EXPECT_NE(plot_of(all, all.scenes[0]).find("<svg"), std::string::npos);
}

TEST_F(Smoke, ReferencesAreKept) {
    measure_scene("slab");
    const auto files = [&] {
        std::map<std::filesystem::path, std::filesystem::file_time_type> times;
        for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
            times[file.path()] = file.last_write_time();
        return times;
    };
    const auto before = files();
    EXPECT_EQ(before.size(), 2u);
    measure_scene("slab");
    EXPECT_EQ(files(), before);
    plan_.references.truth_samples = 128;
    measure_scene("slab");
    EXPECT_EQ(files().size(), 4u);
}

/// Mean of (a − s)(b − t), over the mean of (a − s)²: where pictures a, b and truths s, t have
/// independent noise its expectation is 0, and what both pictures have wrong remains. The bound is
/// five standard deviations of what noise alone does (0.12 over 40 pairs of seeds in the worst of
/// disc, slit and slab): one false alarm in 10⁶.
constexpr double kCommonError = 0.6;
double common_error(const Picture& a, const Picture& b, const Picture& s, const Picture& t) {
    double common = 0.0, square = 0.0;
    for (std::size_t i = 0; i < s.pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const double first = a.pixels[i][c] - s.pixels[i][c];
            common += first * (b.pixels[i][c] - t.pixels[i][c]);
            square += first * first;
        }
    return common / square;
}

class PathAgainstTruth : public testing::TestWithParam<const char*> {};

TEST_P(PathAgainstTruth, ErrsByNoiseAlone) {
    const BenchScene scene =
        load_bench_scene(kScenes / (std::string(GetParam()) + ".toml"), kSize, kSize);
    const ContestantPtr path = find_path(our_programs());
    const auto render = [&](std::uint64_t seed) {
        const ScratchFolder folder;
        const Order order{scene, {0, 64, seed}, 1, folder.path()};
        EXPECT_EQ(run_child(path->write(order), folder.path()).exit_code, 0);
        return path->read(order);
    };
    constexpr int kSamples = 512;
    const Picture one_truth = exact_picture(scene.plain, kSamples, 1);
    const Picture other_truth = exact_picture(scene.plain, kSamples, 2);
    Picture first = render(1), second = render(2);
    EXPECT_LT(std::abs(common_error(first, second, one_truth, other_truth)), kCommonError);
    // A planted bug: a quarter too bright.
    for (Picture* picture : {&first, &second})
        for (auto& pixel : picture->pixels) pixel = pixel * 1.25;
    EXPECT_GT(common_error(first, second, one_truth, other_truth), kCommonError);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PathAgainstTruth,
                         testing::Values("disc", "slit", "slab", "diamond"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace dewbow::bench
