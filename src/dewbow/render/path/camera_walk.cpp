// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

CameraWalk::CameraWalk(const PreparedScene& prepared, const caustics::LightPaths* light_paths,
                       const WavelengthPacket& packet, const SampleKey& key, MediaStack start)
    : PacketWalk(Start::camera, prepared, packet, key), light_paths_(light_paths), start_(start) {
    result_.wavelengths = packet;
}

PixelSample CameraWalk::run(const Ray& ray) {
    eye_ = ray.origin;
    follow(shared_start(ray, start_));
    return behind_polariser();
}

PixelSample CameraWalk::run_open(const Ray& first, const RayLanes& rays) {
    const Hit hit = prepared_.accelerator.intersect(first);
    if (hit && settings_.max_depth > 0)
        see_first(prepared_, vertex_at(first, hit), material_at(first, hit, vertex_key(0, 0)),
                  result_);
    eye_ = rays.origin(0);
    follow(open_start(rays, start_));
    return behind_polariser();
}

/// What is not seen of bows themselves (sun_in_rain) counts as light without polarisation.
PixelSample CameraWalk::behind_polariser() {
    if (prepared_.camera.polariser())
        for (double& radiance : result_.radiance) radiance *= kPolariserShare;
    return result_;
}

void CameraWalk::on_surface(const SharedPath& path, const Vertex& vertex, int material) {
    if (!result_.hit && path.depth == 0 && path.branch == 0)
        see_first(prepared_, vertex, material, result_);
}

void CameraWalk::on_flight(const SharedPath& path, const Hit& hit) {
    if (in_haze(path.media)) light_in_haze(path, hit);
    if (!in_weather(path.media)) return;
    if (!prepared_.weather->rains().empty()) light_in_rain(path, hit);
    if (prepared_.weather->has_air()) light_of_air(path, hit);
}

/// Light paths come where the camera sees what scatters.
void CameraWalk::on_scattered(SharedPath& path, const Scatterer& at, Vec3 wi) {
    if (!light_paths_ || !path.sees_start()) return;
    const Vertex& y1 = at.vertex;
    path.note = caustics::light_ratio(
        *light_paths_, std::abs(dot(path.ray.direction, y1.geometric)),
        std::abs(dot(y1.wo, y1.geometric)), prepared_.camera.pixels_per_m2(eye_, y1.position),
        at.surface.typical_density(wi));
}

/// The first choice of lanes that opened where the camera looks is stratified with the place and
/// the wavelength, since what is seen depends on all of them together; at depth 1 a sample has no
/// other open lanes.
double CameraWalk::choice_of_lanes(const OpenPath& path) const {
    return path.depth == 1 ? key_.fourth(0, Purpose::pixel_filter)
                           : PacketWalk::choice_of_lanes(path);
}

}  // namespace dewbow::walk
