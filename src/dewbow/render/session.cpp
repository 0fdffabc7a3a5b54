// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/session.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/accelerator.h"
#include "dewbow/render/farm/team.h"
#include "dewbow/render/live_state.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

using Clock = std::chrono::steady_clock;

/// Keeps a state every now and then, on a thread of its own, while it lives.
class CheckpointKeeper {
public:
    CheckpointKeeper(const SessionOptions& options, LiveState& live,
                     std::function<double()> seconds)
        : live_(live), seconds_(std::move(seconds)) {
        if (options.checkpoints)
            thread_ = std::jthread([this, &checkpoints = *options.checkpoints](
                                       std::stop_token stop) { loop(checkpoints, stop); });
    }

private:
    /// The render has ended: what is being written is not needed any more.
    struct GivenUp {};

    void loop(const Checkpoints& checkpoints, const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any end;
        std::unique_lock lock(mutex);
        for (;;) {
            end.wait_for(lock, stop, checkpoints.interval, [&] { return stop.stop_requested(); });
            if (stop.stop_requested()) return;
            try {
                checkpoints.keep([&](const ByteSink& sink) { write(sink, stop); });
            } catch (const GivenUp&) {
                return;
            }
        }
    }

    void write(const ByteSink& sink, const std::stop_token& stop) {
        live_.write(
            [&](std::string_view bytes) {
                if (stop.stop_requested()) throw GivenUp();
                sink(bytes);
            },
            seconds_());
    }

    LiveState& live_;
    std::function<double()> seconds_;
    std::jthread thread_;  // last: it ends before the others do
};

/// Steps of a progress display that follows the clock or the noise.
constexpr std::uint64_t kShareSteps = 10000;

/// One call of run_session.
class Run {
public:
    Run(const Estimator& estimator, const SessionOptions& options, RenderState& state)
        : estimator_(estimator),
          options_(options),
          state_(state),
          live_(state),
          seconds_before_(state.seconds),
          progress_(options.title, has_goal() ? kShareSteps : selected_units(), options.progress) {
        DEWBOW_CHECK(!options.selects || !has_goal(),
                     "a part of the units has no noise of its own");
        DEWBOW_CHECK(state.identity.light_paths == estimator.light_paths(),
                     "the units are those of the estimator");
    }

    SessionResult run() {
        if (!has_goal() && !options_.selects) progress_.skip(state_.plan.finished_units());
        SessionResult result;
        {
            const CheckpointKeeper keeper(options_, live_, [this] { return seconds(); });
            result.reason = render_passes();
            if (options_.team) options_.team->part();
        }
        if (has_goal()) advance_by_share();
        progress_.finish();
        state_.seconds = seconds();
        const FilmSums& film = state_.film;
        result.crop = film.crop();
        result.samples = state_.plan.finished_samples();
        result.samples_per_pixel =
            static_cast<double>(result.samples) / static_cast<double>(film.crop().area());
        result.finished_units = state_.plan.finished_units();
        result.planned_units = state_.plan.units();
        result.invalid_samples = film.invalid_samples();
        result.light_paths = film.light_paths();
        result.film_hash = film.fingerprint();
        result.seconds = state_.seconds;
        return result;
    }

private:
    const UnitPlan& plan() const { return state_.plan; }

    /// Starts with the last finished pass: whether to stop there may not have been asked yet.
    StopReason render_passes() {
        if (options_.team) return render_with_team(*options_.team);
        const std::size_t open = plan().first_open_pass();
        for (std::size_t pass = open > 0 ? open - 1 : 0; pass < plan().passes(); ++pass) {
            parallel_for(plan().units_per_pass(),
                         [&](std::size_t number) { render_unit(pass, number); });
            if (gave_up_) return StopReason::interrupted;
            if (pass + 1 == plan().passes()) break;
            if (const auto reason = reason_to_stop_after(pass)) return *reason;
        }
        return StopReason::complete;
    }

