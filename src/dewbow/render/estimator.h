// SPDX-License-Identifier: Apache-2.0
#pragma once

// What computes a picture: one interface, and one row of estimators() for each method.

#include <memory>
#include <string>
#include <vector>

#include "dewbow/render/film.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// A piece of work that is done whole or not at all: samples [first_sample, end_sample) of the
/// pixels of one tile.
struct Unit {
    PixelRect tile;
    std::int64_t first_sample = 0, end_sample = 0;
};

class Estimator {
public:
    virtual ~Estimator() = default;
    /// Adds the samples of `unit` to `film`. Called from many threads at once, never for
    /// overlapping tiles at the same time. A function of scene, settings and unit alone.
    virtual void render(const Unit& unit, FilmSums& film) const = 0;
};

struct EstimatorRow {
    std::string name;
    std::string description;
    /// `scene` must outlive the estimator.
    std::unique_ptr<Estimator> (*make)(const Scene& scene);
};
const std::vector<EstimatorRow>& estimators();

}  // namespace dewbow
