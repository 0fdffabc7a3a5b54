// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/surface_emission.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/render/caustics/directions_to.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::caustics {

namespace {

constexpr double kPi = std::numbers::pi;
/// Of a target that fills more than this, a third of the hemisphere, some is likely to be below the
/// lamp's horizon, and the cosine differs much: directions then go by the cosine.
constexpr double kWide_sr = 2.0;
/// Tables of parts by targets have no more cells than this: some 12 MB. Else one serves all.
constexpr std::size_t kMostCells = std::size_t{1} << 20;
/// Least cosine that a part counts with if its centre does not see that of the target.
constexpr double kLeastCosine = 0.05;

/// The directions in which light leaves a point towards a target.
class Fan {
public:
    Fan(Vec3 point, Vec3 normal, bool two_sided, const CasterBounds& target)
        : normal_(normal), two_sided_(two_sided), to_(DirectionsTo::from(point, target)) {
        if (to_ && to_->solid_angle() > kWide_sr) to_.reset();
    }

    DirectionsTo::Sample sample(std::array<double, 2> u) const {
        if (to_) return to_->sample(u);
        double side = 1.0;
        if (two_sided_) {
            side = u[0] < 0.5 ? 1.0 : -1.0;
            u[0] = side > 0.0 ? 2.0 * u[0] : 2.0 * u[0] - 1.0;
        }
        const Dir<Local> local = sample_cosine_hemisphere(u[0], u[1]);
        return {around(Dir<World>{normal_ * side}, local).v, density(local.v.z)};
    }

    std::optional<SquarePlace> place_of(Vec3 direction) const {
        if (to_) return to_->place_of(direction);
        const double side = dot(direction, normal_) < 0.0 ? -1.0 : 1.0;
        if (side < 0.0 && !two_sided_) return std::nullopt;
        const Dir<Local> local = from_axis(Dir<World>{normal_ * side}, Dir<World>{direction});
        auto u = square_from_cosine_hemisphere(local);
        if (two_sided_) u[0] = 0.5 * (side > 0.0 ? u[0] : 1.0 + u[0]);
        return SquarePlace{u, density(local.v.z)};
    }

private:
    double density(double cosine) const {
        return pdf_cosine_hemisphere(cosine) * (two_sided_ ? 0.5 : 1.0);
    }

    Vec3 normal_;
    bool two_sided_;
    std::optional<DirectionsTo> to_;  ///< nothing: by the cosine
};

/// How far a body reaches from its centre along a unit vector.
double reach_along(const CasterBounds& target, Vec3 n) {
    if (const auto* box = std::get_if<OrientedBox>(&target.body())) {
        const Vec3 local = box->to_local(n);
        return std::abs(local.x) * box->half.x + std::abs(local.y) * box->half.y +
               std::abs(local.z) * box->half.z;
    }
    return target.ball().radius;
}

}  // namespace

SurfaceEmission::SurfaceEmission(const GlowingShape& shape, int index, const Aims& aims)
    : GroupedEmission(LightSample::Source::shape, index, aims, 2),
      shape_(shape),
      ball_(shape.ball()) {
    std::vector<bool> dark(groups().size(), false);
    const auto count = std::size_t(shape.parts());
    const bool one_table = count * groups().size() > kMostCells;
    double whole = 0.0;
    for (std::size_t part = 0; part < count; ++part) whole += shape.bounds(int(part)).intensity;
    for (std::size_t target = 0; target < groups().size(); ++target) {
        if (ball_) caps_.push_back(cap_towards(groups()[target]));
        if (one_table && target > 0) continue;
        std::vector<double> weights(count);
        for (std::size_t part = 0; part < count; ++part)
            weights[part] =
                one_table ? shape.bounds(int(part)).intensity : weight(int(part), groups()[target]);
        parts_.emplace_back(weights);
        dark[target] = !one_table && parts_.back().was_all_zero();
    }
    weigh(groups().size(), dark, kPi * whole);
}

/// Directions to the target lie within β = asin((R + r) / d) of that between the centres. At θ from
/// it the ball's cosine with them is at most cos θ + sin β = width − (1 − cos θ).
SurfaceEmission::Cap SurfaceEmission::cap_towards(const CasterBounds& target) const {
    const Ball around = target.ball();
    const Vec3 between = around.centre - ball_->centre;
    const double distance = length(between), reach = around.radius + ball_->radius;
    if (shape_.glow().two_sided() || !(reach < distance)) return {{{0.0, 0.0, 1.0}}, 2.0, true};
    return {{between / distance}, 1.0 + reach / distance, false};
}

/// With v = 1 − cos θ: the density of v is 2 (width − v) / width².
double SurfaceEmission::Cap::density(double v) const {
    return alike ? pdf_uniform_cone(width) : (width - v) / (kPi * width * width);
}

