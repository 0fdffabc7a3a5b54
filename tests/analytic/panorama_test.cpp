// SPDX-License-Identifier: Apache-2.0

// A panorama of an environment is that environment: the way there and back again.

#include <gtest/gtest.h>

#include "dewbow/render/session.h"
#include "dewbow/spectrum/rgb.h"
#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kWidth = 24, kHeight = 12;
/// 64 packets of 16 stratified wavelengths integrate the smooth spectra of RGB light to 3e-3. A
/// pixel in the wrong place is off by 1/36 at least.
constexpr double kColour = 5e-3;

/// A picture in which no two pixels are alike.
std::shared_ptr<ImageEnvironment> numbered() {
    auto image = std::make_shared<ImageEnvironment>();
    image->width = kWidth, image->height = kHeight;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            image->pixels.push_back({{0.2 + x / 24.0, 0.2 + y / 12.0, 0.2 + (x + y) / 36.0}});
    return image;
}

FilmSums panorama_of(const std::shared_ptr<const ImageEnvironment>& environment) {
    Scene scene = empty_scene();
    scene.lights.push_back(environment);
    scene.camera.projection = Panorama{};
    scene.film.width = kWidth, scene.film.height = kHeight;
    scene.film.filter = {FilterKind::box, 1e-9};  // the centres of pixels
    scene.render.samples_per_pixel = 64;
    scene.render.packet = 16;
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_path_estimator(scene), options, film);
    return film;
}

TEST(Panorama, OfAnEnvironmentIsItsPicture) {
    const auto original = numbered();
    auto copy = std::make_shared<ImageEnvironment>(*original);
    const FilmSums once = panorama_of(original);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const auto rgb = rgb_from_xyz<LinearSrgb>(once.xyz(x, y));
            const std::size_t i = std::size_t(y * kWidth + x);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(rgb[c], original->pixels[i][c], kColour) << x << " " << y;
            copy->pixels[i] = rgb;
        }
    const FilmSums twice = panorama_of(copy);
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            EXPECT_NEAR(twice.xyz(x, y)[1], once.xyz(x, y)[1], 2.0 * kColour) << x << " " << y;
}

}  // namespace
}  // namespace dewbow
