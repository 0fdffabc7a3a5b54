// SPDX-License-Identifier: Apache-2.0

// Single pixels far above their neighbours: what is left of rare bright paths. In a cut stone
// bright pixels are real, so they are held against a longer render.

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/import/import.h"
#include "dewbow/render/session.h"

namespace dewbow {
namespace {

constexpr int kWidth = 96, kHeight = 72;
constexpr int kSamples = 1024, kReferenceSamples = 4096;
/// A pixel above this times the median of the 5 × 5 around it stands out.
constexpr double kStandsOut = 10.0;
/// The reference has it too if it stands out by half as much there: its own noise moves the ratio.
constexpr double kReferenceHas = 5.0;
/// Darker neighbourhoods than this (white is 1) are left out: ten times next to nothing is not
/// seen.
constexpr double kDark = 1e-3;

std::vector<double> luminances(Scene scene, int samples, std::uint64_t seed) {
    scene.film.width = kWidth, scene.film.height = kHeight;
    scene.render.samples_per_pixel = samples;
    scene.render.seed = seed;
    const auto estimator = estimators().front().make(scene);
    FilmSums film = make_film(scene, {});
    run_session(scene, *estimator, {}, film);
    std::vector<double> y;
    for (int row = 0; row < kHeight; ++row)
        for (int column = 0; column < kWidth; ++column) y.push_back(film.xyz(column, row)[1]);
    return y;
}

/// How far pixel (x, y) stands above the median of the 5 × 5 around it.
double prominence(const std::vector<double>& picture, int x, int y) {
    std::vector<double> around;
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            around.push_back(picture[std::size_t((y + dy) * kWidth + x + dx)]);
    std::nth_element(around.begin(), around.begin() + 12, around.end());
    return picture[std::size_t(y * kWidth + x)] / std::max(kDark, around[12]);
}

int count_fireflies(const std::vector<double>& picture, const std::vector<double>& reference) {
    int count = 0;
    for (int y = 2; y < kHeight - 2; ++y)
        for (int x = 2; x < kWidth - 2; ++x)
            count += prominence(picture, x, y) > kStandsOut &&
                     prominence(reference, x, y) < kReferenceHas;
    return count;
}

TEST(LongFireflies, TheDiamondHasNoneAfter1024Samples) {
    const Scene scene = load_scene(DEWBOW_SOURCE_DIR "/examples/diamond.toml").scene;
    const std::vector<double> reference = luminances(scene, kReferenceSamples, 1);
    std::vector<double> picture = luminances(scene, kSamples, 0);
    EXPECT_EQ(count_fireflies(picture, reference), 0);
    // Planted: one pixel of the table.
    picture[std::size_t(30 * kWidth + 48)] += 100.0;
    EXPECT_EQ(count_fireflies(picture, reference), 1);
}

}  // namespace
}  // namespace dewbow
