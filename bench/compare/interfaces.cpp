// SPDX-License-Identifier: Apache-2.0
#include "interfaces.h"

#include <algorithm>

namespace dewbow::bench {
namespace {

/// How far from a surface its two sides are looked at. Bodies overlap by more.
constexpr double kAside_m = 1e-9;

int medium_at(const Things& things, Vec3 p) {
    Inside inside = 0;
    for (std::size_t b = 0; b < things.bodies(); ++b)
        if (things.contains(b, p)) inside |= Inside{1} << b;
    return things.medium(inside);
}

}  // namespace

std::vector<Interface> interfaces_of(const PlainScene& scene) {
    const Things things(scene);
    std::vector<Interface> interfaces;
    const auto find = [&](Vec3 p, Vec3 normal, const PlainBody& body) -> Interface* {
        const int inside = medium_at(things, p - normal * kAside_m);
        const int outside = medium_at(things, p + normal * kAside_m);
        if (inside == outside) return nullptr;
        for (Interface& known : interfaces)
            if (known.inside == inside && known.outside == outside &&
                known.surface.name == body.name)
                return &known;
        interfaces.push_back({inside, outside, {}});
        interfaces.back().surface.name = body.name;
        interfaces.back().surface.vertices = body.vertices;
        return &interfaces.back();
    };
    for (const PlainBody& body : scene.bodies) {
        if (body.sphere) {
            const Vec3 up{0, 1, 0};
            const Vec3 top = body.sphere->centre + up * body.sphere->radius;
            if (Interface* found = find(top, up, body)) found->surface.sphere = body.sphere;
        }
        for (const auto& t : body.triangles) {
            const Vec3 a = body.vertices[t[0]], b = body.vertices[t[1]], c = body.vertices[t[2]];
            const Vec3 area = cross(b - a, c - a);
            if (length(area) == 0.0) continue;
            if (Interface* found = find((a + b + c) / 3.0, normalised(area), body))
                found->surface.triangles.push_back(t);
        }
    }
    return interfaces;
}

double relative_index(const PlainScene& scene, const Interface& interface, Wavelength lambda) {
    const auto index = [&](int medium) {
        return (medium < 0 ? (*scene.surrounding_index)(lambda)
                           : (*scene.bodies[std::size_t(medium)].index)(lambda))
            .value;
    };
    return index(interface.inside) / index(interface.outside);
}

}  // namespace dewbow::bench
