// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/mirrored_sun.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dewbow/render/prepared_scene.h"
#include "dewbow/render/vertex.h"
#include "dewbow/sky/mirrored_way.h"

namespace dewbow {
namespace {

/// Heights agree but for the rounding of a distance and of a tilt that counts as level.
constexpr double kSameHeight = 1e-6;
/// Surfaces that shadow rays go through, passed at one go before light is given up.
constexpr int kMostPassed = 64;

double squared(double x) { return x * x; }

/// The nearest thing along `ray` that shadow rays do not go through.
Hit nearest(const PreparedScene& prepared, Ray& ray) {
    for (int passed = 0; passed < kMostPassed; ++passed) {
        const Hit hit = prepared.accelerator.intersect(ray);
        if (!hit || !prepared.see_through[std::size_t(hit.shape)]) return hit;
        ray = vertex_at(prepared, ray, hit).leave(ray.direction);
    }
    return {};
}

}  // namespace

std::optional<LineInterval> MirroredSun::above(Point<World> origin, Dir<World> direction,
                                               LineInterval on) const {
    const auto part = ConvexRegion().above(height_m_).cut(origin, direction, on.end);
    if (!part) return std::nullopt;
    const LineInterval both{std::max(part->begin, on.begin), part->end};
    if (!(both.begin < both.end)) return std::nullopt;
    return both;
}

void MirroredSun::lengths(const RainInside& rain, Point<World> origin, Dir<World> direction,
                          LineInterval on, std::vector<LengthPiece>& pieces) const {
    const Dir<World> image = this->direction();
    std::vector<LengthPiece> up, down;
    rain.lengths_down_to(height_m_, origin, direction, on, image, up);
    const LineOnPlane mirror(height_m_, origin, direction, image);
    mirror.lengths(
        [&](Point<World> o, Dir<World> d, LineInterval part, std::vector<LengthPiece>& out) {
            rain.lengths_towards(o, d, part, to_sun_, out);
        },
        on, down);
    drop_endless(down);
    const std::vector<LengthPiece> sum = sum_of(up, down);
    pieces.insert(pieces.end(), sum.begin(), sum.end());
}

std::optional<ReflectanceLanes> MirroredSun::reflect(const PreparedScene& prepared,
                                                     Point<World> point, Dir<World> to_sun,
                                                     const SampleKey& key, std::uint32_t vertex,
                                                     const LaneSet& lanes,
                                                     PacketMedia& media) const {
    Ray ray{point.v, image_of(to_sun).v, {}};
    const Hit hit = nearest(prepared, ray);
    if (!hit) return std::nullopt;
    const Vertex mirror = vertex_at(prepared, ray, hit);
    const double off = std::abs(mirror.position.y - height_m_);
    if (off > kSameHeight * (1.0 + hit.t) || mirror.shading.y < 1.0 - squared(kSameHeight))
        return std::nullopt;
    const int id = material_at(prepared, ray, hit, key, vertex);
    const Material& material = prepared.scene.materials[std::size_t(id)];
    const int interior = prepared.media.interior_of(id);
    if (!mirrors(material) || (interior >= 0 && !mirror.front)) return std::nullopt;
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    if (prepared.accelerator.occluded(mirror.leave(to_sun.v), kEndless)) return std::nullopt;
    ReflectanceLanes shares;
    eval_mirror(material, interior, to_sun.v.y, lanes, media, shares);
    return shares;
}

Reflectance<double> MirroredSun::turned(Reflectance<double> mirror, Dir<World> towards_eye) const {
    const Vec3 along_mirror{to_sun_.v.z, 0.0, -to_sun_.v.x};  // level, across the light's way
    const Vec3 across = cross(direction().v, towards_eye.v);  // of the plane of scattering
    const double sizes = dot(along_mirror, along_mirror) * dot(across, across);
    // Straight on or back, or a sun in the zenith: one of the two planes is any.
    const double same = sizes > 0.0 ? squared(dot(along_mirror, across)) / sizes : 0.5;
    return {.parallel = mirror.parallel * same + mirror.perpendicular * (1.0 - same),
            .perpendicular = mirror.perpendicular * same + mirror.parallel * (1.0 - same)};
}

}  // namespace dewbow
