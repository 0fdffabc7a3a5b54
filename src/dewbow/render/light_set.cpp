// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/sampling.h"
#include "dewbow/render/analytic_shape.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Share of the choices that falls on all lights alike, so that none is starved by an estimate of
/// power that knows nothing of distance and of what stands between.
constexpr double kEvenShare = 0.1;

double brightness(const Spectrum& spectrum) {
    return xyz_from_spectrum(spectrum)[1] / cie_y_integral();
}

/// Axis lengths of a transform's linear part agree to this: rounding of rotations.
constexpr double kUniformScale = 1e-9;

/// The scale of a transform that keeps spheres spheres, or nothing.
std::optional<double> uniform_scale(const Affine& a) {
    const double x = length(a.apply_linear({1, 0, 0}));
    const Vec3 unit_x = a.apply_linear({1, 0, 0}) / x;
    const double y = length(a.apply_linear({0, 1, 0})), z = length(a.apply_linear({0, 0, 1}));
    const bool alike = std::abs(x - y) < kUniformScale * x && std::abs(x - z) < kUniformScale * x;
    const bool square =
        std::abs(dot(unit_x, a.apply_linear({0, 1, 0}))) < kUniformScale * x &&
        std::abs(dot(unit_x, a.apply_linear({0, 0, 1}))) < kUniformScale * x &&
        std::abs(dot(a.apply_linear({0, 1, 0}), a.apply_linear({0, 0, 1}))) < kUniformScale * x * x;
    return alike && square ? std::optional(x) : std::nullopt;
}

std::vector<std::array<Vec3, 3>> triangles_of(const Geometry& geometry) {
    if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&geometry)) {
        std::vector<std::array<Vec3, 3>> result;
        for (const auto& [a, b, c] : (*mesh)->triangles)
            result.push_back(
                {(*mesh)->vertices[a].v, (*mesh)->vertices[b].v, (*mesh)->vertices[c].v});
        return result;
    }
    if (const auto* rectangle = std::get_if<Rectangle>(&geometry)) {
        const double x = 0.5 * rectangle->width.to(unit::m),
                     y = 0.5 * rectangle->height.to(unit::m);
        return {{Vec3{-x, -y, 0}, Vec3{x, -y, 0}, Vec3{x, y, 0}},
                {Vec3{-x, -y, 0}, Vec3{x, y, 0}, Vec3{-x, y, 0}}};
    }
    if (const auto* box = std::get_if<Box>(&geometry)) return triangles_of(*box);
    if (const auto* prism = std::get_if<Prism>(&geometry)) return triangles_of(*prism);
    return {};
}

double double_area(const std::array<Vec3, 3>& t) { return length(cross(t[1] - t[0], t[2] - t[0])); }

/// Points of a sphere as seen from outside: where a direction of the cone meets it.
double distance_to_sphere(Vec3 centre_from_here, double radius, Vec3 direction) {
    const double along = dot(centre_from_here, direction);
    const Vec3 aside = centre_from_here - direction * along;
    return along - std::sqrt(std::max(0.0, radius * radius - dot(aside, aside)));
}

/// Radiance of a disc in the sky that gives irradiance 1 to a surface which faces it: 1 / (π sin²
/// α), with 1 − cos α = `width`. Beyond the hemisphere nothing is added.
double radiance_of_disc(double width) {
    return 1.0 / (kPi * (width < 1.0 ? width * (2.0 - width) : 1.0));
}

/// 1 − cos of the half angle under which a sphere is seen; nothing from inside.
std::optional<double> seen_width(Vec3 centre_from_here, double radius) {
    const double sin2 = radius * radius / dot(centre_from_here, centre_from_here);
    if (!(sin2 < 1.0)) return std::nullopt;
    return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

}  // namespace

