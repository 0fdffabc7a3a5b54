// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's first rainbow: 13 coloured fogs in rings around the antisolar point.
//                                                                      [Musgrave 1989, 4.3.1]

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/spectrum/linear_model.h"

namespace dewbow {

/// The snippet's index as it stands there: (dot − rainbow_angle) · rainbow_width.
/// @param dot  cosine of the angle between the ray and the antisolar vector.
/// It selects 13 rings only if `rainbow_angle` is the cosine of the outer radius and
/// `rainbow_width` is 13 / (cos inner − cos outer); the names promise angles.
double published_ring_index(double dot, double rainbow_angle, double rainbow_width);

/// What the names promise: 0 at the outer radius, 13 at the inner one, even in angle.
/// @param r  angle from the antisolar point.
double ring_index(Angle r, Angle outer, Angle inner);

struct FogJitter {
    /// Width of the random part of the index, in rings; 0: the option is off.
    double delta = 0.0;
    /// The improvement that the paper suggests: a colour from anywhere within the ring's part of
    /// the spectrum, instead of that in its middle.
    bool colour = false;
};

/// The fog of ring `index`, red outside; nothing where there is no fog.
/// @param u  in [0, 1): what jitters the index, and the colour.
std::optional<Colour<LinearSrgb>> ring_fog(double index, const FogJitter& jitter,
                                           std::array<double, 2> u);

/// A primary bow as the paper describes it.
struct ImpressionisticBow {
    Angle outer = 43.0 * unit::deg, inner = 41.0 * unit::deg;
    enum class Index { by_cosine, by_angle } index = Index::by_cosine;
    FogJitter jitter;
};
/// Index of the ring at angle r from the antisolar point, before it is jittered.
double ring_index(const ImpressionisticBow& bow, Angle r);

/// Mean fog colour of `samples` rays at each angle from the antisolar point, black where none.
std::vector<Colour<LinearSrgb>> impressionistic_strip(const ImpressionisticBow& bow,
                                                      std::span<const Angle> angles, int samples,
                                                      std::uint64_t seed);

}  // namespace dewbow
