// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/training.h"

#include <algorithm>
#include <cmath>

#include "dewbow/base/parallel.h"
#include "dewbow/render/caustics/density_fit.h"

namespace dewbow::caustics {

namespace {

/// Each pass has twice as many paths as the one before.
constexpr int kPasses = 4;
constexpr std::int64_t kUnits = (1 << kPasses) - 1;  ///< 1 + 2 + 4 + 8
/// In the first pass. With fewer nothing can be learnt; most scenes have learnt what there is from
/// the usual number; ten thousand beads have not, and long renders give them more.
constexpr double kLeast = 64.0;
constexpr double kUsual = 4096.0;
constexpr double kMost = 16384.0;
/// Of the light paths of a render: up to the usual number, and beyond.
constexpr double kShare = 1.0 / 4.0;
constexpr double kShareBeyond = 1.0 / 16.0;
/// Paths that one thread traces in a row.
constexpr std::int64_t kBlock = 256;
/// No observation weighs more than the heaviest but one in so many: a few rare bright paths do not
/// say where to aim.
constexpr std::size_t kOutliers = 256;

constexpr std::uint64_t kStream = 0x747261696e696e67ULL;  // "training"

struct Arrived {
    AimPoint at;
    double f2;  ///< square of the light per uniform number on the cube; 0: none arrived
};

class Trainer {
public:
    Trainer(AimedEmission& emission, std::uint64_t seed, const TraceForTraining& trace)
        : emission_(emission), seed_(seed), trace_(trace), densities_(1) {}

    TrainingPass pass(std::int64_t paths) {
        const std::vector<Arrived> traced = trace_pass(paths);
        const std::size_t before = arrived_.size();
        std::copy_if(traced.begin(), traced.end(), std::back_inserter(arrived_),
                     [](const Arrived& path) { return path.f2 > 0.0; });
        paths_.push_back(double(paths));
        const TrainingPass pass{paths, std::int64_t(arrived_.size() - before)};
        std::vector<DensityObservation> observations = observe();
        densities_.push_back(fit_density(observations, emission_.lamp_edges()));
        emission_.learn(densities_.back());
        return pass;
    }

private:
    std::vector<Arrived> trace_pass(std::int64_t paths) const {
        std::vector<Arrived> traced(static_cast<std::size_t>(paths));
        const std::uint64_t stream =
            hash_combine(hash_combine(mix_bits(seed_), kStream), densities_.size());
        parallel_for(std::size_t((paths + kBlock - 1) / kBlock), [&](std::size_t block) {
            const auto first = std::int64_t(block) * kBlock;
            for (std::int64_t i = first; i < std::min(paths, first + kBlock); ++i)
                traced[std::size_t(i)] = trace_one(SampleKey(stream, std::uint32_t(i)));
        });
        return traced;
    }

    Arrived trace_one(const SampleKey& key) const {
        const AimedEmission::Aim aim = emission_.aim(AimedEmission::numbers(key));
        if (!aim.ray) return {aim.at, 0.0};
        const double squares = trace_(*aim.ray, key);
        return {aim.at, std::isfinite(squares) ? squares * aim.density * aim.density : 0.0};
    }

    /// All paths of all passes as samples of the mean of their densities.   [balance heuristic,
    /// Veach & Guibas 1995]
    std::vector<DensityObservation> observe() const {
        std::vector<double> weights;
        double paths = 0.0;
        for (const double n : paths_) paths += n;
        for (const Arrived& path : arrived_) {
            double density = 0.0;
            for (std::size_t k = 0; k < paths_.size(); ++k)
                density += paths_[k] / paths * densities_[k].density(path.at);
            weights.push_back(path.f2 / density);
        }
        const double most = heaviest(weights);
        std::vector<DensityObservation> observations;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            // Also where the heaviest is 0 or infinite: f2 is a square and leaves the range first.
            const double share = weights[i] < most ? weights[i] / most : 1.0;
            const double units = share * 0x1p31;
            observations.push_back({arrived_[i].at, std::max(1u, std::uint32_t(units))});
        }
        return observations;
    }

    /// What weights are cut off at.
    static double heaviest(std::vector<double> weights) {
        if (weights.empty()) return 1.0;
        const auto at = weights.end() - 1 - std::ptrdiff_t(weights.size() / kOutliers);
        std::nth_element(weights.begin(), at, weights.end());
        return *at;
    }

    AimedEmission& emission_;
    const std::uint64_t seed_;
    const TraceForTraining& trace_;
    std::vector<LearntDensity> densities_;  ///< that each pass followed, and the next
    std::vector<double> paths_;             ///< of each pass
    std::vector<Arrived> arrived_;          ///< of all passes
};

}  // namespace

TrainingReport train(AimedEmission& emission, std::uint64_t seed, double planned_paths,
                     const TraceForTraining& trace) {
    const double units = planned_paths / double(kUnits);
    const double paths = std::clamp(kShareBeyond * units, std::min(kShare * units, kUsual), kMost);
    TrainingReport report;
    if (emission.empty() || paths < kLeast) return report;
    Trainer trainer(emission, seed, trace);
    for (int pass = 0; pass < kPasses; ++pass)
        report.push_back(trainer.pass(std::int64_t(paths) << pass));
    return report;
}

}  // namespace dewbow::caustics
