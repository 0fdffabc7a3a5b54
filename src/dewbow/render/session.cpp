// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/session.h"

#include <gnu/libc-version.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/accelerator.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

using Clock = std::chrono::steady_clock;

/// Steps of a progress display that follows the clock or the noise.
constexpr std::uint64_t kShareSteps = 10000;

/// One call of run_session.
class Run {
public:
    Run(const Scene& scene, const Estimator& estimator, const SessionOptions& options,
        FilmSums& film)
        : estimator_(estimator),
          options_(options),
          film_(film),
          plan_(film.crop(), scene.render.samples_per_pixel),
          progress_(options.title, has_goal() ? kShareSteps : plan_.units(), options.progress) {}

    SessionResult run() {
        SessionResult result;
        result.reason = render_passes();
        if (has_goal()) advance_by_share();
        progress_.finish();
        result.crop = film_.crop();
        result.samples = samples_;
        result.samples_per_pixel =
            static_cast<double>(samples_) / static_cast<double>(film_.crop().area());
        result.finished_units = plan_.finished_units();
        result.planned_units = plan_.units();
        result.invalid_samples = film_.invalid_samples();
        result.film_hash = film_.fingerprint();
        result.seconds = seconds();
        return result;
    }

private:
    StopReason render_passes() {
        for (std::size_t pass = 0; pass < plan_.passes(); ++pass) {
            parallel_for(plan_.tiles(), [&](std::size_t tile) { render_unit(pass, tile); });
            if (plan_.finished_units() < (pass + 1) * plan_.tiles()) return StopReason::interrupted;
            if (pass + 1 == plan_.passes()) break;
            if (stopped()) return StopReason::interrupted;
            if (options_.time_limit && seconds() >= options_.time_limit->count())
                return StopReason::time;
            if (is_clean_enough(plan_.unit(pass, 0).end_sample)) return StopReason::noise;
        }
        return StopReason::complete;
    }

    void render_unit(std::size_t pass, std::size_t tile) {
        if (stopped()) return;
        const Unit unit = plan_.unit(pass, tile);
        estimator_.render(unit, film_);
        plan_.set_finished(pass, tile);
        samples_ += unit.tile.area() * (unit.end_sample - unit.first_sample);
        if (has_goal())
            advance_by_share();
        else
            progress_.advance();
    }

    bool has_goal() const { return options_.time_limit || options_.noise_target; }

    /// The share that is done is that of the time, of the way to the noise or of the units,
    /// whichever is largest. For the display only.
    void advance_by_share() {
        double share =
            static_cast<double>(plan_.finished_units()) / static_cast<double>(plan_.units());
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
        const double noise = relative_noise(film_);
        // Noise falls with the root of the samples.
        const double ratio = *options_.noise_target / noise;
        noise_share_ = noise > 0.0 ? ratio * ratio : 1.0;
        return samples_per_pixel >= kLeastSamplesForNoise && noise <= *options_.noise_target;
    }

    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    const Estimator& estimator_;
    const SessionOptions& options_;
    FilmSums& film_;
    UnitPlan plan_;
    Progress progress_;
    std::atomic<std::int64_t> samples_{0};
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

SessionResult run_session(const Scene& scene, const Estimator& estimator,
                          const SessionOptions& options, FilmSums& film) {
    return Run(scene, estimator, options, film).run();
}

FilmSums make_film(const Scene& scene, const SessionOptions& options) {
    const Film& film = scene.film;
    const double white_radiance = film.white_luminance / (kLuminousEfficacy * cie_y_integral());
    return FilmSums(film.width, film.height, crop_of(film, options), film.spectral_bins,
                    white_radiance);
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
