// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/session.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

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
    double invalid_share = 0.0;

private:
    PixelSample sample(int x, int y, std::int64_t index) const {
        const SampleKey key(stream_key(scene_.render.seed, std::uint32_t(x), std::uint32_t(y)),
                            std::uint32_t(index));
        PixelSample result;
        result.wavelengths =
            sample_wavelengths(scene_.render.wavelengths, 4, key.one(0, Purpose::wavelength));
        for (std::uint32_t k = 0; k < 4; ++k) result.radiance[k] = key.one(k, Purpose::test);
        if (key.one(9, Purpose::test) < invalid_share) result.radiance[1] = -1.0;
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

// ---- resumed -----------------------------------------------------------------------------------

RenderState begun_state(const Scene& scene) {
    return RenderState(render_identity(scene, {}, estimators().front(), 0));
}

/// As a new process has it.
RenderState reloaded(const RenderState& state) {
    return state_from_bytes(state_bytes(state), "memory");
}

/// Renders about `units` units and is interrupted.
void render_some(const Scene& scene, RenderState& state, int units, SessionOptions options = {}) {
    std::atomic<bool> stop{false};
    std::atomic<int> left{units};
    Noise noise(scene);
    noise.on_unit = [&] {
        if (left-- <= 1) stop = true;
    };
    options.stop = &stop;
    run_session(noise, options, state);
}

TEST(Session, InterruptedAndResumedItEndsWithTheSameBits) {
    const ThreadsGuard guard;
    const Scene scene = small_scene();
    RenderState whole = begun_state(scene);
    const SessionResult undisturbed = run_session(Noise(scene), {}, whole);
    std::mt19937 engine(11);
    for (int repeat = 0; repeat < 20; ++repeat) {
        RenderState state = begun_state(scene);
        for (int i = 0; i < 3; ++i) {
            set_thread_count(1 + int(engine() % 4));
            render_some(scene, state, 1 + int(engine() % 15));
            state = reloaded(state);
        }
        set_thread_count(1 + int(engine() % 4));
        const SessionResult result = run_session(Noise(scene), {}, state);
        EXPECT_EQ(result.reason, StopReason::complete);
        EXPECT_EQ(result.film_hash, undisturbed.film_hash);
        EXPECT_EQ(result.samples, undisturbed.samples);
        EXPECT_EQ(state.plan, whole.plan);
    }
}

TEST(Session, AFinishedStateIsNotRenderedAgain) {
    const Scene scene = small_scene();
    RenderState state = begun_state(scene);
    const std::uint64_t hash = run_session(Noise(scene), {}, state).film_hash;
    Noise noise(scene);
    noise.on_unit = [] { FAIL() << "nothing is left to do"; };
    const SessionResult again = run_session(noise, {}, state);
    EXPECT_EQ(again.reason, StopReason::complete);
    EXPECT_EQ(again.film_hash, hash);
}

TEST(Session, ResumedItStopsAtTheSameNoise) {
    const ThreadsGuard guard;
    const Scene scene = small_scene(1 << 20);
    SessionOptions options;
    options.noise_target = 0.06;
    RenderState whole = begun_state(scene);
    const SessionResult undisturbed = run_session(Noise(scene), options, whole);
    ASSERT_EQ(undisturbed.reason, StopReason::noise);
    const int units = int(undisturbed.finished_units), tiles = int(whole.plan.tiles());
    ASSERT_GT(units, 4 * tiles);
    // At the pass where it stops, before and behind it, and between.
    set_thread_count(1);
    for (const int first : {1, tiles, units - tiles - 1, units - tiles, units - 1, units}) {
        RenderState state = begun_state(scene);
        SessionOptions all_the_way;  // as if killed before it looked at the noise
        render_some(scene, state, first, all_the_way);
        EXPECT_EQ(int(state.plan.finished_units()), first);
        state = reloaded(state);
        const SessionResult result = run_session(Noise(scene), options, state);
        EXPECT_EQ(result.reason, StopReason::noise) << first;
        EXPECT_EQ(result.film_hash, undisturbed.film_hash) << first;
    }
}

/// A checkpoint may hold units of later passes than one that it lacks.
TEST(Session, WhereAnEarlierRunWentOnTheNoiseIsNotAskedAgain) {
    constexpr std::size_t kLast = 10;
    RenderState fixed = begun_state(small_scene(kSamplesPerPass * (kLast + 1)));
    run_session(Noise(small_scene()), {}, fixed);
    const Scene scene = small_scene(1 << 20);
    SessionOptions options;
    // Reached with the last pass, and with all but a tile of it.
    options.noise_target = 1.01 * relative_noise(fixed.film);

    RenderState state = begun_state(scene);
    for (std::size_t pass = 0; pass <= kLast; ++pass)
        for (std::size_t tile = 0; tile < state.plan.tiles(); ++tile) {
            if ((pass == 0 && tile == 5) || (pass == kLast && tile == 2)) continue;
            Noise(scene).render(state.plan.unit(pass, tile), state.film);
            state.plan.set_finished(pass, tile);
        }
    ASSERT_LT(relative_noise(state.film), *options.noise_target);
    const SessionResult result = run_session(Noise(scene), options, state);
    EXPECT_EQ(result.reason, StopReason::noise);
    EXPECT_EQ(result.film_hash, fixed.film.fingerprint());
}

TEST(Session, ATimeLimitCountsEarlierRuns) {
    const Scene scene = small_scene(1 << 20);
    SessionOptions options;
    options.time_limit = std::chrono::duration<double>(50.0);
    RenderState state = begun_state(scene);
    render_some(scene, state, 7);
    state.seconds = 60.0;
    const SessionResult result = run_session(Noise(scene), options, state);
    EXPECT_EQ(result.reason, StopReason::time);
    EXPECT_EQ(result.finished_units, state.plan.tiles());
    EXPECT_GE(result.seconds, 60.0);
}

TEST(Session, RendersTheUnitsThatAreSelected) {
    const Scene scene = small_scene();
    RenderState whole = begun_state(scene), sum = begun_state(scene);
    run_session(Noise(scene), {}, whole);
    for (const std::size_t k : {2u, 0u, 1u}) {
        RenderState slice = begun_state(scene);
        SessionOptions options;
        options.selects = [&](std::size_t pass, std::size_t tile) {
            return (pass * slice.plan.tiles() + tile) % 3 == k;
        };
        EXPECT_EQ(run_session(Noise(scene), options, slice).reason, StopReason::complete);
        EXPECT_EQ(slice.plan.finished_units(), 15u);  // of 45
        add_state(sum, "the sum", slice, "a slice");
    }
    EXPECT_EQ(sum.film.fingerprint(), whole.film.fingerprint());
}

// ---- kept while it goes on ---------------------------------------------------------------------

TEST(Session, EveryCheckpointIsARenderThatCanBeResumed) {
    const ThreadsGuard guard;
    set_thread_count(4);
    const Scene scene = small_scene(160);
    Noise noise(scene);
    noise.invalid_share = 0.01;
    constexpr std::size_t kStates = 10;
    std::vector<std::string> kept;
    SessionOptions options;
    options.checkpoints =
        Checkpoints{std::chrono::duration<double>(1e-4), [&](const StateOfTheMoment& write) {
                        if (kept.size() == kStates) return;
                        std::string bytes;
                        int pieces = 0;
                        write([&](std::string_view piece) {
                            bytes += piece;
                            // Time for workers to go on between two tiles.
                            if (++pieces % 4 == 0)
                                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                        });
                        kept.push_back(std::move(bytes));
                    }};
    RenderState state = begun_state(scene);
    const SessionResult undisturbed = run_session(noise, options, state);
    ASSERT_GT(undisturbed.invalid_samples, 1000);
    ASSERT_GT(kept.size(), 3u);
    std::size_t apart = 0;
    for (const std::string& bytes : kept) {
        RenderState resumed = state_from_bytes(bytes, "kept");
        for (std::size_t tile = 0; tile < resumed.plan.tiles(); ++tile) {
            std::size_t units = 0;
            for (std::size_t pass = 0; pass < resumed.plan.passes(); ++pass)
                units += resumed.plan.finished(pass, tile);
            apart += units != resumed.plan.first_open_pass();
        }
        // The rest added to it makes the whole: its film holds exactly the units of its plan.
        EXPECT_EQ(run_session(noise, {}, resumed).film_hash, undisturbed.film_hash);
    }
    EXPECT_GT(apart, 0u) << "no checkpoint was made while a pass was under way";
}

TEST(Session, ACheckpointThatFailsDoesNotEndTheRender) {
    const Scene scene = small_scene(160);
    std::atomic<int> tries{0};
    SessionOptions options;
    options.checkpoints =
        Checkpoints{std::chrono::duration<double>(1e-4), [&](const StateOfTheMoment& write) {
                        ++tries;
                        try {
                            write([](std::string_view) { throw InputError("the disk is full"); });
                        } catch (const InputError&) {
                        }
                    }};
    RenderState state = begun_state(scene);
    EXPECT_EQ(run_session(Noise(scene), options, state).reason, StopReason::complete);
    EXPECT_GT(tries, 1);
}

/// A slow disk must not keep a finished render waiting.
TEST(Session, AStateThatIsBeingWrittenIsGivenUpAtTheEnd) {
    const Scene scene = small_scene(8);
    std::atomic<bool> begun{false}, whole{false};
    SessionOptions options;
    options.checkpoints =
        Checkpoints{std::chrono::duration<double>(1e-6), [&](const StateOfTheMoment& write) {
                        write([&](std::string_view) {
                            begun = true;
                            std::this_thread::sleep_for(std::chrono::milliseconds(100));
                        });
                        whole = true;
                    }};
    Noise noise(scene);
    noise.on_unit = [&] {
        while (!begun) std::this_thread::yield();
    };
    RenderState state = begun_state(scene);
    EXPECT_EQ(run_session(noise, options, state).reason, StopReason::complete);
    EXPECT_FALSE(whole);
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
