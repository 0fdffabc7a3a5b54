// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/session.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"

namespace dewbow {
namespace {

/// Noise by the rules of a true estimator: a function of seed, pixel and index.
class Noise : public Estimator {
public:
    explicit Noise(const Scene& scene) : scene_(scene) {}

    void render(const Unit& unit, FilmSums& film) const override {
        if (on_unit) on_unit();
        for (int y = unit.tile.y0; y < unit.tile.y1; ++y)
            for (int x = unit.tile.x0; x < unit.tile.x1; ++x)
                for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i)
                    film.add(x, y, sample(x, y, i), i);
    }

    std::function<void()> on_unit;

private:
    PixelSample sample(int x, int y, std::int64_t index) const {
        const SampleKey key(stream_key(scene_.render.seed, std::uint32_t(x), std::uint32_t(y)),
                            std::uint32_t(index));
        PixelSample result;
        result.wavelengths =
            sample_wavelengths(scene_.render.wavelengths, 4, key.one(0, Purpose::wavelength));
        for (std::uint32_t k = 0; k < 4; ++k) result.radiance[k] = key.one(k, Purpose::test);
        return result;
    }
    const Scene& scene_;
};

Scene small_scene(int samples_per_pixel = 10) {
    Scene scene = make_empty_scene();
    scene.film.width = 70;
    scene.film.height = 40;
    scene.film.spectral_bins = 2;
    scene.render.samples_per_pixel = samples_per_pixel;
    return scene;
}

/// Leaves parallel loops as they were.
struct ThreadsGuard {
    ~ThreadsGuard() { set_thread_count(0); }
};

TEST(Session, TheFilmDoesNotDependOnThreads) {
    const ThreadsGuard guard;
    const Scene scene = small_scene();
    const Noise noise(scene);
    std::set<std::uint64_t> hashes;
    for (const int threads : {1, 2, 5}) {
        set_thread_count(threads);
        FilmSums film = make_film(scene, {});
        const SessionResult result = run_session(scene, noise, {}, film);
        EXPECT_EQ(result.reason, StopReason::complete);
        EXPECT_EQ(result.finished_units, result.planned_units);
        EXPECT_EQ(result.samples_per_pixel, 10.0);
        EXPECT_EQ(result.samples, 70 * 40 * 10);
        EXPECT_EQ(result.film_hash, film.fingerprint());
        hashes.insert(film.fingerprint());
    }
    EXPECT_EQ(hashes.size(), 1u);
}

TEST(Session, AnInterruptedFilmHoldsFinishedUnitsOnly) {
    std::mt19937 engine(4);
    for (int repeat = 0; repeat < 10; ++repeat) {
        const Scene scene = small_scene();
        Noise noise(scene);
        std::atomic<bool> stop{false};
        std::atomic<int> units_left{int(engine() % 45)};
        noise.on_unit = [&] {
            if (units_left-- <= 0) stop = true;
        };
        SessionOptions options;
        options.stop = &stop;
        FilmSums film = make_film(scene, options);
        const SessionResult result = run_session(scene, noise, options, film);
        const bool all = result.finished_units == result.planned_units;
        EXPECT_EQ(result.reason, all ? StopReason::complete : StopReason::interrupted);

        std::int64_t samples = 0;
        for (int y = 0; y < film.height(); ++y)
            for (int x = 0; x < film.width(); ++x) {
                const std::uint32_t count = film.samples(x, y);
                EXPECT_TRUE(count % kSamplesPerPass == 0 || count == 10u) << count;
                // A tile is whole.
                EXPECT_EQ(count,
                          film.samples(x / kTileSide * kTileSide, y / kTileSide * kTileSide));
                samples += count;
            }
        EXPECT_EQ(samples, result.samples);
        EXPECT_DOUBLE_EQ(result.samples_per_pixel, double(samples) / (70 * 40));
    }
}

TEST(Session, StoppedBeforeItBeganItHoldsNothing) {
    const Scene scene = small_scene();
    const std::atomic<bool> stop{true};
    SessionOptions options;
    options.stop = &stop;
    FilmSums film = make_film(scene, options);
    const SessionResult result = run_session(scene, Noise(scene), options, film);
    EXPECT_EQ(result.reason, StopReason::interrupted);
    EXPECT_EQ(result.finished_units, 0u);
}

TEST(Session, ACropIsAPartOfTheWholePicture) {
    const Scene scene = small_scene();
    const Noise noise(scene);
    FilmSums whole = make_film(scene, {});
    run_session(scene, noise, {}, whole);
    for (const PixelRect crop : {PixelRect{13, 9, 47, 31}, PixelRect{69, 39, 70, 40}}) {
        SessionOptions options;
        options.crop = crop;
        FilmSums part = make_film(scene, options);
        const SessionResult result = run_session(scene, noise, options, part);
        EXPECT_EQ(result.crop, crop);
        EXPECT_EQ(result.samples_per_pixel, 10.0);
        for (int y = crop.y0; y < crop.y1; ++y)
            for (int x = crop.x0; x < crop.x1; ++x) {
                ASSERT_EQ(whole.xyz(x, y), part.xyz(x, y));
                ASSERT_EQ(whole.bin(x, y, 0), part.bin(x, y, 0));
            }
    }
}

TEST(Session, ACropOutsideThePictureIsRefused) {
    const Scene scene = small_scene();
    for (const PixelRect crop : {PixelRect{60, 0, 71, 10}, PixelRect{-1, 0, 5, 5},
                                 PixelRect{5, 5, 5, 9}, PixelRect{0, 30, 10, 41}}) {
        SessionOptions options;
        options.crop = crop;
        EXPECT_THROW(make_film(scene, options), InputError);
    }
}

TEST(Session, TimeStopsAtTheEndOfAPass) {
    const Scene scene = small_scene(1 << 24);
    SessionOptions options;
    options.time_limit = std::chrono::duration<double>(0.05);
    FilmSums film = make_film(scene, options);
    const SessionResult result = run_session(scene, Noise(scene), options, film);
    EXPECT_EQ(result.reason, StopReason::time);
    EXPECT_GE(result.seconds, 0.05);
    EXPECT_EQ(result.finished_units % UnitPlan({0, 0, 70, 40}, 4).tiles(), 0u);
    EXPECT_EQ(film.samples(0, 0), film.samples(69, 39));
}

TEST(Session, NoiseStopsAtTheEndOfAPass) {
    const Scene scene = small_scene(1 << 20);
    SessionOptions options;
    options.noise_target = 0.05;
    FilmSums film = make_film(scene, options);
    const SessionResult result = run_session(scene, Noise(scene), options, film);
    EXPECT_EQ(result.reason, StopReason::noise);
    EXPECT_LE(relative_noise(film), 0.05);
    EXPECT_GE(film.samples(0, 0), std::uint32_t(kLeastSamplesForNoise));
    EXPECT_EQ(film.samples(0, 0), film.samples(69, 39));
    // It was above one pass earlier.
    Scene less = scene;
    less.render.samples_per_pixel = int(film.samples(0, 0)) - kSamplesPerPass;
    FilmSums before = make_film(less, {});
    run_session(less, Noise(less), {}, before);
    EXPECT_GT(relative_noise(before), 0.05);
}

TEST(Session, RelativeNoiseFallsWithTheRootOfTheSamples) {
    const auto noise_at = [](int samples) {
        const Scene scene = small_scene(samples);
        FilmSums film = make_film(scene, {});
        run_session(scene, Noise(scene), {}, film);
        return relative_noise(film);
    };
    // The estimate from 2800 pixels scatters by about 1 %.
    EXPECT_NEAR(noise_at(64) / noise_at(256), 2.0, 0.1);
    EXPECT_EQ(relative_noise(make_film(small_scene(), {})), 0.0);
}

TEST(Session, TheFingerprintNamesWhatBitsDependOn) {
    const std::string text = fingerprint();
    for (const char* part : {"dewbow ", "Embree", "glibc"})
        EXPECT_NE(text.find(part), std::string::npos) << text;
}

}  // namespace
}  // namespace dewbow
