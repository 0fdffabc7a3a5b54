// SPDX-License-Identifier: Apache-2.0
#pragma once

// What computes a picture: one interface, and one row of estimators() for each method.

#include <memory>
#include <string>
#include <vector>

#include "dewbow/base/check.h"
#include "dewbow/render/film.h"
#include "dewbow/render/light_unit.h"
#include "dewbow/render/splat_list.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// A piece of work that is done whole or not at all: samples [first_sample, end_sample) of the
/// pixels of one tile.
struct Unit {
    PixelRect tile;
    std::int64_t first_sample = 0, end_sample = 0;
};

/// Calls `render_sample(x, y, index)` for each sample of `unit`; a check that fails meanwhile names
/// the sample.
template <class RenderSample>
void for_each_sample(const Unit& unit, std::uint64_t seed, RenderSample&& render_sample) {
    ReplayContext& replay = replay_context();
    replay.seed = seed;
    for (int y = unit.tile.y0; y < unit.tile.y1; ++y) {
        for (int x = unit.tile.x0; x < unit.tile.x1; ++x) {
            for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i) {
                replay.pixel_x = x, replay.pixel_y = y, replay.sample = i;
                render_sample(x, y, i);
            }
        }
    }
    replay = {};
}

/// Of the light paths that were traced to learn where to aim: what share of them brought light to
/// the picture.
struct LightPathReport {
    std::int64_t traced = 0;
    double arrived_at_first = 0.0;  ///< aimed by geometry alone
    double arrived_at_last = 0.0;   ///< by what was learnt
};

class Estimator {
public:
    virtual ~Estimator() = default;
    /// Adds the samples of `unit` to `film`. Called from many threads at once, never for
    /// overlapping tiles at the same time. A function of scene, settings and unit alone.
    virtual void render(const Unit& unit, FilmSums& film) const = 0;

    /// What of the scene it does not show, for people; empty: nothing that it does not refuse.
    virtual std::string leaves_out() const { return {}; }

    /// How many light paths it wants traced for each sample of each pixel of the whole picture; 0 =
    /// it has none.
    virtual double light_paths() const { return 0.0; }
    /// Traces the light paths of `unit` and adds what they bring to `splats`: a pixel's radiance is
    /// the mean of its samples, plus the sum of its splats over the number of light paths. Called
    /// from many threads at once. A function of scene, settings and unit alone.
    virtual void trace_light(const LightUnit& /*unit*/, SplatList& /*splats*/) const {}
    /// Nothing if none were traced.
    virtual std::optional<LightPathReport> light_path_report() const { return std::nullopt; }
};

struct EstimatorRow {
    std::string name;
    std::string description;
    /// `scene` must outlive the estimator.
    std::unique_ptr<Estimator> (*make)(const Scene& scene);
    /// The settings that its bits depend on, beside seed and samples.
    std::string (*settings)(const RenderSettings& settings);
};
const std::vector<EstimatorRow>& estimators();

}  // namespace dewbow