LightSet::LightSet(const Scene& scene) : light_of_shape_(scene.shapes.size(), -1) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        if (scene.materials[std::size_t(scene.shapes[i].material)].emission)
            add_shape_light(scene, int(i));
    const double radius = std::max(bounds_of(scene).radius(), 1e-3);
    for (const Light& light : scene.lights) add_light(light, radius);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Kind kind = lights_[i].kind;
        const bool distant = kind == Kind::distant && lights_[i].cone_width > 0.0;
        if (distant || kind == Kind::uniform || kind == Kind::image) infinite_.push_back(int(i));
    }
    if (lights_.empty()) return;
    double total = 0.0;
    for (const Entry& entry : lights_) total += entry.power;
    std::vector<double> weights;
    for (const Entry& entry : lights_)
        weights.push_back((1.0 - kEvenShare) * (total > 0.0 ? entry.power / total : 0.0) +
                          kEvenShare / double(lights_.size()));
    choose_.emplace(weights);
}

void LightSet::add_shape_light(const Scene& scene, int shape_index) {
    const Shape& shape = scene.shapes[std::size_t(shape_index)];
    const Material& material = scene.materials[std::size_t(shape.material)];
    if (std::holds_alternative<Plane>(shape.geometry))
        throw InputError("shape \"" + shape.name + "\" is a plane without end and gives off light",
                         "use a rectangle");
    Entry entry;
    entry.shape = shape_index;
    entry.spectrum = material.emission;
    entry.two_sided = material.two_sided_emission;
    entry.world_from_object = shape.world_from_object;
    const Affine& affine = shape.world_from_object.affine();
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) {
        const std::optional<double> scale = uniform_scale(affine);
        entry.kind = scale ? Kind::sphere : Kind::ellipsoid;
        entry.position = affine.apply({});
        entry.object_radius = sphere->radius.to(unit::m);
        entry.radius = entry.object_radius * scale.value_or(1.0);
        const double mean_scale = std::cbrt(std::abs(affine.determinant()));
        entry.area = 4.0 * kPi * std::pow(sphere->radius.to(unit::m) * mean_scale, 2.0);
    } else if (const auto* disc = std::get_if<Disc>(&shape.geometry)) {
        entry.kind = Kind::disc;
        entry.radius = disc->radius.to(unit::m);
        const Vec3 cross_section =
            cross(affine.apply_linear({1, 0, 0}), affine.apply_linear({0, 1, 0}));
        entry.area = kPi * entry.radius * entry.radius * length(cross_section);
    } else {
        entry.kind = Kind::triangles;
        std::vector<double> areas;
        const double side = affine.determinant() < 0.0 ? -1.0 : 1.0;
        for (std::array<Vec3, 3> t : triangles_of(shape.geometry)) {
            for (Vec3& corner : t) corner = affine.apply(corner);
            if (side < 0.0) std::swap(t[1], t[2]);
            areas.push_back(0.5 * double_area(t));
            entry.area += areas.back();
            entry.corners.push_back(t);
        }
        if (!(entry.area > 0.0)) return;
        entry.by_area.emplace(areas);
    }
    entry.power = kPi * entry.area * brightness(*entry.spectrum) * (entry.two_sided ? 2.0 : 1.0);
    light_of_shape_[std::size_t(shape_index)] = int(lights_.size());
    lights_.push_back(std::move(entry));
}

void LightSet::add_light(const Light& light, double scene_radius) {
    Entry entry;
    const double disc = kPi * scene_radius * scene_radius;
    if (const auto* point = std::get_if<PointLight>(&light)) {
        entry.kind = Kind::point;
        entry.position = point->position.v;
        entry.spectrum = point->intensity;
        entry.power = 4.0 * kPi * brightness(*entry.spectrum);
    } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
        entry.kind = Kind::spot;
        entry.position = spot->position.v;
        entry.axis = spot->direction.v;
        entry.spectrum = spot->intensity;
        const double outer = cos(spot->outer), inner = cos(spot->inner);
        entry.cos_scale = 1.0 / std::max(inner - outer, 1e-9);
        entry.cos_offset = -outer * entry.cos_scale;
        entry.power = 2.0 * kPi * (1.0 - outer) * brightness(*entry.spectrum);
    } else if (const auto* distant = std::get_if<DistantLight>(&light)) {
        entry.kind = Kind::distant;
        entry.axis = -distant->direction.v;
        entry.spectrum = distant->irradiance;
        entry.cone_width = one_minus_cos(distant->angular_radius);
        entry.power = disc * brightness(*entry.spectrum);
    } else if (const auto* uniform = std::get_if<UniformEnvironment>(&light)) {
        entry.kind = Kind::uniform;
        entry.spectrum = uniform->radiance;
        entry.power = 4.0 * kPi * disc * brightness(*entry.spectrum);
    } else {
        entry.kind = Kind::image;
        entry.map.emplace(std::get<std::shared_ptr<const ImageEnvironment>>(light));
        entry.power = 4.0 * kPi * disc * entry.map->mean_y();
    }
    lights_.push_back(std::move(entry));
}

