// SPDX-License-Identifier: Apache-2.0
#include "plain_scene.h"

#include <cmath>
#include <optional>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

[[noreturn]] void refuse(const std::string& what) {
    throw InputError("the benchmark's scenes hold only what every renderer can say: " + what);
}

PlainCamera plain_camera(const Scene& scene) {
    const auto* perspective = std::get_if<Perspective>(&scene.camera.projection);
    if (!perspective || scene.camera.lens || scene.camera.stereo) refuse("the camera is a pinhole");
    const PixelFilter& filter = scene.film.filter;
    if (filter.kind != FilterKind::box || filter.radius != 0.5)
        refuse("the pixel filter is a box of radius 0.5");
    const auto& world_from_camera = scene.camera.world_from_camera;
    const auto axis = [&](Vec3 v) { return normalised(world_from_camera(Dir<Camera>{v}).v); };
    PlainCamera camera;
    camera.eye = world_from_camera(Point<Camera>{}).v;
    camera.right = axis({1, 0, 0});
    camera.up = axis({0, 1, 0});
    camera.forward = axis({0, 0, -1});
    camera.tan_half_vertical_fov =
        std::tan(0.5 * perspective->vertical_field_of_view.to(unit::rad));
    camera.width = scene.film.width;
    camera.height = scene.film.height;
    return camera;
}

/// A body's corners in its own frame.
PlainBody corners_of(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh->normals.empty())
        refuse("facets are flat, but mesh '" + mesh->name + "' has normals");
    PlainBody body;
    for (const Point<Object>& vertex : mesh->vertices) body.vertices.push_back(vertex.v);
    body.triangles = mesh->triangles;
    return body;
}

PlainBody corners_of(const Box& box) {
    const double x = 0.5 * box.width.to(unit::m), y = 0.5 * box.height.to(unit::m),
                 z = 0.5 * box.depth.to(unit::m);
    PlainBody body;
    for (const int corner : {0, 1, 2, 3, 4, 5, 6, 7})
        body.vertices.push_back({corner & 1 ? x : -x, corner & 2 ? y : -y, corner & 4 ? z : -z});
    body.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return body;
}

PlainBody corners_of(const Prism& prism) {
    const double half = 0.5 * prism.apex.to(unit::rad), side = prism.side.to(unit::m);
    const double x = side * std::sin(half), height = side * std::cos(half);
    const double top = height * 2.0 / 3.0, bottom = -height / 3.0;
    const double z = 0.5 * prism.length.to(unit::m);
    PlainBody body;
    body.vertices = {{-x, bottom, -z}, {x, bottom, -z}, {0, top, -z},
                     {-x, bottom, z},  {x, bottom, z},  {0, top, z}};
    body.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                      {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return body;
}

template <class Other>
PlainBody corners_of(const Other&) {
    refuse("a clear body is a prism, a box or a mesh");
}

PlainBody plain_body(const Shape& shape, const Dielectric& glass) {
    if (!(glass.roughness == 0.0) || glass.tint || glass.interior->absorption)
        refuse("the body '" + shape.name + "' is smooth and clear");
    PlainBody body = std::visit([](const auto& g) { return corners_of(g); }, shape.geometry);
    for (Vec3& vertex : body.vertices) vertex = shape.world_from_object(Point<Object>{vertex}).v;
    body.index = glass.interior->index;
    return body;
}

Colour<LinearSrgb> film_colour(const Spectrum& radiance, double film_from_xyz) {
    return rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(radiance) * film_from_xyz);
}

PlainLamp plain_lamp(const Shape& shape, const Material& material, double film_from_xyz) {
    if (material.emission_texture || material.coverage || !material.emission)
        refuse("the surface '" + shape.name + "' glows evenly");
    PlainLamp lamp;
    lamp.name = shape.name;
    double u = 0.0, v = 0.0;
    if (const auto* rectangle = std::get_if<Rectangle>(&shape.geometry)) {
        u = 0.5 * rectangle->width.to(unit::m);
        v = 0.5 * rectangle->height.to(unit::m);
    } else if (const auto* disc = std::get_if<Disc>(&shape.geometry)) {
        lamp.shape = LampShape::disc;
        u = v = disc->radius.to(unit::m);
    } else {
        refuse("the glowing '" + shape.name + "' is a rectangle or a disc");
    }
    lamp.centre = shape.world_from_object(Point<Object>{}).v;
    lamp.half_u = shape.world_from_object(Dir<Object>{{u, 0, 0}}).v;
    lamp.half_v = shape.world_from_object(Dir<Object>{{0, v, 0}}).v;
    lamp.normal = shape.world_from_object(Normal<Object>{{0, 0, 1}}).v;
    lamp.radiance = material.emission;
    lamp.colour = film_colour(*material.emission, film_from_xyz);
    lamp.two_sided = material.two_sided_emission;
    return lamp;
}

}  // namespace

Vec3 PlainCamera::direction(double x, double y) const {
    const double scale = 2.0 * tan_half_vertical_fov / height;
    return forward + right * ((x - 0.5 * width) * scale) + up * ((0.5 * height - y) * scale);
}

PlainScene plain_scene(const Scene& scene) {
    PlainScene plain;
    plain.camera = plain_camera(scene);
    plain.surrounding_index = scene.surroundings->index;
    plain.film_from_xyz = kLuminousEfficacy / scene.film.white_luminance;
    for (const Shape& shape : scene.shapes) {
        const Material& material = scene.materials[std::size_t(shape.material)];
        if (const auto* glass = std::get_if<Dielectric>(&material.surface)) {
            if (plain.body.index) refuse("there is one clear body");
            plain.body = plain_body(shape, *glass);
        } else if (std::holds_alternative<Black>(material.surface)) {
            plain.lamps.push_back(plain_lamp(shape, material, plain.film_from_xyz));
        } else {
            refuse("the surface '" + shape.name + "' is clear, or black and glows");
        }
    }
    for (const Light& light : scene.lights) {
        const auto* even = std::get_if<UniformEnvironment>(&light);
        if (!even || plain.surroundings) refuse("the surroundings are even");
        plain.surroundings = even->radiance;
        plain.surroundings_colour = film_colour(*even->radiance, plain.film_from_xyz);
    }
    if (!plain.body.index) refuse("there is a clear body");
    return plain;
}

}  // namespace dewbow::bench
