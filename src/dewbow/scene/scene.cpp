// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/scene.h"

#include <algorithm>
#include <limits>

namespace dewbow {

int Scene::add(Material material) {
    materials.push_back(std::move(material));
    return int(materials.size()) - 1;
}

Scene make_empty_scene() {
    Scene scene;
    scene.surroundings =
        std::make_shared<Medium>(Medium{"air", air(), nullptr, std::numeric_limits<int>::min()});
    return scene;
}

PerspectiveCamera frame_bounds(const Bounds& bounds, double aspect) {
    // From the right and a little above: three faces of a box show. Direction to the eye, not unit
    // length.
    const Vec3 to_eye = normalised({0.55, 0.45, 1.0});
    PerspectiveCamera camera;
    camera.name = "framed";
    camera.vertical_field_of_view = 35.0 * unit::deg;
    const double half_height = tan(0.5 * camera.vertical_field_of_view);
    const double half_angle = std::atan(half_height * std::min(aspect, 1.0));
    // The sphere around the bounds touches the edges of the narrower side; a twentieth of air
    // around it.
    const double radius = bounds.radius() > 0.0 ? bounds.radius() : 1.0;
    const double distance = 1.05 * radius / std::sin(half_angle);
    const Vec3 centre = bounds.empty() ? Vec3{} : bounds.centre();
    camera.world_from_camera =
        Transform<World, Camera>(looking_at(centre + to_eye * distance, centre, {0.0, 1.0, 0.0}));
    return camera;
}

}  // namespace dewbow
