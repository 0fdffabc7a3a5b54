// SPDX-License-Identifier: Apache-2.0
#pragma once

// One render from start to end: units of work, which of them are finished, when to stop, and what
// there is to tell about it.

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>

#include "dewbow/base/progress.h"
#include "dewbow/render/estimator.h"
#include "dewbow/render/state.h"

namespace dewbow {

/// From fewer samples a pixel's noise cannot be told.
inline constexpr int kLeastSamplesForNoise = 16;

class Team;

/// Writes the state of the moment to a sink.
using StateOfTheMoment = std::function<void(const ByteSink&)>;

/// States that are kept while a render goes on.
struct Checkpoints {
    /// From the start, and from the end of one to the start of the next.
    std::chrono::duration<double> interval{60.0};
    /// Called on a thread of its own; workers go on. It must let pass what it does not know: a
    /// render that ends gives up the state that is being written by an exception from the sink.
    std::function<void(const StateOfTheMoment&)> keep;
};

struct SessionOptions {
    std::optional<PixelRect> crop;
    /// Stop at the end of the pass in which this much time has gone by.
    std::optional<std::chrono::duration<double>> time_limit;
    /// Stop at the end of the pass in which the relative noise of the picture falls below this (see
    /// relative_noise), but not before kLeastSamplesForNoise samples a pixel.
    std::optional<double> noise_target;
    ProgressStyle progress = ProgressStyle::none;
    std::string title;
    /// Set from a signal handler or another thread: units under way are finished, then the render
    /// ends.
    const std::atomic<bool>* stop = nullptr;
    /// Which units are this run's; empty: all. With it there is neither time_limit nor
    /// noise_target.
    std::function<bool(std::size_t pass, std::size_t number)> selects;
    std::optional<Checkpoints> checkpoints;
    /// Other ranks that render too; they have been told to leave when run_session returns.
    Team* team = nullptr;
};

enum class StopReason { complete, time, noise, interrupted };

/// "complete", "time", "noise", "interrupted"
std::string to_string(StopReason reason);

struct SessionResult {
    StopReason reason = StopReason::complete;
    PixelRect crop;
    double samples_per_pixel = 0.0;  ///< mean over the crop
    /// Of the state, which may hold more or fewer than this run's.
    std::size_t finished_units = 0, planned_units = 0;
    std::int64_t samples = 0;          ///< of all pixels together, invalid ones included
    std::int64_t invalid_samples = 0;  ///< and splats
    std::uint64_t light_paths = 0;     ///< that are finished
    std::uint64_t film_hash = 0;       ///< FilmSums::fingerprint
    double seconds = 0.0;              ///< those of earlier runs included
};

/// Goes on with `state` until all of its units, or those that `options` select, are finished, or
/// there is a reason to stop. It ends with the same bits as if it had never been interrupted, and
/// stops at the same noise; a time limit counts the seconds of earlier runs.
SessionResult run_session(const Estimator& estimator, const SessionOptions& options,
                          RenderState& state);

/// What a render of `scene` is: its bits depend on nothing else. Throws InputError as make_film.
/// @param scene_hash  of all that `scene` was made from.  @param light_paths  of the estimator.
RenderIdentity render_identity(const Scene& scene, const SessionOptions& options,
                               const EstimatorRow& estimator, std::uint64_t scene_hash,
                               double light_paths = 0.0);

/// From the beginning to the end, and no state to keep: renders `scene.render.samples_per_pixel`
/// samples of every pixel of the film's crop into `film`, which comes from make_film with the same
/// options.
SessionResult run_session(const Scene& scene, const Estimator& estimator,
                          const SessionOptions& options, FilmSums& film);

/// Film for `scene`: its size, bins, and quanta by its white luminance. Throws InputError if the
/// crop does not lie in the picture.
FilmSums make_film(const Scene& scene, const SessionOptions& options);

/// Root mean square over pixels of (standard error of Y) / (Y + 1 % of the mean Y). 0 of a black
/// picture.
double relative_noise(const FilmSums& film);

/// Everything that bits may depend on: version, compiler, instruction set in use, Embree's version
/// and pinned instruction set, C library.
std::string fingerprint();

}  // namespace dewbow
