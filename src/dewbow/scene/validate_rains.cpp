// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "dewbow/scene/checks.h"
#include "dewbow/scene/rain_inside.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow::checks {
namespace {

std::string text(Vec3 p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }

struct CheckRegion {
    const std::string& who;

    void operator()(const ConvexRegion& region) const {
        for (const HalfSpace& face : region.half_spaces()) {
            check_unit(who, "the normal of a face of its region", face.normal);
            if (!std::isfinite(face.offset)) fail(who, "its region lies infinitely far away");
        }
        if (const auto thickness = region.thickness();
            thickness && !(thickness->to(unit::m) > 0.0)) {
            fail(who,
                 fmt::format("its region is empty: it is {:.6g} m thick, from one face to the one "
                             "across; it must be more than 0",
                             thickness->to(unit::m)));
        }
    }
    void operator()(const MeshRegion& region) const {
        check_affine(who, region.world_from_object.affine());
        check_mesh(who, region.mesh);
        const WorldTriangles world = world_triangles(region);
        const auto open = ClosedMesh::open_edges(world.vertices, world.triangles);
        if (!open) return;
        fail(who, fmt::format("the mesh \"{}\" is open, so that nothing is inside of it: {} of its "
                              "edges belong to one triangle only (or to an odd number), the first "
                              "from {} to {}; it must be a closed surface",
                              region.mesh->name, open->count, text(open->from), text(open->to)));
    }
};

void check_drops(const std::string& who, const DropCloudPtr& drops) {
    if (!drops) fail(who, "its drops are missing");
    constexpr double kMiddle_nm = 550.0;
    double extinction = 0.0;
    drops->extinction_lanes({&kMiddle_nm, 1}, {&extinction, 1});
    if (!(extinction > 0.0)) fail(who, "it is empty: its drops dim no light");
}

/// Sunlight comes into it undimmed (docs/conventions.md): there is no loss that would end the sum
/// over orders.
bool is_endless(const Rain& rain) {
    const auto* region = std::get_if<ConvexRegion>(&rain.region);
    return region && region->half_spaces().empty();
}

void check_chaos(const std::string& who, const Chaos& chaos) {
    check_range(who, "octaves of its chaos", chaos.octaves, 1, kMostChaosOctaves);
    check_positive(who, "base frequency of its chaos", chaos.base_frequency);
    check_range(who, "lacunarity of its chaos", chaos.lacunarity, 1.1, 10.0);
    check_range(who, "exponent of its chaos", chaos.exponent, 1.0, 4.0);
    check_unit(who, "the axis of its chaos", chaos.axis);
    check_positive(who, "stretch of its chaos", chaos.stretch);
    check_range(who, "bias of its chaos", chaos.bias, -kInfinity, kInfinity);
    check_range(who, "gain of its chaos", chaos.gain, -kInfinity, kInfinity);
}

}  // namespace

void check_rains(const Scene& scene) {
    for (const Rain& rain : scene.rains) {
        const std::string who = fmt::format("rain \"{}\"", rain.name);
        std::visit(CheckRegion{who}, rain.region);
        check_drops(who, rain.drops);
        if (rain.chaos) check_chaos(who, *rain.chaos);
        if (scene.render.rain.multiple() && is_endless(rain))
            fail(who,
                 "it has no end, so that light of all orders would come from everywhere; "
                 "render.rain.orders above 1 needs a layer, a box, a curtain or a mesh");
    }
}

}  // namespace dewbow::checks
