// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/haze_share.h"

#include "dewbow/render/caustics/casters.h"

namespace dewbow::caustics {

bool goes_on(const PreparedScene& prepared, const Hit& hit) {
    if (!hit || prepared.see_through[std::size_t(hit.shape)]) return false;
    const Scene& scene = prepared.scene;
    const int material = scene.shapes[std::size_t(hit.shape)].material;
    return is_caster(scene, scene.materials[std::size_t(material)]);
}

bool light_paths_find(const PreparedScene& prepared, Vec3 point, bool from_afar, const Hit& next) {
    return goes_on(prepared, next) && (!from_afar || prepared.haze->ball.holds(point));
}

}  // namespace dewbow::caustics
