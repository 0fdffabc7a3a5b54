// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

/// The paper's rainbow stands before all that a flight shows, haze and rain as well. What is
/// replaced is no more than all, even where eq. 14 is taken as printed: no light is negative.
void CameraWalk::on_sight(SharedPath& path, const Hit& hit) {
    FogVeil veil;
    const auto u = key_.two(flight_key(path), Purpose::paper_fog);
    if (!prepared_.paper_fog->on_ray(path.ray.direction, hit.t, u, path.lanes, share_colours(),
                                     light_colours(), veil))
        return;
    add(path, veil.light, 1.0);
    for (int k = 0; k < path.lanes.count; ++k)
        path.beta[k] *= 1.0 - std::min(veil.replaced[k], 1.0);
}

}  // namespace dewbow::walk
