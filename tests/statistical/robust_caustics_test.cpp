// SPDX-License-Identifier: Apache-2.0

// What light paths cost and bring where they are of little use, or have far too much to do.

#include <gtest/gtest.h>

#include "../analytic/pictures.h"
#include "../analytic/welch.h"
#include "robust_scenes.h"

namespace dewbow {
namespace {

using namespace kit;

struct Measured {
    double noise = 0.0;    ///< variance of a pixel's Y, mean over pixels, over the square of mean Y
    double seconds = 0.0;  ///< of the processor, for a picture
    double mean = 0.0;     ///< Y
    std::vector<double> means;  ///< of each picture
};

Measured measure(const Scene& scene, const MakeEstimator& make, int samples, int replicates) {
    Measured result;
    std::vector<double> sum, squares;
    for (int r = 0; r < replicates; ++r) {
        const TimedFilm timed = film_of(scene, make, samples, std::uint64_t(r));
        const FilmSums& film = timed.film;
        sum.resize(std::size_t(film.crop().area()));
        squares.resize(sum.size());
        double mean = 0.0;
        for (int y = 0; y < film.height(); ++y)
            for (int x = 0; x < film.width(); ++x) {
                const auto i = std::size_t(y * film.width() + x);
                const double value = film.xyz(x, y)[1];
                sum[i] += value;
                squares[i] += value * value;
                mean += value / double(sum.size());
            }
        result.means.push_back(mean);
        result.mean += mean / replicates;
        result.seconds += timed.cpu_seconds / replicates;
    }
    for (std::size_t i = 0; i < sum.size(); ++i)
        result.noise += (squares[i] - sum[i] * sum[i] / replicates) / (replicates - 1) /
                        double(sum.size()) / (result.mean * result.mean);
    return result;
}

/// Where there is nothing to aim at, not a bit changes, and nothing is paid.
TEST(RobustCaustics, WithoutCastersItIsPath) {
    const Scene scene = no_casters();
    EXPECT_EQ(method("caustics")(scene)->light_paths(), 0.0);
    const FilmSums path = film_of(scene, method("path"), 4, 0).film;
    const FilmSums both = film_of(scene, method("caustics"), 4, 0).film;
    for (int y = 0; y < path.height(); ++y)
        for (int x = 0; x < path.width(); ++x) ASSERT_EQ(both.xyz(x, y), path.xyz(x, y));
}

/// The table of docs/caustics.md.
class LongRobustCaustics : public ::testing::TestWithParam<NamedScene> {};
TEST_P(LongRobustCaustics, Table) {
    constexpr int kReplicates = 8, kSamples = 64;
    Scene scene = GetParam().make();
    scene.film.width = scene.film.height = 64;
    const Measured path = measure(scene, method("path"), kSamples, kReplicates);
    const Measured both = measure(scene, method("caustics"), kSamples, kReplicates);
    std::printf("| %s | %.2f s | %.2f s | %.3g | %.3g | %.3g | %.4f |\n", GetParam().name,
                path.seconds, both.seconds, path.noise, both.noise,
                path.noise * path.seconds / (both.noise * both.seconds),
                both.mean / path.mean - 1.0);
}
INSTANTIATE_TEST_SUITE_P(LongScenes, LongRobustCaustics, ::testing::ValuesIn(kRobustScenes),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace dewbow
