// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/haze/haze_lamps.h"
#include "dewbow/render/haze/haze_view.h"
#include "dewbow/render/haze/lit_part.h"

namespace dewbow {

/// What a scene is prepared with, besides all else, if a medium of it scatters or drops do.
struct Haze {
    Haze(const Scene& scene, const LightSet& lights, const CameraRays& rays)
        : lamps(scene, lights), view(scene.camera, scene.film, rays), ball(ball_around(scene)) {}

    HazeLamps lamps;
    HazeView view;
    BoundingBall ball;  ///< around the scene
};

}  // namespace dewbow
