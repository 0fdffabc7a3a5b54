// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes with rain, and what their light is by plain quadrature of
//     L = Σ E ϖ p(θ) ∫ V(s) e^(−τ_sun(s)) e^(−τ(s)) dτ(s)
// in small steps, asking at each point how dense the rain there is.

#include <functional>
#include <map>

#include "dewbow/sky/drop_cloud.h"
#include "scene_kit.h"
#include "statistics.h"

namespace dewbow::kit {

inline constexpr Angle kSunDisc = 0.2666 * unit::deg;

/// Large drops by geometrical optics; the table of each density is made once.
inline DropCloudPtr drops(double per_m) {
    static std::map<double, DropCloudPtr> made;
    DropCloudPtr& cloud = made[per_m];
    if (cloud) return cloud;
    DropCloudRequest request;
    request.model = "descartes";
    request.showers = {parse_drop_sizes("0.5mm")};
    request.optics = {make_dispersion(find_glass("water@20C").data), vacuum(), 0.0};
    request.amount = RainExtinction{per_m};
    request.discs = {{kSunDisc, 0.0}};
    return cloud = make_drop_cloud(request);
}

inline Rain rain_in_box(DropCloudPtr drops, Vec3 centre, Vec3 half) {
    return {"box", ConvexRegion::box(Transform<World, Object>(translation(centre)), half),
            std::move(drops), std::nullopt};
}

/// Towards a sun at that altitude behind someone who looks along −z.
inline Vec3 towards_sun(double altitude_deg) {
    const double h = altitude_deg * kPi / 180.0;
    return {0.0, std::sin(h), std::cos(h)};
}
inline constexpr double kSunIrradiance = 3.0;
inline Scene sunny_scene(double altitude_deg) {
    Scene scene = empty_scene(16);
    scene.lights.push_back(
        DistantLight{{-towards_sun(altitude_deg)}, kSunDisc, make_constant(kSunIrradiance)});
    return scene;
}
/// From the origin, at `angle_deg` from the antisolar point, straight above it.
inline Ray ray_above_antisolar(double altitude_deg, double angle_deg) {
    const double a = (angle_deg - altitude_deg) * kPi / 180.0;
    return {{0, 0, 0}, {0.0, std::sin(a), -std::cos(a)}, {}};
}

struct RainQuadrature {
    const Scene& scene;
    Vec3 sun;
    double step_m;
    std::function<bool(Vec3)> lit = [](Vec3) { return true; };

    double density(std::size_t i, Vec3 p) const {
        const Rain& rain = scene.rains[i];
        if (!std::get<ConvexRegion>(rain.region).contains({p})) return 0.0;
        return rain.chaos ? chaos_density(p, *rain.chaos) : 1.0;
    }
    static double extinction(const Rain& rain, double lambda_nm) {
        double value;
        rain.drops->extinction_lanes({&lambda_nm, 1}, {&value, 1});
        return value;
    }
    /// Optical depth of all rains from `from` along `direction`, by midpoints.
    double depth(Vec3 from, Vec3 direction, double length, double lambda_nm) const {
        double sum = 0.0;
        const int steps = int(std::ceil(length / step_m));
        for (std::size_t i = 0; i < scene.rains.size(); ++i) {
            double metres = 0.0;
            for (int k = 0; k < steps; ++k)
                metres +=
                    density(i, from + direction * ((k + 0.5) * length / steps)) * length / steps;
            sum += metres * extinction(scene.rains[i], lambda_nm);
        }
        return sum;
    }
    /// What the sun's light comes to along `ray`; rains reach no further than `reach` from any
    /// point of it.
    double sunlight(const Ray& ray, double length, double reach, double lambda_nm) const {
        const std::size_t rains = scene.rains.size();
        const double cosine = dot(ray.direction, sun);
        std::vector<double> per_m(rains), source(rains);
        for (std::size_t i = 0; i < rains; ++i) {
            const DropCloud& cloud = *scene.rains[i].drops;
            double albedo;
            Intensities phase;
            cloud.albedo_lanes({&lambda_nm, 1}, {&albedo, 1});
            cloud.phase_lanes(cosine, cloud.disc_of({kSunDisc, 0.0}), {&lambda_nm, 1}, {&phase, 1});
            per_m[i] = extinction(scene.rains[i], lambda_nm);
            source[i] = per_m[i] * albedo * 0.5 * (phase.perpendicular + phase.parallel);
        }
        const int steps = int(std::ceil(length / step_m));
        const double ds = length / steps;
        double tau = 0.0, sum = 0.0;
        for (int k = 0; k < steps; ++k) {
            const Vec3 p = ray.origin + ray.direction * ((k + 0.5) * ds);
            double here = 0.0, scattered = 0.0;
            for (std::size_t i = 0; i < rains; ++i) {
                const double d = density(i, p);
                here += d * per_m[i], scattered += d * source[i];
            }
            if (scattered > 0.0 && lit(p))
                sum += scattered *
                       std::exp(-tau - 0.5 * here * ds - depth(p, sun, reach, lambda_nm)) * ds;
            tau += here * ds;
        }
        return kSunIrradiance * sum;
    }
};

/// Statistics of radiance along a ray over `expected(lambda)`, less 1, of four lanes' mean.
template <class Expected>
MeanSums rain_difference(const Scene& scene, const Ray& ray, std::size_t samples,
                         Expected&& expected) {
    const PreparedScene prepared(scene);
    constexpr int kLanes = 4;
    const WavelengthPacket packet = among_others(400.0, kLanes, 0);
    std::array<double, kLanes> mean;
    for (std::size_t k = 0; k < kLanes; ++k) mean[k] = expected(packet.lambda_nm[k]);
    MeanSums sums;
    for (std::size_t i = 0; i < samples; ++i) {
        const PixelSample sample =
            trace_sample(prepared, ray, MediaStack{}, packet, independent_key(7, i));
        double difference = 0.0;
        for (std::size_t k = 0; k < kLanes; ++k) difference += sample.radiance[k] / mean[k] - 1.0;
        sums.add(difference / kLanes);
    }
    return sums;
}

}  // namespace dewbow::kit
