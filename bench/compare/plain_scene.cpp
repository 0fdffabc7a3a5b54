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

PlainBody corners_of(const Sphere& sphere) {
    PlainBody body;
    body.sphere = PlainSphere{{}, sphere.radius.to(unit::m)};
    return body;
}

template <class Other>
PlainBody corners_of(const Other&) {
    refuse("a clear body is a prism, a box, a sphere or a mesh");
}

PlainBody plain_body(const Shape& shape, const Dielectric& glass) {
    if (!(glass.roughness == 0.0) || glass.tint || glass.interior->absorption)
        refuse("the body '" + shape.name + "' is smooth and clear");
    PlainBody body = std::visit([](const auto& g) { return corners_of(g); }, shape.geometry);
    for (Vec3& vertex : body.vertices) vertex = shape.world_from_object(Point<Object>{vertex}).v;
    if (body.sphere) {
        body.sphere->centre = shape.world_from_object(Point<Object>{}).v;
        body.sphere->radius *= length(shape.world_from_object(Dir<Object>{{1, 0, 0}}).v);
    }
    body.index = glass.interior->index;
    body.priority = glass.interior->priority;
    body.name = shape.name;
    return body;
}

Colour<LinearSrgb> film_colour(const Spectrum& radiance, double film_from_xyz) {
    return rgb_from_xyz<LinearSrgb>(xyz_from_spectrum(radiance) * film_from_xyz);
}

/// What is flat, as a lamp: its form and place alone.
PlainLamp flat_thing(const Shape& shape) {
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
        refuse("the surface '" + shape.name + "' is a rectangle or a disc");
    }
    lamp.centre = shape.world_from_object(Point<Object>{}).v;
    lamp.half_u = shape.world_from_object(Dir<Object>{{u, 0, 0}}).v;
    lamp.half_v = shape.world_from_object(Dir<Object>{{0, v, 0}}).v;
    lamp.normal = shape.world_from_object(Normal<Object>{{0, 0, 1}}).v;
    return lamp;
}

PlainLamp plain_lamp(const Shape& shape, const Material& material, double film_from_xyz) {
    if (material.emission_texture || material.coverage || !material.emission)
        refuse("the surface '" + shape.name + "' glows evenly");
    PlainLamp lamp = flat_thing(shape);
    lamp.radiance = material.emission;
    lamp.colour = film_colour(*material.emission, film_from_xyz);
    lamp.two_sided = material.two_sided_emission;
    return lamp;
}

/// @param reflectance  nullptr: none.
PlainReceiver plain_receiver(const Shape& shape, const Material& material,
                             const ColourInput* reflectance) {
    if (material.gives_light() || material.coverage || material.normal_map ||
        (reflectance && (reflectance->texture || reflectance->vertex_colour)))
        refuse("the surface '" + shape.name + "' scatters evenly, and glows not");
    const PlainLamp flat = flat_thing(shape);
    if (flat.shape != LampShape::rectangle)
        refuse("the surface '" + shape.name + "' is a rectangle");
    PlainReceiver receiver{flat.name, flat.centre, flat.normal, flat.half_u, flat.half_v};
    if (!reflectance) return receiver;
    const auto at = [&](double nm) { return (*reflectance->spectrum)(nm * unit::nm); };
    receiver.reflectance = at(kLambdaMin_nm);
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0)
        if (at(nm) != receiver.reflectance) refuse("the surface '" + shape.name + "' is grey");
    return receiver;
}

/// Adds a light that is no shape.
struct AddLight {
    PlainScene& plain;

    void operator()(const UniformEnvironment& even) const {
        if (plain.surroundings) refuse("there are one surroundings");
        plain.surroundings = even.radiance;
        plain.surroundings_colour = film_colour(*even.radiance, plain.film_from_xyz);
    }
    void operator()(const SpotLight& spot) const {
        /// A cone with a hard edge, as far as an inner angle below the outer one can say it.
        constexpr double kHard = 0.999;
        if (spot.inner.to(unit::rad) < kHard * spot.outer.to(unit::rad))
            refuse("a spot has a hard edge");
        plain.spots.push_back({spot.position.v, normalised(spot.direction.v),
                               spot.outer.to(unit::rad), spot.intensity,
                               film_colour(*spot.intensity, plain.film_from_xyz)});
    }
    void operator()(const DistantLight& sun) const {
        plain.suns.push_back({normalised(sun.direction.v), sun.angular_radius.to(unit::rad),
                              sun.irradiance, film_colour(*sun.irradiance, plain.film_from_xyz)});
    }
    template <class Other>
    void operator()(const Other&) const {
        refuse("lights are surfaces, spots, suns and even surroundings");
    }
};

void check(const PlainScene& plain) {
    if (plain.bodies.empty()) refuse("there is a clear body");
    if (plain.has_caustics()) {
        if (plain.surroundings) refuse("there are no surroundings where light falls on things");
        return;
    }
    if (plain.bodies.size() > 1) refuse("there is one clear body");
    if (plain.bodies[0].sphere) refuse("the one clear body has flat faces");
    if (!plain.spots.empty() || !plain.suns.empty())
        refuse("the surroundings are even, and lamps are surfaces");
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
            plain.bodies.push_back(plain_body(shape, *glass));
        } else if (const auto* diffuse = std::get_if<Diffuse>(&material.surface)) {
            plain.receivers.push_back(plain_receiver(shape, material, &diffuse->reflectance));
        } else if (!std::holds_alternative<Black>(material.surface)) {
            refuse("the surface '" + shape.name + "' is clear, scatters evenly, or is black");
        } else if (material.gives_light()) {
            plain.lamps.push_back(plain_lamp(shape, material, plain.film_from_xyz));
        } else {
            plain.receivers.push_back(plain_receiver(shape, material, nullptr));
        }
    }
    for (const Light& light : scene.lights) std::visit(AddLight{plain}, light);
    check(plain);
    return plain;
}

}  // namespace dewbow::bench
