// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sets of coloured samples of the spectrum, fixed or jittered.           [Musgrave 1989, 4.1, 4.2]
// Pure functions of the random numbers, so that what the paper says of their sums is tested without
// a renderer.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dewbow/math/distribution.h"
#include "dewbow/spectrum/linear_model.h"
#include "dewbow/spectrum/spectral_model.h"

namespace dewbow {

/// What is moved within a sample's interval: the wavelength that the index is taken at, the one
/// that the colour is taken at, or both together.
enum class Jitter { none, index, colour, both };
/// Their words, in this order.
const std::vector<std::string>& jitter_names();
/// True if colours are moved, by themselves or with the index.
inline bool colours_move(Jitter jitter) {
    return jitter == Jitter::colour || jitter == Jitter::both;
}

/// Most samples of a set, and thus rays that one is split into.
inline constexpr int kMostSpectralSamples = 1000;

struct SpectralSampling {
    int samples = kPaperSamples;
    Jitter jitter = Jitter::none;
    bool correlated = false;  ///< one offset for all intervals, else one for each
    /// Intervals of equal area under |r| + |g| + |b| instead of equal width. [before eq. 13]
    bool tailored = false;
};

struct SpectralSample {
    double f_index = 0.0, f_colour = 0.0;  ///< spectral coordinates, 0 to 1
    MonitorRgb rgb;                        ///< weight: about (1, 1, 1) summed over the set
};

/// A model with the intervals and weights of its samples.
///
/// Sample k lies at the quantile (k + u) / N of a distribution over f, uniform or tailored, and
/// weighs density / (N pdf). Where colours do not move, u = ½ and each channel is divided by the
/// sum over the set, so that the set is white (eq. 13) for every N. Where they do, the sum is white
/// on average as it is, and is not divided.
class PreparedSpectralSampling {
public:
    /// @param sampling  at least one sample.
    /// Throws InputError if samples of fixed colour leave a channel without light, as one does.
    PreparedSpectralSampling(SpectralModelPtr model, const SpectralSampling& sampling);

    const SpectralModel& model() const { return *model_; }
    const SpectralSampling& sampling() const { return sampling_; }
    /// How many random numbers a set takes: 0, 1 or one a sample.
    std::size_t offset_count() const;

    /// Sum of the fixed samples, k + ½, before it is divided out: (1, 1, 1) for 13 of the linear
    /// model, 1.127, .932, 1.083 for 5.
    MonitorRgb raw_tint() const;

    /// The sample of interval `k`, with the offset `u` in [0, 1) for what is jittered.
    SpectralSample sample(int k, double u) const;

private:
    struct Place {
        double f, pdf;
    };
    Place place(int k, double u) const;
    MonitorRgb colour(const Place& at) const;

    SpectralModelPtr model_;
    SpectralSampling sampling_;
    std::optional<Distribution1D> tailored_;
    std::vector<SpectralSample> fixed_;  ///< undivided where colours move, else white together
};

/// One set. `offsets` are offset_count() numbers in [0, 1), `out` has as many places as the set.
void draw_spectral_samples(const PreparedSpectralSampling& prepared,
                           std::span<const double> offsets, std::span<SpectralSample> out);

}  // namespace dewbow
