// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/merge.h"

#include <cmath>

namespace dewbow {
namespace {

struct MoveLight {
    const Affine& world_from_guest;

    Point<World> moved(Point<World> p) const { return {world_from_guest.apply(p.v)}; }
    Dir<World> moved(Dir<World> d) const {
        return {normalised(world_from_guest.apply_linear(d.v))};
    }
    Transform<World, Object> turned(const Transform<World, Object>& rotation) const {
        Affine both = without_scale(world_from_guest * rotation.affine());
        for (auto& row : both.m) row[3] = 0.0;
        return Transform<World, Object>(both);
    }

    Light operator()(PointLight light) const {
        light.position = moved(light.position);
        return light;
    }
    Light operator()(SpotLight light) const {
        light.position = moved(light.position);
        light.direction = moved(light.direction);
        return light;
    }
    Light operator()(ProfileLight light) const {
        light.position = moved(light.position);
        light.world_from_object = turned(light.world_from_object);
        return light;
    }
    /// The disc grows with the guest, and with it the power that the beam carries.
    Light operator()(BeamLight light) const {
        light.position = moved(light.position);
        light.direction = moved(light.direction);
        light.radius = light.radius * std::cbrt(std::abs(world_from_guest.determinant()));
        return light;
    }
    Light operator()(DistantLight light) const {
        light.direction = moved(light.direction);
        return light;
    }
    Light operator()(const UniformEnvironment& light) const { return light; }
    Light operator()(const std::shared_ptr<const ImageEnvironment>& light) const {
        auto moved = std::make_shared<ImageEnvironment>(*light);
        moved->world_from_object = turned(light->world_from_object);
        return std::shared_ptr<const ImageEnvironment>(moved);
    }
    /// North and up are the host's.
    Light operator()(const SkyDomePtr& sky) const { return sky; }
};

/// Where each material of the guest is found in the host.
std::vector<int> add_materials(Scene& host, const Scene& guest,
                               const std::vector<MaterialOverride>& overrides) {
    const int first = int(host.materials.size());
    std::vector<int> host_index;
    for (const Material& material : guest.materials) {
        Material copy = material;
        if (auto* mix = std::get_if<Mix>(&copy.surface)) {
            mix->first += first;
            mix->second += first;
        }
        host_index.push_back(host.add(std::move(copy)));
        for (const MaterialOverride& override_ : overrides) {
            if (override_.name == material.name) host_index.back() = override_.host_material;
        }
    }
    return host_index;
}

}  // namespace

Light moved(const Light& light, const Affine& world_from_guest) {
    return std::visit(MoveLight{world_from_guest}, light);
}

Affine without_scale(const Affine& affine) {
    const Vec3 eye = affine.apply({});
    const Vec3 ahead = normalised(affine.apply_linear({0.0, 0.0, -1.0}));
    const Vec3 up = normalised(affine.apply_linear({0.0, 1.0, 0.0}));
    return looking_at(eye, eye + ahead, up);
}

CameraView moved(CameraView camera, const Affine& world_from_guest) {
    if (auto* orthographic = std::get_if<Orthographic>(&camera.projection))
        orthographic->height *= length(
            world_from_guest.apply_linear(camera.world_from_camera(Dir<Camera>{{0, 1, 0}}).v));
    camera.world_from_camera = Transform<World, Camera>(
        without_scale(world_from_guest * camera.world_from_camera.affine()));
    return camera;
}

void merge(Scene& host, const Scene& guest, const Affine& world_from_guest,
           const std::vector<MaterialOverride>& overrides) {
    const std::vector<int> host_index = add_materials(host, guest, overrides);
    Mirrors mirrors;
    for (Shape shape : guest.shapes) {
        shape.material = host_index[std::size_t(shape.material)];
        shape.world_from_object =
            Transform<World, Object>(world_from_guest * shape.world_from_object.affine());
        host.shapes.push_back(mirrors.upright(std::move(shape)));
    }
    for (const Light& light : guest.lights) host.lights.push_back(moved(light, world_from_guest));
}

}  // namespace dewbow
