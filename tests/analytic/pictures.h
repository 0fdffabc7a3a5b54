// SPDX-License-Identifier: Apache-2.0
#pragma once

// Small pictures of one scene by different methods and seeds.

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <functional>
#include <string>

#include "dewbow/render/session.h"

namespace dewbow::kit {

using EstimatorPtr = std::unique_ptr<Estimator>;
using MakeEstimator = std::function<EstimatorPtr(const Scene&)>;

/// The row of that name of estimators().
inline MakeEstimator method(const std::string& name) {
    const auto row = std::find_if(estimators().begin(), estimators().end(),
                                  [&](const EstimatorRow& e) { return e.name == name; });
    if (row == estimators().end()) throw std::logic_error("there is no method " + name);
    return row->make;
}

struct TimedFilm {
    FilmSums film;
    double making_seconds;  ///< of the processor, once for a picture of any size
    double cpu_seconds;     ///< of all threads, the making of the estimator included
};
inline TimedFilm film_of(Scene scene, const MakeEstimator& make, int samples, std::uint64_t seed) {
    scene.render.samples_per_pixel = samples;
    scene.render.seed = seed;
    const std::clock_t begun = std::clock();
    const auto seconds = [&] { return double(std::clock() - begun) / CLOCKS_PER_SEC; };
    const EstimatorPtr estimator = make(scene);
    const double making = seconds();
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    const SessionResult result = run_session(scene, *estimator, options, film);
    EXPECT_EQ(result.invalid_samples, 0);
    return {std::move(film), making, seconds()};
}

}  // namespace dewbow::kit
