// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/path/camera_walk.h"

namespace dewbow::walk {

CameraWalk::CameraWalk(const PreparedScene& prepared, const WavelengthPacket& packet,
                       const SampleKey& key, MediaStack start)
    : PacketWalk(prepared, packet, key), start_(start) {
    result_.wavelengths = packet;
}

PixelSample CameraWalk::run(const Ray& ray) {
    follow(shared_start(ray, start_));
    return result_;
}

PixelSample CameraWalk::run_open(const Ray& first, const RayLanes& rays) {
    const Hit hit = prepared_.accelerator.intersect(first);
    if (hit && settings_.max_depth > 0)
        see_first(prepared_, vertex_at(first, hit), material_at(first, hit, vertex_key(0, 0)),
                  result_);
    follow(open_start(rays, start_));
    return result_;
}

void CameraWalk::on_surface(const SharedPath& path, const Vertex& vertex, int material) {
    if (!result_.hit && path.depth == 0 && path.branch == 0)
        see_first(prepared_, vertex, material, result_);
}

/// The first choice of lanes that opened where the camera looks is stratified with the place and
/// the wavelength, since what is seen depends on all of them together; at depth 1 a sample has no
/// other open lanes.
double CameraWalk::choice_of_lanes(const OpenPath& path) const {
    return path.depth == 1 ? key_.fourth(0, Purpose::pixel_filter)
                           : PacketWalk::choice_of_lanes(path);
}

}  // namespace dewbow::walk
