// SPDX-License-Identifier: Apache-2.0
#pragma once

// `--estimator auto`: which estimator suits a scene, and why.

#include "dewbow/render/estimator.h"

namespace dewbow {

/// What stands for the choice where an estimator is named.
inline constexpr const char* kAutomaticEstimator = "auto";

/// Light paths are traced if they bring at least this mean share of the light of parts of the
/// picture (light_share).
inline constexpr double kLeastLightShare = 2e-4;

struct EstimatorChoice {
    const EstimatorRow& row;
    std::unique_ptr<Estimator> estimator;  ///< of `row`
    std::string reason;                    ///< "nothing here bends or mirrors light"
};

/// `path`, or `caustics` where light paths pay. Scenes without anything that bends or mirrors
/// light, without a lamp or without anything that scatters cost nothing to tell; else a pilot
/// follows, aimed by geometry alone. A function of scene, settings and seed alone.
/// `scene` must outlive the estimator.
EstimatorChoice choose_estimator(const Scene& scene);

}  // namespace dewbow
