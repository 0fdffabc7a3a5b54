// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/scene.h"

#include <algorithm>
#include <array>
#include <limits>

namespace dewbow {

int Scene::add(Material material) {
    materials.push_back(std::move(material));
    return int(materials.size()) - 1;
}

const DistantLight* first_sun(const Scene& scene) {
    for (const Light& light : scene.lights)
        if (const auto* sun = std::get_if<DistantLight>(&light)) return sun;
    return nullptr;
}

Scene make_empty_scene() {
    Scene scene;
    scene.surroundings =
        std::make_shared<Medium>(Medium{"air", air(), nullptr, std::numeric_limits<int>::min()});
    return scene;
}

CameraView frame_bounds(const Bounds& bounds, double aspect) {
    // From the front (+z), a little from the right and from above: three faces of a box show.
    const Vec3 to_eye = normalised({0.32, 0.26, 1.0});
    const Vec3 centre = bounds.empty() ? Vec3{} : bounds.centre();
    const Perspective projection{30.0 * unit::deg};
    CameraView camera;
    camera.name = "framed";
    camera.projection = projection;
    const double half_height = tan(0.5 * projection.vertical_field_of_view);
    const Affine turned = looking_at(centre + to_eye, centre, {0.0, 1.0, 0.0});
    const Affine camera_from_world = turned.inverse().value();
    std::array<Vec3, 8> seen{};  // the corners from the centre, in the camera's frame
    for (std::size_t i = 0; i < 8 && !bounds.empty(); ++i)
        seen[i] = camera_from_world.apply_linear(Vec3{i & 1 ? bounds.high.x : bounds.low.x,
                                                      i & 2 ? bounds.high.y : bounds.low.y,
                                                      i & 4 ? bounds.high.z : bounds.low.z} -
                                                 centre);
    // As near as the corners allow, with a twentieth of air around them, and so aside that they are
    // seen in the middle. One depends on the other; four rounds settle both.
    double distance = bounds.radius() > 0.0 ? 4.0 * bounds.radius() : 5.0, x = 0.0, y = 0.0;
    for (int round = 0; round < 4 && bounds.radius() > 0.0; ++round) {
        Vec3 low{1e300, 1e300, 0.0}, high{-1e300, -1e300, 0.0};
        for (const Vec3& p : seen) {
            const Vec3 projected{(p.x - x) / (distance - p.z), (p.y - y) / (distance - p.z), 0.0};
            low = min(low, projected), high = max(high, projected);
        }
        x += 0.5 * (low.x + high.x) * distance, y += 0.5 * (low.y + high.y) * distance;
        distance = 0.0;
        for (const Vec3& p : seen) {
            const double aside = std::max(std::abs(p.x - x) / aspect, std::abs(p.y - y));
            distance = std::max(distance, 1.05 * aside / half_height + p.z);
        }
    }
    const Vec3 target = centre + turned.apply_linear({x, y, 0.0});
    camera.world_from_camera =
        Transform<World, Camera>(looking_at(target + to_eye * distance, target, {0.0, 1.0, 0.0}));
    return camera;
}

}  // namespace dewbow
