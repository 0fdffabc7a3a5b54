// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "dewbow/render/path/tracer.h"

namespace dewbow::path_tracing {

namespace {

/// Paths survive roulette with at least this probability.
constexpr double kLeastSurvival = 0.05;

}  // namespace

/// Whether a smooth boundary of that shape turns rays by its true normals.
bool Tracer::has_true_normals(int shape) const {
    const int id = prepared_.scene.shapes[std::size_t(shape)].material;
    return prepared_.accelerator.flat(shape) && !material(id).normal_map;
}

void Tracer::indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta) {
    const auto& before = packet_media_.index(boundary.before.interior());
    const auto& after = packet_media_.index(boundary.after.interior());
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        eta[k] = after[id] / before[id];
    }
}

/// Of the medium that a path lies in, against vacuum.
void Tracer::index_around(const LaneSet& lanes, MediaStack media, LaneValues& index) {
    const auto& here = packet_media_.index(media.interior());
    for (int k = 0; k < lanes.count; ++k) index[k] = here[std::size_t(lanes.id[std::size_t(k)])];
}

bool Tracer::dispersive(const LaneValues& eta, int count) {
    for (int k = 1; k < count; ++k)
        if (std::abs(eta[k] - eta[0]) > kSameIndex) return true;
    return false;
}

void Tracer::absorb(const LaneSet& lanes, LaneValues& beta, MediaStack media, double distance) {
    const auto* sigma = packet_media_.absorption(media.interior());
    if (!sigma) return;
    for (int k = 0; k < lanes.count; ++k)
        beta[k] *= std::exp(-(*sigma)[std::size_t(lanes.id[std::size_t(k)])] * distance);
}

void Tracer::tint(const ColourInput& tint, const Vertex& vertex, const LaneSet& lanes,
                  LaneValues& beta) {
    if (!tint) return;
    LaneValues factor;
    inputs_at(vertex).colour(tint, lanes, factor);
    for (int k = 0; k < lanes.count; ++k) beta[k] *= factor[k];
}

/// The lanes of `mask`, each where it met the surface: it arrived along its ray of `arriving`.
void Tracer::tint_open(const ColourInput& tint, OpenPath& path, LaneMask mask,
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
bool Tracer::roulette(LaneValues& beta, int count, LaneMask mask, int depth,
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

SharedPath Tracer::lane_of(const OpenPath& path, int k) const {
    const auto i = std::size_t(k);
    SharedPath lane;
    lane.ray = path.rays.ray(k);
    lane.lanes = LaneSet::one(packet_, path.lanes.id[i]);
    lane.beta[0] = path.beta[k];
    lane.media = path.media[i];
    lane.depth = path.depth;
    lane.branch = path.branch;
    lane.split = true;
    lane.from_specular = path.from_specular[i];
    lane.last_pdf = path.last_pdf[k];
    lane.last_receiver = path.last_receiver[i];
    return lane;
}

/// Memory that one thread needs for its packets, kept between samples.
struct Scratch {
    std::uint64_t serial = 0;
    std::optional<PacketMedia> media;
    RgbLanesOfPath rgb;
    std::vector<SharedPath> pending;
};

/// What `run` makes of a tracer for this sample.
template <class Run>
PixelSample with_tracer(const PreparedScene& prepared, MediaStack media,
                        const WavelengthPacket& wavelengths, const SampleKey& key, Run&& run) {
    thread_local Scratch scratch;
    if (scratch.serial != prepared.serial) {
        scratch.serial = prepared.serial;
        scratch.media.emplace(prepared.media);
    }
    scratch.media->begin(wavelengths);
    scratch.rgb.light.begin(wavelengths);
    scratch.rgb.reflectance.begin(wavelengths);
    return run(
        Tracer(prepared, wavelengths, key, media, *scratch.media, scratch.rgb, scratch.pending));
}

}  // namespace dewbow::path_tracing

namespace dewbow {

PixelSample trace_sample(const PreparedScene& prepared, const Ray& ray, MediaStack media,
                         const WavelengthPacket& wavelengths, const SampleKey& key) {
    return path_tracing::with_tracer(
        prepared, media, wavelengths, key,
        [&](path_tracing::Tracer&& tracer) { return tracer.run(ray, media); });
}

PixelSample trace_open_sample(const PreparedScene& prepared, const Ray& first, const RayLanes& rays,
                              MediaStack media, const WavelengthPacket& wavelengths,
                              const SampleKey& key) {
    return path_tracing::with_tracer(
        prepared, media, wavelengths, key,
        [&](path_tracing::Tracer&& tracer) { return tracer.run_open(first, rays, media); });
}

}  // namespace dewbow
