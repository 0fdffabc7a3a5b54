// SPDX-License-Identifier: Apache-2.0
#pragma once

// What aiming learns before a render begins: from which lamps and along which of their rays light
// reaches what the camera sees. A number of light paths that follows from the samples, in a few
// passes, each aimed by what those before it found; then the density is frozen. It is a function of
// scene, settings and seed alone: every slice and every rank repeats it, with the same bits on any
// number of threads.

#include <cstdint>
#include <functional>
#include <vector>

#include "dewbow/base/random.h"
#include "dewbow/render/caustics/aimed_emission.h"

namespace dewbow::caustics {

/// Traces one light path that starts as `ray`, with numbers of `key`.
/// @return  the sum over pixels of the squares of Y that it brings them, in any unit. Called from
/// many threads at once.
using TraceForTraining = std::function<double(const EmittedRay& ray, const SampleKey& key)>;

/// How many paths of one pass brought light to the picture.
struct TrainingPass {
    std::int64_t paths = 0, arrived = 0;

    double share() const { return paths ? double(arrived) / double(paths) : 0.0; }
};
/// The first was aimed by geometry alone, the last by what three had learnt. Empty: too little to
/// render for learning to be worth it.
using TrainingReport = std::vector<TrainingPass>;

/// Teaches `emission`.   @param planned_paths  light paths of the render: learning takes at most a
/// quarter as many, a sixteenth of long ones.
TrainingReport train(AimedEmission& emission, std::uint64_t seed, double planned_paths,
                     const TraceForTraining& trace);

}  // namespace dewbow::caustics