    StopReason render_with_team(Team& team) {
        DEWBOW_CHECK(!options_.selects, "a team renders all units");
        std::size_t end =
            has_goal() ? std::max<std::size_t>(plan().first_open_pass(), 1) : plan().passes();
        for (;; ++end) {
            team.render(
                estimator_, state_, live_, end, [this](std::size_t units) { advance(units); },
                [this] { return stopped(); });
            if (plan().first_open_pass() < end) return StopReason::interrupted;
            if (end == plan().passes()) return StopReason::complete;
            if (const auto reason = reason_to_stop_after(end - 1)) return *reason;
        }
    }

    std::optional<StopReason> reason_to_stop_after(std::size_t pass) {
        if (stopped()) return StopReason::interrupted;
        // An earlier run has gone on to later passes: it was asked, and the answer was no.
        if (plan().finished_units() > (pass + 1) * plan().units_per_pass()) return std::nullopt;
        if (options_.time_limit && seconds() >= options_.time_limit->count())
            return StopReason::time;
        if (is_clean_enough(plan().unit(pass, 0).end_sample)) return StopReason::noise;
        return std::nullopt;
    }

    void render_unit(std::size_t pass, std::size_t number) {
        if (options_.selects && !options_.selects(pass, number)) return;
        if (live_.finished(pass, number)) return;
        if (stopped()) {
            gave_up_ = true;
            return;
        }
        if (plan().is_light(number))
            trace_light(pass, number);
        else
            render_tile(pass, number);
        advance(1);
    }

    void render_tile(std::size_t pass, std::size_t number) {
        const Unit unit = plan().unit(pass, number);
        FilmLayout layout = state_.film.layout();
        layout.crop = unit.tile;
        FilmSums part(layout);
        estimator_.render(unit, part);
        live_.hand_in(pass, pass + 1, number, part);
    }

    void trace_light(std::size_t pass, std::size_t number) {
        SplatList splats(state_.film.layout());
        estimator_.trace_light(plan().light_unit(pass, number), splats);
        live_.hand_in(pass, pass + 1, number, splats);
    }

    void advance(std::size_t units) {
        if (has_goal())
            advance_by_share();
        else
            progress_.advance(units);
    }

    bool has_goal() const { return options_.time_limit || options_.noise_target; }

    std::size_t selected_units() const {
        if (!options_.selects) return plan().units();
        std::size_t units = 0;
        for (std::size_t pass = 0; pass < plan().passes(); ++pass)
            for (std::size_t number = 0; number < plan().units_per_pass(); ++number)
                units += options_.selects(pass, number) && !plan().finished(pass, number);
        return units;
    }

    /// The share that is done is that of the time, of the way to the noise or of the units,
    /// whichever is largest. For the display only.
    void advance_by_share() {
        double share =
            static_cast<double>(live_.finished_units()) / static_cast<double>(plan().units());
        if (options_.time_limit) share = std::max(share, seconds() / options_.time_limit->count());
        share = std::min(1.0, std::max(share, noise_share_.load()));
        const auto steps = static_cast<std::uint64_t>(kShareSteps * share);
        std::uint64_t shown = shown_steps_.load();
        while (steps > shown && !shown_steps_.compare_exchange_weak(shown, steps)) continue;
        if (steps > shown) progress_.advance(steps - shown);
    }

    bool stopped() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }

    bool is_clean_enough(std::int64_t samples_per_pixel) {
        if (!options_.noise_target) return false;
        double noise = 0.0;
        live_.read([&](const FilmSums& film) { noise = relative_noise(film); });
        // Noise falls with the root of the samples.
        const double ratio = *options_.noise_target / noise;
        noise_share_ = noise > 0.0 ? ratio * ratio : 1.0;
        return samples_per_pixel >= kLeastSamplesForNoise && noise <= *options_.noise_target;
    }

    double seconds() const {
        return seconds_before_ + std::chrono::duration<double>(Clock::now() - start_).count();
    }

    const Estimator& estimator_;
    const SessionOptions& options_;
    RenderState& state_;
    LiveState live_;
    const double seconds_before_;
    Progress progress_;
    std::atomic<bool> gave_up_{false};  // units are left because of a stop
    std::atomic<std::uint64_t> shown_steps_{0};
    std::atomic<double> noise_share_{0.0};
    const Clock::time_point start_ = Clock::now();
};

