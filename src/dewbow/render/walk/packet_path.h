// SPDX-License-Identifier: Apache-2.0
#pragma once

// What travels: a packet of wavelengths on one ray, or on a ray for each.

#include <array>
#include <cstdint>

#include "dewbow/render/lanes.h"
#include "dewbow/render/media.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/receiver.h"

namespace dewbow::walk {

/// Where a path was last turned at random: for the weight of what it finds by chance.
struct LastTurn {
    /// Nothing but smooth surfaces, and such as stop shadow rays, lies behind it.
    bool specular = true;
    double pdf = 0.0;  ///< else of the direction that it took, sr⁻¹
    Receiver receiver;
    bool rough_glass = false;  ///< what turned it
    /// A drop of rain turned it: lights that it runs into by that have been found from there.
    bool drop = false;
};

/// One ray with the lanes that it carries.
struct SharedPath {
    Ray ray;
    LaneSet lanes;
    LaneValues beta;  ///< throughput / n²
    MediaStack media;
    int depth = 0;
    std::uint32_t branch = 0;  ///< tells the random numbers of suffixes apart
    int passed = 0;            ///< boundaries that are none since the last that was one
    bool scattered = false;    ///< has met something rough
    bool split = false;        ///< has split at a dispersive boundary
    bool hidden = false;       ///< has passed a boundary that is none, but stops shadow rays
    bool in_rain = false;      ///< has met rain, and is one of the two ways from there
    int drops = 0;             ///< how many have turned it
    bool from_afar = false;    ///< starts infinitely far: nothing is absorbed on the first way
    LastTurn last;
    double note = 0.0;  ///< what the hooks keep with it

    /// Nothing that stops shadow rays lies between it and its start.
    bool sees_start() const { return depth == 0 && !hidden; }
};

/// Lanes on rays of their own.
struct OpenPath {
    LaneSet lanes;
    RayLanes rays;
    LaneValues beta;
    std::array<MediaStack, kMaxLanes> media;
    LaneMask active = 0;
    int depth = 0;
    std::uint32_t branch = 0;
    LaneMask hidden = 0;
    bool scattered = false;  ///< as of SharedPath
    int drops = 0;           ///< as of SharedPath
    std::array<LastTurn, kMaxLanes> last;
    LaneValues note;
};

}  // namespace dewbow::walk