LightSet::SurfacePoint LightSet::sample_surface(const Entry& entry, std::array<double, 2> u) {
    if (entry.kind == Kind::triangles) {
        const Distribution1D::Sample which = entry.by_area->sample(u[0]);
        const std::array<Vec3, 3>& t = entry.corners[which.index];
        const Barycentric b = sample_uniform_triangle(which.offset, u[1]);
        return {t[0] * b.a + t[1] * b.b + t[2] * b.c, normalised(cross(t[1] - t[0], t[2] - t[0])),
                1.0 / entry.area};
    }
    if (entry.kind == Kind::disc) {
        const DiscPoint p = sample_concentric_disc(u[0], u[1]);
        const Point<Object> local{{entry.radius * p.x, entry.radius * p.y, 0.0}};
        return {entry.world_from_object(local).v,
                entry.world_from_object(Normal<Object>{{0, 0, 1}}).v, 1.0 / entry.area};
    }
    const Vec3 n = sample_uniform_sphere<Object>(u[0], u[1]).v;
    const Vec3 point = entry.world_from_object(Point<Object>{n * entry.object_radius}).v;
    return {point, entry.world_from_object(Normal<Object>{n}).v, pdf_area(entry, point)};
}

/// Density per area of the world at a point of a light's surface.
double LightSet::pdf_area(const Entry& entry, Vec3 point) {
    if (entry.kind == Kind::triangles || entry.kind == Kind::disc) return 1.0 / entry.area;
    // An ellipsoid's area element is |det A| |A⁻ᵀ n| times that of its sphere.
    const Affine object_from_world = entry.world_from_object.inverse().affine();
    const Vec3 n = normalised(object_from_world.apply(point));
    const auto& m = object_from_world.m;
    const Vec3 stretched{m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                         m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                         m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
    const double stretch =
        std::abs(entry.world_from_object.affine().determinant()) * length(stretched);
    const Vec3 local = object_from_world.apply(point);
    return 1.0 / (4.0 * kPi * dot(local, local) * stretch);
}

std::optional<LightSample> LightSet::sample(Vec3 from, double u_choice,
                                            std::array<double, 2> u) const {
    if (lights_.empty()) return std::nullopt;
    const int light = int(choose_->sample(u_choice).index);
    const Entry& entry = lights_[std::size_t(light)];
    LightSample s;
    s.light = light;
    const double chosen = choice(light);
    switch (entry.kind) {
        case Kind::point:
        case Kind::spot: {
            const Vec3 to_light = entry.position - from;
            s.distance = length(to_light);
            if (!(s.distance > 0.0)) return std::nullopt;
            s.direction = to_light / s.distance;
            s.without_extent = true;
            s.pdf = chosen;
            s.factor = 1.0 / dot(to_light, to_light);
            if (entry.kind == Kind::spot) {
                const double cosine = -dot(s.direction, entry.axis);
                const double inside =
                    std::clamp(cosine * entry.cos_scale + entry.cos_offset, 0.0, 1.0);
                s.factor *= inside * inside;
            }
            if (s.factor == 0.0) return std::nullopt;
            return s;
        }
        case Kind::distant:
            s.distance = kInfinity;
            if (entry.cone_width == 0.0) {
                s.direction = entry.axis;
                s.without_extent = true;
                s.pdf = chosen;
            } else {
                s.direction = around(Dir<World>{entry.axis},
                                     sample_uniform_cone(entry.cone_width, u[0], u[1]))
                                  .v;
                s.pdf = chosen * pdf_uniform_cone(entry.cone_width);
            }
            return s;
        case Kind::uniform:
            s.distance = kInfinity;
            s.direction = sample_uniform_sphere<World>(u[0], u[1]).v;
            s.pdf = chosen * pdf_uniform_sphere();
            return s;
        case Kind::image: {
            const EnvironmentMap::Sample e = entry.map->sample(u);
            if (!(e.pdf > 0.0)) return std::nullopt;
            s.distance = kInfinity;
            s.direction = e.direction;
            s.pdf = chosen * e.pdf;
            return s;
        }
        case Kind::sphere: {
            const Vec3 centre = entry.position - from;
            const std::optional<double> width = seen_width(centre, entry.radius);
            if (width) {
                s.direction =
                    around(Dir<World>{normalised(centre)}, sample_uniform_cone(*width, u[0], u[1]))
                        .v;
                s.distance = distance_to_sphere(centre, entry.radius, s.direction);
                s.pdf = chosen * pdf_uniform_cone(*width);
                return s;
            }
            [[fallthrough]];
        }
        default: {
            const SurfacePoint p = sample_surface(entry, u);
            const Vec3 to_light = p.position - from;
            s.distance = length(to_light);
            if (!(s.distance > 0.0)) return std::nullopt;
            s.direction = to_light / s.distance;
            const double cosine = -dot(s.direction, p.normal);
            if (cosine == 0.0 || (cosine < 0.0 && !entry.two_sided)) return std::nullopt;
            s.pdf = chosen * p.pdf_area * s.distance * s.distance / std::abs(cosine);
            return s;
        }
    }
}

void LightSet::radiance(const LightSample& sample, const LaneSet& lanes, RgbLightLanes& rgb,
                        LaneValues& out) const {
    const Entry& entry = lights_[std::size_t(sample.light)];
    if (entry.kind == Kind::image) {
        rgb.eval(entry.map->radiance(sample.direction), lanes, out);
        return;
    }
    entry.spectrum->eval_lanes(lanes.lambdas(), out.first(lanes.count));
    double factor = sample.factor;
    if (entry.kind == Kind::distant && entry.cone_width > 0.0)
        factor = radiance_of_disc(entry.cone_width);
    if (factor != 1.0)
        for (int k = 0; k < lanes.count; ++k) out[k] *= factor;
}

bool LightSet::emits(const Hit& hit, Vec3 direction) const {
    const int light = light_of_shape_[std::size_t(hit.shape)];
    if (light < 0) return false;
    return lights_[std::size_t(light)].two_sided || dot(direction, hit.normal) < 0.0;
}

void LightSet::emission(const Hit& hit, const LaneSet& lanes, LaneValues& out) const {
    const Entry& entry = lights_[std::size_t(light_of_shape_[std::size_t(hit.shape)])];
    entry.spectrum->eval_lanes(lanes.lambdas(), out.first(lanes.count));
}

double LightSet::pdf_of_hit(Vec3 from, Vec3 direction, const Hit& hit) const {
    const int light = light_of_shape_[std::size_t(hit.shape)];
    const Entry& entry = lights_[std::size_t(light)];
    if (entry.kind == Kind::sphere)
        if (const auto width = seen_width(entry.position - from, entry.radius))
            return choice(light) * pdf_uniform_cone(*width);
    const double cosine = std::abs(dot(direction, hit.normal));
    if (cosine == 0.0) return 0.0;
    return choice(light) * pdf_area(entry, from + direction * hit.t) * hit.t * hit.t / cosine;
}

bool LightSet::infinite_radiance(int i, Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb,
                                 LaneValues& out) const {
    const int light = infinite_[std::size_t(i)];
    const Entry& entry = lights_[std::size_t(light)];
    if (entry.kind == Kind::distant) {
        // |a − b|² / 2 = 1 − cos of the angle between them, without cancellation.
        const Vec3 apart = direction - entry.axis;
        if (0.5 * dot(apart, apart) > entry.cone_width) return false;
    }
    LightSample sample;
    sample.light = light;
    sample.direction = direction;
    radiance(sample, lanes, rgb, out);
    return true;
}

double LightSet::pdf_of_infinite(int i, Vec3 direction) const {
    const int light = infinite_[std::size_t(i)];
    const Entry& entry = lights_[std::size_t(light)];
    if (entry.kind == Kind::image) return choice(light) * entry.map->pdf(direction);
    if (entry.kind == Kind::uniform) return choice(light) * pdf_uniform_sphere();
    return choice(light) * pdf_uniform_cone(entry.cone_width);
}

}  // namespace dewbow
