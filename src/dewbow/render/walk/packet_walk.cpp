// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::walk {

namespace {

/// Paths survive roulette with at least this probability.
constexpr double kLeastSurvival = 0.05;

}  // namespace

PacketWalk::PacketWalk(Start start, const PreparedScene& prepared, const WavelengthPacket& packet,
                       const SampleKey& key)
    : prepared_(prepared),
      settings_(prepared.scene.render),
      packet_(packet),
      key_(key),
      start_(start),
      memory_(walk_memory(prepared, packet)) {}

/// Whether a smooth boundary of that shape turns rays by its true normals.
bool PacketWalk::has_true_normals(int shape) const {
    const int id = prepared_.scene.shapes[std::size_t(shape)].material;
    return prepared_.accelerator.flat(shape) && !material(id).normal_map;
}

/// What light that goes along the path gets where a shading normal turns it to `next`: surfaces
/// send radiance on by cosines to the shading normal, but light falls on them by true ones.
///     |wo·Ns| |next·Ng| / (|wo·Ng| |next·Ns|)                            [Veach 1997, eq. 5.19]
double PacketWalk::shading_factor(const Vertex& vertex, Vec3 shading, Vec3 next) const {
    if (start_ == Start::camera || has_true_normals(vertex.shape)) return 1.0;
    return std::abs(dot(vertex.wo, shading) * dot(next, vertex.geometric) /
                    (dot(vertex.wo, vertex.geometric) * dot(next, shading)));
}

void PacketWalk::indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta) {
    const auto& before = packet_media().index(boundary.before.interior());
    const auto& after = packet_media().index(boundary.after.interior());
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        eta[k] = after[id] / before[id];
    }
}

/// Of the medium that a path lies in, against vacuum.
void PacketWalk::index_around(const LaneSet& lanes, MediaStack media, LaneValues& index) {
    const auto& here = packet_media().index(media.interior());
    for (int k = 0; k < lanes.count; ++k) index[k] = here[std::size_t(lanes.id[std::size_t(k)])];
}

bool PacketWalk::dispersive(const LaneValues& eta, int count) {
    for (int k = 1; k < count; ++k)
        if (std::abs(eta[k] - eta[0]) > kSameIndex) return true;
    return false;
}

/// Of the medium that a path lies in, which scatters.
HazeLanes PacketWalk::haze_around(const LaneSet& lanes, MediaStack media) {
    const auto& scattering = *packet_media().scattering(media.interior());
    const auto& extinction = *packet_media().extinction(media.interior());
    HazeLanes haze;
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        haze.scattering[k] = scattering[id], haze.extinction[k] = extinction[id];
    }
    return haze;
}

Way PacketWalk::flight(const SharedPath& path, const Hit& hit) {
    const Ray& ray = path.ray;
    if (!path.from_afar)
        return {ray.origin,       ray.direction,           hit.t,
                flight_key(path), Purpose::rain_on_flight, !path.scattered};
    return {ray.origin + ray.direction * hit.t, -ray.direction,
            std::numeric_limits<double>::infinity(), flight_key(path), Purpose::rain_on_flight};
}

void PacketWalk::absorb(const Way& way, const LaneSet& lanes, LaneValues& beta, MediaStack media) {
    const auto* sigma = packet_media().extinction(media.interior());
    if (sigma && std::isfinite(way.length))
        for (int k = 0; k < lanes.count; ++k)
            beta[k] *= std::exp(-(*sigma)[std::size_t(lanes.id[std::size_t(k)])] * way.length);
    if (in_weather(media)) dim(way, lanes, beta);
}

void PacketWalk::dim(const Way& way, const LaneSet& lanes, LaneValues& beta) {
    prepared_.weather->dim(way, memory_.weather, lanes, key_, beta);
}

void PacketWalk::tint(const ColourInput& tint, const Vertex& vertex, const LaneSet& lanes,
                      LaneValues& beta) {
    if (!tint) return;
    LaneValues factor;
    inputs_at(vertex).colour(tint, lanes, factor);
    for (int k = 0; k < lanes.count; ++k) beta[k] *= factor[k];
}

/// The lanes of `mask`, each where it met the surface: it arrived along its ray of `arriving`.
void PacketWalk::tint_open(const ColourInput& tint, OpenPath& path, LaneMask mask,
                           const RayLanes& arriving, const HitLanes& hits) {
    if (!tint) return;
    LaneValues factor;
    if (!tint.varies()) inputs_at({}).colour(tint, path.lanes, factor);
    for (LaneMask rest = mask; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        if (tint.varies()) {
            const LaneSet lane = LaneSet::one(packet_, path.lanes.id[std::size_t(k)]);
            LaneValues value;
            inputs_at(vertex_at(arriving.ray(k), hits[std::size_t(k)])).colour(tint, lane, value);
            factor[k] = value[0];
        }
        path.beta[k] *= factor[k];
    }
}

/// Russian roulette on the lanes in `mask`, all together. False: the path ends.
bool PacketWalk::roulette(LaneValues& beta, int count, LaneMask mask, int depth,
                          std::uint32_t vertex) const {
    if (depth < settings_.roulette_depth || settings_.roulette_depth >= settings_.max_depth)
        return true;
    double most = 0.0;
    for (int k = 0; k < count; ++k)
        if (mask >> k & 1u) most = std::max(most, beta[k]);
    if (most >= 1.0) return true;
    const double survival = std::max(most, kLeastSurvival);
    if (key_.one(vertex, Purpose::roulette) >= survival) return false;
    for (int k = 0; k < count; ++k) beta[k] /= survival;
    return true;
}

SharedPath PacketWalk::lane_of(const OpenPath& path, int k) const {
    const auto i = std::size_t(k);
    SharedPath lane;
    lane.ray = path.rays.ray(k);
    lane.lanes = LaneSet::one(packet_, path.lanes.id[i]);
    lane.beta[0] = path.beta[k];
    lane.media = path.media[i];
    lane.depth = path.depth;
    lane.branch = path.branch;
    lane.scattered = path.scattered;
    lane.in_rain = true;
    lane.drops = path.drops;
    lane.split = true;
    lane.hidden = path.hidden >> k & 1u;
    lane.last = path.last[i];
    lane.note = path.note[k];
    return lane;
}

WalkMemory& walk_memory(const PreparedScene& prepared, const WavelengthPacket& packet) {
    thread_local WalkMemory memory;
    if (memory.serial != prepared.serial) {
        memory.serial = prepared.serial;
        memory.media.emplace(prepared.media);
    }
    memory.media->begin(packet);
    if (prepared.weather)
        memory.weather.begin(prepared.weather->rains(), prepared.weather->suns(), packet);
    memory.light.begin(packet);
    memory.reflectance.begin(packet);
    memory.pending.clear();
    return memory;
}

}  // namespace dewbow::walk
