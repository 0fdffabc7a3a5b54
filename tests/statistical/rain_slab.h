// SPDX-License-Identifier: Apache-2.0
#pragma once

// A slab of drops in sunlight, as the renderer sees it and as photons are counted.

#include "../analytic/scene_kit.h"
#include "../analytic/welch.h"
#include "dewbow/render/path/camera_walk.h"
#include "dewbow/sky/test_drops.h"
#include "slab_of_photons.h"

namespace dewbow::kit {

inline constexpr double kSlabThickness_m = 10.0;
inline constexpr double kSlabLambda_nm = 550.0;

/// The optical depth is of the slab, straight through, at kSlabLambda_nm.
inline DropCloudPtr drops_of_slab(double optical_depth, const char* sizes, const char* model) {
    DropCloudRequest request = test_drops(optical_depth / kSlabThickness_m, sizes, model);
    request.discs = {SunDisc{}};
    return make_drop_cloud(request);
}

/// How sunlight travels that comes from that altitude, in the x-y plane.
inline Vec3 sunlight_from(double altitude_deg) {
    const double a = altitude_deg * kPi / 180.0;
    return {std::cos(a), -std::sin(a), 0.0};
}

/// The slab lies between y = 0 and kSlabThickness_m, and everything else is black.
inline Scene slab_scene(DropCloudPtr drops, Vec3 sunlight, int orders) {
    Scene scene = empty_scene();
    scene.rains.push_back(
        {"slab", ConvexRegion::layer(0.0 * m, kSlabThickness_m * m), std::move(drops), {}});
    scene.lights.push_back(DistantLight{{sunlight}, kSunRadius, make_constant(1.0)});
    scene.render.rain.orders = orders;
    return scene;
}

/// One list of values for each ring: ∫ L |cos| dω over it, as count_photons() has it.
using RingValues = std::vector<std::vector<double>>;

/// By camera rays of one kind from outside of the slab; `replicates` values of `samples` rays each.
template <class Walk = walk::CameraWalk>
RingValues rendered_rings(const Scene& scene, Vec3 sunlight, const std::vector<Ring>& rings,
                          std::size_t replicates, std::size_t samples, std::uint64_t seed) {
    constexpr int kPacket = 8, kLane = 4;
    const PreparedScene prepared(scene);
    const WavelengthPacket lanes = among_others(kSlabLambda_nm, kPacket, kLane);
    RingValues values(rings.size(), std::vector<double>(replicates));
    for (std::size_t r = 0; r < rings.size(); ++r)
        parallel_for(replicates, [&](std::size_t j) {
            const Ring& ring = rings[r];
            double sum = 0.0;
            for (std::size_t i = 0; i < samples; ++i) {
                const SampleKey key = independent_key(seed, (r * replicates + j) * samples + i);
                const auto u = test_numbers(key, 0);
                const double inner = Ring::cosine(ring.inner_deg);
                const Vec3 along =
                    turned(sunlight, inner + u[0] * (Ring::cosine(ring.outer_deg) - inner),
                           2.0 * kPi * u[1]);
                // Through the lit face one looks down.
                if ((along.y < 0.0) != ring.lit_face) continue;
                const double height = ring.lit_face ? kSlabThickness_m + 1.0 : -1.0;
                const PixelSample sample =
                    Walk(prepared, nullptr, lanes, key, {}).run({{0.0, height, 0.0}, along, {}});
                sum += sample.radiance[kLane] * std::abs(along.y);
            }
            values[r][j] = sum / double(samples) * ring.solid_angle();
        });
    return values;
}

/// [replicate][ring]
using CountedRings = std::vector<std::vector<RingLight>>;
inline CountedRings counted_rings(const PhotonSlab& slab, const std::vector<Ring>& rings,
                                  std::size_t replicates, std::size_t photons, std::uint64_t seed) {
    CountedRings counted(replicates);
    parallel_for(replicates, [&](std::size_t j) {
        counted[j] = count_photons(slab, rings, photons, seed + j);
    });
    return counted;
}
/// Of the orders [first, end), counted from 0 for light that is scattered once.
inline RingValues of_orders(const CountedRings& counted, std::size_t first, std::size_t end) {
    RingValues values(counted.front().size());
    for (std::size_t r = 0; r < values.size(); ++r)
        for (const std::vector<RingLight>& rings : counted) {
            double sum = 0.0;
            for (std::size_t order = first; order < end; ++order) sum += rings[r][order];
            values[r].push_back(sum);
        }
    return values;
}

/// Albedo and scattering angles of drops at kSlabLambda_nm, as photons need them.
inline double albedo_of(const DropCloud& drops) {
    double albedo = 0.0;
    drops.albedo_lanes({&kSlabLambda_nm, 1}, {&albedo, 1});
    return albedo;
}
inline ScatteringAngles angles_of(const DropCloud& drops) {
    return ScatteringAngles([phase = drops.phase()](double cosine) {
        double per_sr = 0.0;
        phase->eval_lanes(cosine, {&kSlabLambda_nm, 1}, {&per_sr, 1});
        return per_sr;
    });
}

}  // namespace dewbow::kit
