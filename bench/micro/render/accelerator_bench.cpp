// SPDX-License-Identifier: Apache-2.0

// The nearest hit of rays on a ball of triangles, measured again in double: rays alone and eight
// lanes together, that start as one or apart. (Embree's own share: bench_embree_share.)

#include "dewbow/render/accelerator.h"

#include <memory>

#include "ball_mesh.h"
#include "dewbow/scene/scene.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr std::size_t kRays = 1024;
constexpr int kLanes = 8;

struct World {
    Scene scene = make_empty_scene();
    std::unique_ptr<Accelerator> accelerator;
    std::vector<Ray> rays;  ///< from a sphere of radius 3 to points within the ball

    explicit World(std::uint32_t n) {
        const int black = scene.add({"black", Black{}, nullptr, false});
        scene.shapes.push_back({"ball", ball_mesh(n), Transform<dewbow::World, Object>(), black});
        accelerator = std::make_unique<Accelerator>(scene, std::vector<bool>(1, false));
        const auto z = numbers(kRays, -1.0, 1.0, 0), phi = numbers(kRays, 0.0, 6.28, 1);
        const auto x = numbers(kRays, -0.5, 0.5, 2), y = numbers(kRays, -0.5, 0.5, 3);
        for (std::size_t i = 0; i < kRays; ++i) {
            const double s = std::sqrt(1.0 - z[i] * z[i]);
            const Vec3 from{3.0 * s * std::cos(phi[i]), 3.0 * s * std::sin(phi[i]), 3.0 * z[i]};
            rays.push_back({from, normalised(Vec3{x[i], y[i], 0.0} - from), {}});
        }
    }
};

void one_ray(benchmark::State& state) {
    const World world{std::uint32_t(state.range(0))};
    for (auto _ : state)
        for (const Ray& ray : world.rays)
            benchmark::DoNotOptimize(world.accelerator->intersect(ray));
    count_items(state, kRays);
}
BENCHMARK(one_ray)->Arg(10)->Arg(100);

/// Eight lanes of one start, spread as by a prism; or eight rays that have nothing in common.
void eight_lanes(benchmark::State& state, bool apart) {
    const World world{std::uint32_t(state.range(0))};
    HitLanes hits;
    for (auto _ : state)
        for (std::size_t i = 0; i < kRays; i += kLanes) {
            RayLanes lanes;
            lanes.count = kLanes;
            for (int k = 0; k < kLanes; ++k) {
                Ray ray = world.rays[apart ? i + std::size_t(k) : i];
                if (!apart) ray.direction = normalised(ray.direction + Vec3{0.003 * k, 0.0, 0.0});
                lanes.set(k, ray);
            }
            world.accelerator->intersect(lanes, (1u << kLanes) - 1u, hits);
            benchmark::DoNotOptimize(hits);
        }
    count_items(state, kRays);
}
BENCHMARK_CAPTURE(eight_lanes, of_one_start, false)->Arg(10)->Arg(100);
BENCHMARK_CAPTURE(eight_lanes, apart, true)->Arg(10)->Arg(100);

}  // namespace
}  // namespace dewbow::bench
