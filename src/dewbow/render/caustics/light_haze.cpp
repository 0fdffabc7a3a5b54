// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "dewbow/render/caustics/haze_share.h"
#include "dewbow/render/caustics/light_walk.h"

namespace dewbow::caustics {

using walk::HazeLanes;
using walk::SharedPath;

/// Haze that the path shines through on its way to `hit`, as the camera sees one point of it
/// (shares: haze_share.h).
void LightWalk::on_flight(const SharedPath& path, const Hit& hit) {
    if (!in_haze(path.media) || path.scattered ||
        path.media.interior() != prepared_.camera_media.interior())
        return;
    const Ray& ray = path.ray;
    RayInterval where{0.0, hit.t};
    if (path.sees_start()) {
        if (!goes_on(prepared_, hit)) return;
        if (path.from_afar)
            where = common_part(where, prepared_.haze->ball.part(ray.origin, ray.direction));
    }
    HazeLanes haze = haze_around(path.lanes, path.media);
    const DistanceDensity density = prepared_.haze->view.density(
        ray.origin, ray.direction, where, haze.extinction.first(path.lanes.count));
    if (density.empty()) return;
    const double distance = density.sample(key_.one(flight_key(path), Purpose::haze));
    const double pdf = density.pdf(distance);
    for (int k = 0; k < path.lanes.count; ++k) {
        const double way = path.from_afar ? 0.0 : haze.extinction[k] * distance;
        haze.scattering[k] *= path.beta[k] * std::exp(-way) / pdf;
    }
    const Vec3 point = ray.origin + ray.direction * distance;
    if (in_weather(path.media)) {
        Hit there;
        there.t = distance;
        dim(flight(path, there), path.lanes, haze.scattering);
    }
    if (!prepared_.camera.disperses()) {
        splat(path, path.lanes, point, haze.scattering);
        return;
    }
    for (int k = 0; k < path.lanes.count; ++k) {
        LaneValues scattered;
        scattered[0] = haze.scattering[k];
        splat(path, LaneSet::one(packet_, path.lanes.id[std::size_t(k)]), point, scattered);
    }
}

/// Lanes that one point of the lens sees at one place. With Φ the light that the path stands for:
/// Φ σ_s p(cos θ) J, dimmed on both ways.   @param scattered  σ_s and the way to `point`, over the
/// density of the point.
void LightWalk::splat(const SharedPath& path, const LaneSet& lanes, Vec3 point,
                      const LaneValues& scattered) {
    const auto u_lens = key_.two(flight_key(path), Purpose::lens);
    std::array<Seen, 2> eyes;
    const int count = prepared_.camera.seen(point, u_lens, lanes.lambda_nm[0], eyes);
    for (const Seen& seen : std::span(eyes).first(std::size_t(count))) {
        if (prepared_.accelerator.occluded({point, seen.direction, {}}, seen.distance)) continue;
        LaneValues value;
        prepared_.media.medium(path.media.interior())
            .phase->eval_lanes(dot(path.ray.direction, seen.direction), lanes.lambdas(),
                               value.first(lanes.count));
        for (int k = 0; k < lanes.count; ++k)
            value[k] *= scattered[k] * source_[lanes.id[std::size_t(k)]] * seen.pixels_per_m2;
        absorb(shadow_way(point, seen.direction, seen.distance, flight_key(path)), lanes, value,
               path.media);
        if (prepared_.paper_fog) {  // as deep as what the camera sees behind the haze is far
            const Hit behind = prepared_.accelerator.intersect({point, -seen.direction, {}});
            look_through_fog(-seen.direction, seen.distance + behind.t, path, lanes, value);
        }
        const SplatLight light(packet_, lanes, value);
        prepared_.camera.for_each_pixel(
            seen, [&](int x, int y, double weight) { splats_.add(x, y, weight, light); });
    }
}

}  // namespace dewbow::caustics
