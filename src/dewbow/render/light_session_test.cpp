// SPDX-License-Identifier: Apache-2.0
// Renders with light paths: whatever way the units take, the film is that of one thread which adds
// all samples and all paths in their order.

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

#include "dewbow/base/parallel.h"
#include "dewbow/render/session.h"
#include "dewbow/render/spark_estimator.h"

namespace dewbow {
namespace {

constexpr int kWidth = 70, kHeight = 40, kSamples = 10;
/// 33600 and, in the last pass, 16800 paths a pass: 5 light units beside 15 tiles.
constexpr double kLightPaths = 3.0;
constexpr FilmLayout kLayout{kWidth, kHeight, {0, 0, kWidth, kHeight}, 2, -3};

/// Leaves parallel loops as they were.
struct ThreadsGuard {
    ~ThreadsGuard() { set_thread_count(0); }
};

SparkEstimator sparks() {
    SparkEstimator estimator(kWidth, kHeight, kLightPaths);
    estimator.invalid_share = 0.001;
    return estimator;
}

RenderIdentity identity(const FilmLayout& layout = kLayout, std::int64_t samples = kSamples) {
    RenderIdentity identity;
    identity.estimator = "sparks";
    identity.samples_per_pixel = samples;
    identity.film = layout;
    identity.light_paths = kLightPaths;
    return identity;
}

std::uint64_t undivided_hash(std::int64_t samples = kSamples) {
    return undivided_film(sparks(), kLayout, samples, kSamplesPerPass).fingerprint();
}

/// As a new process has it.
RenderState reloaded(const RenderState& state) {
    return state_from_bytes(state_bytes(state), "memory");
}

/// Renders about `units` units and is interrupted.
void render_some(RenderState& state, int units) {
    std::atomic<bool> stop{false};
    std::atomic<int> left{units};
    SparkEstimator estimator = sparks();
    estimator.on_unit = [&] {
        if (left-- <= 1) stop = true;
    };
    SessionOptions options;
    options.stop = &stop;
    run_session(estimator, options, state);
}

TEST(LightSession, TheFilmDoesNotDependOnThreads) {
    const ThreadsGuard guard;
    const std::uint64_t expected = undivided_hash();
    for (const int threads : {1, 2, 5}) {
        set_thread_count(threads);
        RenderState state(identity());
        const SessionResult result = run_session(sparks(), {}, state);
        EXPECT_EQ(result.film_hash, expected) << threads;
        EXPECT_EQ(result.planned_units, 3u * (15 + 5));
        EXPECT_EQ(result.finished_units, result.planned_units);
        EXPECT_EQ(result.light_paths, std::uint64_t(kWidth * kHeight * kSamples * 3));
        EXPECT_GT(state.film.invalid().splats, 0);
        EXPECT_EQ(result.invalid_samples, state.film.invalid().count + state.film.invalid().splats);
    }
}

TEST(LightSession, InterruptedAndResumedItEndsWithTheSameBits) {
    const ThreadsGuard guard;
    const std::uint64_t expected = undivided_hash();
    std::mt19937 engine(12);
    for (int repeat = 0; repeat < 8; ++repeat) {
        RenderState state(identity());
        for (int i = 0; i < 3; ++i) {
            set_thread_count(1 + int(engine() % 4));
            render_some(state, 1 + int(engine() % 18));
            EXPECT_EQ(state.film.light_paths(), state.plan.finished_light_paths());
            state = reloaded(state);
        }
        EXPECT_EQ(run_session(sparks(), {}, state).film_hash, expected);
    }
}

TEST(LightSession, SlicesAddUpToTheWhole) {
    RenderState sum(identity());
    for (const std::size_t k : {2u, 0u, 1u}) {
        RenderState slice(identity());
        SessionOptions options;
        options.selects = [&](std::size_t pass, std::size_t number) {
            return (pass * slice.plan.units_per_pass() + number) % 3 == k;
        };
        EXPECT_EQ(run_session(sparks(), options, slice).reason, StopReason::complete);
        EXPECT_EQ(slice.plan.finished_units(), 20u);  // of 60
        EXPECT_GT(slice.film.light_paths(), 0u);
        add_state(sum, "the sum", reloaded(slice), "a slice");
    }
    EXPECT_EQ(sum.film.fingerprint(), undivided_hash());
    EXPECT_EQ(sum.film.light_paths(), sum.plan.finished_light_paths());
}

TEST(LightSession, ACropIsAPartOfTheWholePicture) {
    RenderState whole(identity());
    run_session(sparks(), {}, whole);
    for (const PixelRect crop : {PixelRect{13, 9, 47, 31}, PixelRect{69, 39, 70, 40}}) {
        FilmLayout layout = kLayout;
        layout.crop = crop;
        RenderState part(identity(layout));
        run_session(sparks(), {}, part);
        EXPECT_EQ(part.film.light_paths(), whole.film.light_paths());
        for (int y = crop.y0; y < crop.y1; ++y)
            for (int x = crop.x0; x < crop.x1; ++x) {
                ASSERT_EQ(whole.film.xyz(x, y), part.film.xyz(x, y));
                ASSERT_EQ(whole.film.caustics(x, y), part.film.caustics(x, y));
                ASSERT_EQ(whole.film.bin(x, y, 1), part.film.bin(x, y, 1));
                ASSERT_EQ(whole.film.variance_of_mean(x, y), part.film.variance_of_mean(x, y));
            }
    }
}

/// An interrupted picture is as bright as a whole one: light is shared by the paths that finished.
TEST(LightSession, AnInterruptedPictureIsAsBrightAsAWholeOne) {
    const auto mean = [](const FilmSums& film) {
        double sum = 0.0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) sum += film.caustics(x, y)[1];
        return sum / (kWidth * kHeight);
    };
    const ThreadsGuard guard;
    set_thread_count(1);
    RenderState whole(identity()), part(identity());
    run_session(sparks(), {}, whole);
    render_some(part, 18);  // 15 tiles and some light units of the first pass
    ASSERT_GT(part.film.light_paths(), 0u);
    ASSERT_LT(part.film.light_paths(), whole.film.light_paths() / 2);
    // 8000 paths and more, whose Y has a standard deviation of about its half: 1 in 200, 5 sigma.
    EXPECT_NEAR(mean(part.film) / mean(whole.film), 1.0, 0.03);
}

TEST(LightSession, EveryCheckpointIsARenderThatCanBeResumed) {
    const ThreadsGuard guard;
    set_thread_count(4);
    constexpr std::int64_t kMany = 40;
    constexpr std::size_t kStates = 4;
    std::vector<std::string> kept;
    SessionOptions options;
    options.checkpoints =
        Checkpoints{std::chrono::duration<double>(1e-4), [&](const StateOfTheMoment& write) {
                        if (kept.size() == kStates) return;
                        std::string bytes;
                        write([&](std::string_view piece) {
                            bytes += piece;
                            // A slow disk: units are handed in while a state is written.
                            std::this_thread::sleep_for(std::chrono::microseconds(50));
                        });
                        kept.push_back(std::move(bytes));
                    }};
    RenderState state(identity(kLayout, kMany));
    const std::uint64_t expected = undivided_hash(kMany);
    EXPECT_EQ(run_session(sparks(), options, state).film_hash, expected);
    ASSERT_GE(kept.size(), 2u);
    bool any_begun = false;
    for (const std::string& bytes : kept) {
        RenderState resumed = state_from_bytes(bytes, "memory");
        const std::uint64_t paths = resumed.film.light_paths();
        any_begun |= paths > 0 && paths < state.film.light_paths();
        EXPECT_EQ(run_session(sparks(), {}, resumed).film_hash, expected);
    }
    EXPECT_TRUE(any_begun) << "no state was of a render under way";
}

TEST(LightSession, TheNoiseIsThatOfSamplesAndSplats) {
    // The oracle: the variance among films of other passes. Each render of one pass is a sample of
    // a pixel's Y; its film estimates the variance of that.
    constexpr int kPasses = 400;
    const FilmLayout layout{2, 2, {0, 0, 2, 2}, 0, 0};
    const SparkEstimator estimator(2, 2, 16.0);
    double sum = 0.0, squares = 0.0, estimated = 0.0;
    for (std::uint64_t pass = 0; pass < kPasses; ++pass) {
        // Paths of different passes are independent; those of one are stratified, and have less.
        SplatList splats(layout);
        for (std::uint64_t path = 0; path < 256; ++path)
            estimator.trace_light({pass * 256 + path, 0, 1}, splats);
        FilmSums film(layout);
        film.add_splats(splats, 256);
        const double y = film.xyz(1, 0)[1];
        sum += y, squares += y * y, estimated += film.variance_of_mean(1, 0);
    }
    const double mean = sum / kPasses;
    const double variance = (squares / kPasses - mean * mean) * kPasses / (kPasses - 1);
    // The variance of 400 numbers is known to 7 %; two sparks of a path may share a pixel.
    EXPECT_NEAR(estimated / kPasses / variance, 1.0, 0.25);
}

TEST(LightSession, ResumedItStopsAtTheSameNoise) {
    const ThreadsGuard guard;
    SessionOptions options;
    options.noise_target = 0.1;
    RenderState whole(identity(kLayout, 1 << 16));
    const SessionResult undisturbed = run_session(sparks(), options, whole);
    ASSERT_EQ(undisturbed.reason, StopReason::noise);
    const int units = int(undisturbed.finished_units), a_pass = int(whole.plan.units_per_pass());
    set_thread_count(1);
    for (const int first : {1, a_pass - 2, units - a_pass, units - 1, units}) {
        RenderState state(identity(kLayout, 1 << 16));
        render_some(state, first);
        state = reloaded(state);
        EXPECT_EQ(run_session(sparks(), options, state).film_hash, undisturbed.film_hash) << first;
    }
}

}  // namespace
}  // namespace dewbow
