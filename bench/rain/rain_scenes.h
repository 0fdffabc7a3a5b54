// SPDX-License-Identifier: Apache-2.0
#pragma once

// Landscapes in which it rains, for measuring what that costs.

#include <string>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow::bench {

struct RainScene {
    std::string name, what;
    Scene scene;
};
/// A plain with the sun 20° high behind the viewer and a shower of optical depth 1 before him:
/// open; with towers that throw shafts of shadow into the rain and stand before it; and these under
/// a dim sky. Surfaces are lit by lights alone: the noise of what they throw on each other would
/// hide that of rain.
std::vector<RainScene> make_rain_scenes(int width, int height);

}  // namespace dewbow::bench
