// SPDX-License-Identifier: Apache-2.0

// The same scene and seed: the same bits of the film, on any number of threads, again and again,
// whole or in parts.

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/render/session.h"
#include "rain_kit.h"

namespace dewbow {
namespace {

using namespace kit;

struct ThreadsGuard {
    ~ThreadsGuard() { set_thread_count(0); }
};

/// Something of everything: a stone as mesh, analytic bodies inside one another, rough glass,
/// lights of several kinds, uneven rain.
Scene scene_of_everything() {
    Scene scene = make_empty_scene();
    scene.film.width = 50;
    scene.film.height = 37;
    scene.film.spectral_bins = 3;
    scene.render.samples_per_pixel = 6;
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 1.2, 3}, {0, 0.4, 0}, {0, 1, 0}));
    add(scene, brilliant(), dielectric(glass("gem/diamond")), translation({0, 0.452, 0}));
    add(scene, sphere_mesh(0.4, 2, true), dielectric(glass("schott/F2")),
        translation({0.9, 0.4, 0}));
    add(scene, Box{0.8 * m, 0.8 * m, 0.8 * m}, dielectric(glass("fluid/water")),
        translation({-0.9, 0.4, 0}));
    add(scene, Sphere{0.3 * m}, dielectric(glass("schott/N-SF66", nullptr, 1), 0.3),
        translation({-0.9, 0.4, 0.1}));
    add(scene, Plane{}, diffuse(0.5), rotation({1, 0, 0}, -90.0 * deg));
    add(scene, Disc{0.6 * m}, lamp(5.0),
        translation({0, 2.5, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    scene.lights.push_back(UniformEnvironment{make_constant(0.3)});
    scene.lights.push_back(PointLight{{{1, 2, 1}}, make_constant(1.0)});
    scene.lights.push_back(
        DistantLight{{-towards_sun(30.0)}, kSunDisc, make_constant(kSunIrradiance)});
    scene.rains = {rain_in_box(drops(0.1), {0, 1, 0}, {4, 1, 4})};
    scene.rains[0].chaos = Chaos{};
    return scene;
}

FilmSums render(const Scene& scene, std::optional<PixelRect> crop = {},
                const std::string& method = "path") {
    SessionOptions options;
    options.crop = crop;
    FilmSums film = make_film(scene, options);
    const auto row = std::find_if(estimators().begin(), estimators().end(),
                                  [&](const EstimatorRow& e) { return e.name == method; });
    const SessionResult result = run_session(scene, *row->make(scene), options, film);
    EXPECT_EQ(result.invalid_samples, 0);
    EXPECT_EQ(result.film_hash, film.fingerprint());
    return film;
}

TEST(SameBits, OnAnyNumberOfThreadsAndAgain) {
    const ThreadsGuard guard;
    const Scene scene = scene_of_everything();
    set_thread_count(1);
    const std::uint64_t once = render(scene).fingerprint();
    EXPECT_EQ(render(scene).fingerprint(), once) << "again";
    for (const int threads : {2, 5}) {
        set_thread_count(threads);
        EXPECT_EQ(render(scene).fingerprint(), once) << threads << " threads";
    }
    Scene other = scene_of_everything();
    other.render.seed = 1;
    EXPECT_NE(render(other).fingerprint(), once) << "another seed";
}

TEST(SameBits, ACropIsAPartOfTheWhole) {
    const Scene scene = scene_of_everything();
    const FilmSums whole = render(scene);
    const PixelRect crop{13, 5, 39, 31};
    const FilmSums part = render(scene, crop);
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x) {
            ASSERT_EQ(part.samples(x, y), whole.samples(x, y));
            ASSERT_EQ(part.xyz(x, y), whole.xyz(x, y)) << x << ", " << y;
            ASSERT_EQ(part.normal(x, y), whole.normal(x, y));
            ASSERT_EQ(part.depth(x, y), whole.depth(x, y));
            ASSERT_EQ(part.variance_of_mean(x, y), whole.variance_of_mean(x, y));
            for (int bin = 0; bin < 3; ++bin) ASSERT_EQ(part.bin(x, y, bin), whole.bin(x, y, bin));
        }
}

/// The light paths of a crop are those of the whole picture.
TEST(SameBits, WithLightPathsToo) {
    const ThreadsGuard guard;
    Scene scene = scene_of_everything();
    scene.render.samples_per_pixel = 5;  // the last pass has one sample
    scene.render.caustics.light_paths = 2.0;
    set_thread_count(1);
    const FilmSums whole = render(scene, {}, "caustics");
    EXPECT_EQ(whole.light_paths(), 2u * 5 * 50 * 37);
    set_thread_count(5);
    EXPECT_EQ(render(scene, {}, "caustics").fingerprint(), whole.fingerprint());
    const PixelRect crop{13, 5, 39, 31};
    const FilmSums part = render(scene, crop, "caustics");
    EXPECT_EQ(part.light_paths(), whole.light_paths());
    double brought = 0.0;
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x) {
            ASSERT_EQ(part.xyz(x, y), whole.xyz(x, y)) << x << ", " << y;
            ASSERT_EQ(part.caustics(x, y), whole.caustics(x, y));
            ASSERT_EQ(part.variance_of_mean(x, y), whole.variance_of_mean(x, y));
            for (int bin = 0; bin < 3; ++bin) ASSERT_EQ(part.bin(x, y, bin), whole.bin(x, y, bin));
            brought += part.caustics(x, y)[1];
        }
    EXPECT_GT(brought, 0.0);
    scene.render.caustics.light_paths = 0.0;
    FilmSums without = render(scene, {}, "caustics");
    EXPECT_EQ(without.fingerprint(), render(scene).fingerprint()) << "path, bit for bit";
}

TEST(SameBits, Distributed1989TooInAllItsWays) {
    const ThreadsGuard guard;
    Scene scene = scene_of_everything();
    scene.rains.clear();
    scene.film.spectral_bins = 0;
    scene.render.samples_per_pixel = 4;
    scene.render.max_depth = 6;
    auto& settings = scene.render.distributed_1989;
    std::vector<std::uint64_t> seen;
    for (const RgbOrSpectral transport : {RgbOrSpectral::rgb, RgbOrSpectral::spectral}) {
        settings.transport = transport;
        for (const Jitter jitter : {Jitter::none, Jitter::both}) {
            settings.sampling.jitter = jitter;
            set_thread_count(1);
            const FilmSums whole = render(scene, {}, "distributed_1989");
            set_thread_count(5);
            EXPECT_EQ(render(scene, {}, "distributed_1989").fingerprint(), whole.fingerprint());
            const PixelRect crop{13, 5, 39, 31};
            const FilmSums part = render(scene, crop, "distributed_1989");
            for (int y = crop.y0; y < crop.y1; ++y)
                for (int x = crop.x0; x < crop.x1; ++x)
                    ASSERT_EQ(part.xyz(x, y), whole.xyz(x, y)) << x << ", " << y;
            for (const std::uint64_t other : seen) EXPECT_NE(whole.fingerprint(), other);
            seen.push_back(whole.fingerprint());
        }
    }
}

}  // namespace
}  // namespace dewbow