PixelRect crop_of(const Film& film, const SessionOptions& options) {
    const PixelRect crop = options.crop.value_or(PixelRect{0, 0, film.width, film.height});
    const bool inside = crop.x0 >= 0 && crop.y0 >= 0 && crop.x0 < crop.x1 && crop.y0 < crop.y1 &&
                        crop.x1 <= film.width && crop.y1 <= film.height;
    if (!inside)
        throw InputError("the crop " + std::to_string(crop.x0) + "," + std::to_string(crop.y0) +
                         "," + std::to_string(crop.width()) + "x" + std::to_string(crop.height()) +
                         " does not lie in the picture of " + std::to_string(film.width) + "x" +
                         std::to_string(film.height) + " pixels");
    return crop;
}

FilmLayout film_layout(const Scene& scene, const SessionOptions& options) {
    const Film& film = scene.film;
    const double white_radiance = film.white_luminance / (kLuminousEfficacy * cie_y_integral());
    return {film.width, film.height, crop_of(film, options), film.spectral_bins,
            reference_exponent(white_radiance)};
}

/// What the C library's mathematics and Embree choose their code by.
std::string processor_features() {
#if defined(__x86_64__)
    std::string features = "x86-64";
    if (__builtin_cpu_supports("avx")) features += " avx";
    if (__builtin_cpu_supports("avx2")) features += " avx2";
    if (__builtin_cpu_supports("fma")) features += " fma";
    if (__builtin_cpu_supports("avx512f")) features += " avx512f";
    return features;
#elif defined(__aarch64__)
    return "aarch64";
#else
    return "unknown processor";
#endif
}

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "g++ " __VERSION__;
#endif
}

}  // namespace

std::string to_string(StopReason reason) {
    switch (reason) {
        case StopReason::complete:
            return "complete";
        case StopReason::time:
            return "time";
        case StopReason::noise:
            return "noise";
        case StopReason::interrupted:
            return "interrupted";
    }
    return "unknown";
}

SessionResult run_session(const Estimator& estimator, const SessionOptions& options,
                          RenderState& state) {
    return Run(estimator, options, state).run();
}

SessionResult run_session(const Scene& scene, const Estimator& estimator,
                          const SessionOptions& options, FilmSums& film) {
    RenderIdentity identity;
    identity.samples_per_pixel = scene.render.samples_per_pixel;
    identity.film = film.layout();
    identity.light_paths = estimator.light_paths();
    RenderState state(std::move(identity), std::move(film));
    const SessionResult result = run_session(estimator, options, state);
    film = std::move(state.film);
    return result;
}

RenderIdentity render_identity(const Scene& scene, const SessionOptions& options,
                               const EstimatorRow& estimator, std::uint64_t scene_hash,
                               double light_paths) {
    const RenderSettings& settings = scene.render;
    RenderIdentity identity;
    identity.scene_hash = scene_hash;
    identity.estimator = estimator.name;
    identity.settings = estimator.settings(settings);
    identity.seed = settings.seed;
    identity.samples_per_pixel = settings.samples_per_pixel;
    identity.film = film_layout(scene, options);
    identity.light_paths = light_paths;
    identity.fingerprint = fingerprint();
    return identity;
}

FilmSums make_film(const Scene& scene, const SessionOptions& options) {
    return FilmSums(film_layout(scene, options));
}

double relative_noise(const FilmSums& film) {
    const PixelRect& crop = film.crop();
    const auto pixels = static_cast<double>(crop.area());
    double mean = 0.0;
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x) mean += film.xyz(x, y)[1] / pixels;
    if (!(mean > 0.0)) return 0.0;

    constexpr double kFloorShare = 0.01;
    double sum = 0.0;
    for (int y = crop.y0; y < crop.y1; ++y) {
        for (int x = crop.x0; x < crop.x1; ++x) {
            const double level = film.xyz(x, y)[1] + kFloorShare * mean;
            sum += film.variance_of_mean(x, y) / (level * level);
        }
    }
    return std::sqrt(sum / pixels);
}

std::string fingerprint() {
    return "dewbow " DEWBOW_VERSION "; " + compiler() + "; " + processor_features() + "; " +
           accelerator_fingerprint() + "; glibc " + gnu_get_libc_version();
}

}  // namespace dewbow