Vec3 SurfaceEmission::Cap::sample(std::array<double, 2> u) const {
    const double share = alike ? u[0] : u[0] / (1.0 + std::sqrt(1.0 - u[0]));  // v / width
    return around(axis, sample_uniform_cone(width, share, u[1])).v;
}

SquarePlace SurfaceEmission::Cap::place_of(Vec3 normal) const {
    const Dir<Local> local = from_axis(axis, Dir<World>{normal});
    const double v = 1.0 - local.v.z;
    if (v > width) return {{0.5, 0.5}, 0.0};
    auto u = square_from_uniform_cone(width, local);
    if (!alike) u[0] *= 2.0 - u[0];
    return {u, density(v)};
}

/// About what a part sends to a target; 0 only if it is nothing for certain.
double SurfaceEmission::weight(int part, const CasterBounds& target) const {
    const LightBounds& bounds = shape_.bounds(part);
    if (target.endless() || bounds.normals.half_angle_rad > 0.0) return bounds.intensity;
    const Ball around = target.ball();
    const Vec3 normal = bounds.normals.axis, between = around.centre - bounds.box.centre();
    const double height = dot(between, normal);
    if (!bounds.two_sided && height + reach_along(target, normal) <= 0.0) return 0.0;
    const double d2 = std::max(dot(between, between), around.radius * around.radius);
    const double seen = bounds.two_sided ? std::abs(height) : height;
    return bounds.intensity * std::max(seen / std::sqrt(d2), kLeastCosine) / d2;
}

GlowingShape::SurfacePoint SurfaceEmission::point_of(int target, int part,
                                                     std::array<double, 2> u) const {
    if (!ball_) return shape_.point_of(part, u);
    const Cap& cap = caps_[std::size_t(target)];
    const Vec3 n = cap.sample(u);
    return {ball_->centre + n * ball_->radius, n,
            cap.density(1.0 - dot(n, cap.axis.v)) / (ball_->radius * ball_->radius)};
}

SquarePlace SurfaceEmission::place_of(int target, int part, Vec3 point) const {
    if (!ball_) return {shape_.place_of(part, point), shape_.pdf_area(part, point)};
    SquarePlace place = caps_[std::size_t(target)].place_of(normalised(point - ball_->centre));
    place.pdf /= ball_->radius * ball_->radius;
    return place;
}

std::optional<EmittedRay> SurfaceEmission::towards(int target,
                                                   const std::array<double, 4>& u) const {
    const Distribution1D::Sample choice = parts(target).sample(u[0]);
    const int part = int(choice.index);
    const auto point = point_of(target, part, {choice.offset, u[1]});
    const CasterBounds& group = groups()[std::size_t(target)];
    const auto [direction, pdf] =
        Fan(point.position, point.normal, shape_.glow().two_sided(), group).sample({u[2], u[3]});
    const double cosine = dot(direction, point.normal);
    if (cosine == 0.0 || !(pdf > 0.0) || !shape_.shines(-direction, point.normal))
        return std::nullopt;
    const double density = parts(target).probability(choice.index) * point.pdf_area * pdf;
    EmittedRay ray =
        lit({point.position, direction, {shape_.shape(), point.primitive, cosine < 0.0}},
            density / std::abs(cosine), false);
    const Glow& glow = shape_.glow();
    if (!glow.varies()) return ray;
    const SurfaceCoordinates at = shape_.coordinates(point);
    ray.factor = glow.alpha(at);
    if (ray.factor == 0.0) return std::nullopt;
    if (glow.coloured()) ray.colour = glow.colour(at);
    return ray;
}

std::optional<EmissionMap::Place> SurfaceEmission::place_towards(int target, const Ray& ray) const {
    const CasterBounds& group = groups()[std::size_t(target)];
    Hit hit;
    hit.primitive = ray.from.primitive;
    hit.normal = shape_.normal_at(ray.origin, hit.primitive);
    if (!shape_.shines(-ray.direction, hit.normal)) return std::nullopt;
    const int part = shape_.part_of(hit, ray.origin);
    const double chosen = parts(target).probability(std::size_t(part));
    const double cosine = std::abs(dot(ray.direction, hit.normal));
    if (!(chosen > 0.0) || cosine == 0.0) return std::nullopt;
    const SquarePlace point = place_of(target, part, ray.origin);
    const auto direction =
        Fan(ray.origin, hit.normal, shape_.glow().two_sided(), group).place_of(ray.direction);
    if (!direction) return std::nullopt;
    return Place{{number_of(parts(target), std::size_t(part), point.u[0]), point.u[1],
                  direction->u[0], direction->u[1]},
                 chosen * point.pdf * direction->pdf / cosine};
}

double SurfaceEmission::brightness(const EmittedRay& ray) const {
    const Glow& glow = shape_.glow();
    if (!glow.coloured()) return ray.factor * glow.brightness();
    return ray.factor * xyz_from_rgb(ray.colour)[1];
}

}  // namespace dewbow::caustics
