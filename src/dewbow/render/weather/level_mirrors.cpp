// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/level_mirrors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace dewbow {
namespace {

/// Sine of the tilt from which on a surface is not level: 0.2 seconds of arc, so that the sun's
/// image is off by a thousandth of its disc.
constexpr double kLevel = 1e-6;

/// Facets of one surface lie as high but for rounding.
constexpr double kSameHeight = 1e-9;

struct Mirrors {
    bool operator()(const Mirror& s) const { return !s.reflectance.varies(); }
    bool operator()(const Dielectric& s) const { return s.roughness == 0.0; }
    bool operator()(const Conductor& s) const { return s.roughness == 0.0; }
    bool operator()(const auto&) const { return false; }
};

bool level(Vec3 normal) { return std::hypot(normal.x, normal.z) < kLevel * std::abs(normal.y); }

/// Adds the level sides of shapes: height → area in m².
struct AddLevelSides {
    const Transform<World, Object>& world_from_object;
    std::map<double, double>& area;

    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        for (const auto& t : mesh->triangles) {
            const Vec3 a = place(mesh->vertices[t[0]].v), b = place(mesh->vertices[t[1]].v);
            const Vec3 face = 0.5 * cross(b - a, place(mesh->vertices[t[2]].v) - a);
            if (face.y > 0.0) add(face, a.y);
        }
    }
    void operator()(const Plane&) const {
        if (level(direction({0, 0, 1})))
            area[place({}).y] = std::numeric_limits<double>::infinity();
    }
    void operator()(const Rectangle& s) const { flat(s.width.to(unit::m), s.height.to(unit::m)); }
    void operator()(const Disc& s) const {
        const double side = std::sqrt(std::numbers::pi) * s.radius.to(unit::m);
        flat(side, side);
    }
    void operator()(const Box& s) const {
        const Vec3 half =
            0.5 * Vec3{s.width.to(unit::m), s.height.to(unit::m), s.depth.to(unit::m)};
        const Vec3 edges[] = {linear({2 * half.x, 0, 0}), linear({0, 2 * half.y, 0}),
                              linear({0, 0, 2 * half.z})};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vec3 face = cross(edges[(axis + 1) % 3], edges[(axis + 2) % 3]);
            add(face, place({}).y + 0.5 * std::abs(edges[axis].y));
        }
    }
    void operator()(const Sphere&) const {}
    void operator()(const Prism&) const {}

private:
    Vec3 place(Vec3 p) const { return world_from_object(Point<Object>{p}).v; }
    Vec3 linear(Vec3 v) const { return world_from_object(Dir<Object>{v}).v; }
    Vec3 direction(Vec3 n) const { return world_from_object(Normal<Object>{n}).v; }
    void add(Vec3 face, double height) const {
        if (level(face)) area[height] += length(face);
    }
    void flat(double width, double height) const {
        add(cross(linear({width, 0, 0}), linear({0, height, 0})), place({}).y);
    }
};

struct EvalMirror {
    int interior;
    double cosine;
    const LaneSet& lanes;
    PacketMedia& media;
    ReflectanceLanes& out;

    void operator()(const Mirror& s) const {
        LaneValues reflectance;
        s.reflectance.spectrum->eval_lanes(lanes.lambdas(), reflectance.first(lanes.count));
        for (int k = 0; k < lanes.count; ++k) set(k, {reflectance[k], reflectance[k]});
    }
    void operator()(const Dielectric&) const {
        for (int k = 0; k < lanes.count; ++k)
            set(k, fresnel_dielectric(cosine, index_of(interior, k) / index_of(0, k)));
    }
    void operator()(const Conductor& s) const {
        LaneValues n, absorption;
        s.n->eval_lanes(lanes.lambdas(), n.first(lanes.count));
        s.k->eval_lanes(lanes.lambdas(), absorption.first(lanes.count));
        for (int k = 0; k < lanes.count; ++k) {
            const std::complex<double> index(n[k], absorption[k]);
            set(k, fresnel_conductor(cosine, index / index_of(0, k)));
        }
    }
    void operator()(const auto&) const {
        for (int k = 0; k < lanes.count; ++k) set(k, {0.0, 0.0});
    }

private:
    double index_of(int id, int k) const {
        return media.index(id)[std::size_t(lanes.id[std::size_t(k)])];
    }
    void set(int k, Reflectance<double> r) const { out[std::size_t(k)] = r; }
};

}  // namespace

bool mirrors(const Material& material) {
    return !material.normal_map && std::visit(Mirrors{}, material.surface);
}

std::vector<double> level_mirrors(const Scene& scene) {
    std::map<double, double> area;
    for (const Shape& shape : scene.shapes) {
        if (!mirrors(scene.materials[std::size_t(shape.material)])) continue;
        std::visit(AddLevelSides{shape.world_from_object, area}, shape.geometry);
    }
    std::vector<std::pair<double, double>> found;
    for (const auto& [height, size] : area) {
        if (!found.empty() &&
            height - found.back().first < kSameHeight * (1.0 + std::abs(height))) {
            found.back().second += size;
        } else {
            found.emplace_back(height, size);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    if (found.size() > kMostLevelMirrors) found.resize(kMostLevelMirrors);
    std::vector<double> heights;
    for (const auto& [height, size] : found) heights.push_back(height);
    return heights;
}

void eval_mirror(const Material& material, int interior, double cosine, const LaneSet& lanes,
                 PacketMedia& media, ReflectanceLanes& out) {
    std::visit(EvalMirror{interior, cosine, lanes, media, out}, material.surface);
}

}  // namespace dewbow
