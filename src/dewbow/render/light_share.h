// SPDX-License-Identifier: Apache-2.0
#pragma once

// A pilot: what light paths would bring to a picture, from a fixed number of samples.

#include "dewbow/render/caustics/caustics.h"

namespace dewbow {

/// The picture is looked at in so many parts along its longer side.
inline constexpr int kPilotParts = 32;
/// Camera samples in each part, each of a pixel of its own.
inline constexpr int kPilotSamples = 4;
inline constexpr int kPilotLightPaths = 8192;

/// Weights are as though there were so many times fewer light paths than the settings say: then
/// what light paths bring is what camera paths would find much too seldom. A light path costs up to
/// four camera samples; where it is less than a thousand times as likely as a camera path to find
/// the same light (a room under a dome, glass before large panels: the scenes of examples/ and
/// bench/scenes), `path` is ahead at equal time.
inline constexpr double kPilotFewer = 4096.0;

/// How much of the light of a part of the picture is brought by light paths, with weights beside
/// camera paths: the mean over all parts, so that a small bright caustic counts by the place that
/// it takes and not by its flux. Parts that are nearly black count by less: 1 % of the mean light
/// is added to each. 0 of a black picture.
///
/// A function of scene, settings and seed alone; its random numbers are not those of the render,
/// which it must not foresee.
/// @param estimator  of `scene`; it wants light paths.
double light_share(const CausticsEstimator& estimator, const Scene& scene);

}  // namespace dewbow
