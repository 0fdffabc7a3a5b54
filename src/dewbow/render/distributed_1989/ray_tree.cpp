// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/ray_tree.h"

#include <cmath>

namespace dewbow::distributed_1989 {

namespace {

PacketMedia media_at_nm(const MediaTable& table, double lambda_nm) {
    PacketMedia media(table);
    media.begin(packet_of_one(lambda_nm));
    return media;
}

}  // namespace

WavelengthPacket packet_of_one(double lambda_nm) {
    WavelengthPacket packet;
    packet.count = 1;
    packet.lambda_nm[0] = lambda_nm;
    return packet;
}

Workspace::Workspace(const Method& method)
    : serial(method.prepared().serial),
      white{true, method.make_white_bands(), media_at_nm(method.prepared().media, kNominal_nm)},
      sample{false, method.make_sample_bands(), PacketMedia(method.prepared().media)},
      offsets(method.sampling().offset_count()),
      samples(std::size_t(method.sampling().sampling().samples)) {}

PixelSample RayTree::grow(int x, int y) {
    const CameraRays& camera = prepared_.camera;
    const Ray ray = camera.ray(x, y, key_);
    return camera.disperses() ? through_lens(x, y, ray) : grow(ray, prepared_.camera_media);
}

PixelSample RayTree::grow(const Ray& ray, MediaStack media) {
    const BandValues all(workspace_.white.bands.count(), 1.0);
    return finish(follow({ray, media, all}, workspace_.white));
}

PixelSample RayTree::finish(MonitorRgb sum) {
    result_.colour = method_.xyz(sum);
    return result_;
}

/// Behind a lens with dispersion a ray is split from the start; `first` is what the layers see.
PixelSample RayTree::through_lens(int x, int y, const Ray& first) {
    const Hit hit = prepared_.accelerator.intersect(first);
    if (hit && prepared_.scene.render.max_depth > 0)
        see_first(prepared_, vertex_at(prepared_, first, hit),
                  material_at(prepared_, first, hit, key_, 0), result_);
    draw_samples(0);
    MonitorRgb total;
    for (const SpectralSample& sample : workspace_.samples) {
        start_sample(sample);
        const std::array<double, 1> lambda_nm{method_.index_nm(sample)};
        const RayLanes rays = prepared_.camera.rays(x, y, key_, lambda_nm);
        const BandValues beta(workspace_.sample.bands.count(), 1.0);
        total = total + follow({rays.ray(0), prepared_.camera_media, beta, 0, ++branches_},
                               workspace_.sample);
    }
    return finish(limited(total, {{1.0, 1.0, 1.0}}));
}

/// What `first` and all rays that it becomes bring home.
MonitorRgb RayTree::follow(const TracedRay& first, RayFamily& family) {
    MonitorRgb sum;
    trace(first, family, sum);
    while (!family.pending.empty()) {
        const TracedRay next = family.pending.back();
        family.pending.pop_back();
        trace(next, family, sum);
    }
    return sum;
}

void RayTree::trace(TracedRay ray, RayFamily& family, MonitorRgb& sum) {
    for (;;) {
        const Hit hit = prepared_.accelerator.intersect(ray.ray);
        if (prepared_.paper_fog && ray.media.interior() == 0)
            look_through_fog(ray, family, hit, sum);
        if (!hit) {
            if (ray.sees_lamps) add_infinite(ray, family, sum);
            return;
        }
        absorb(family, ray.beta, ray.media, hit.t);
        if (ray.sees_lamps && prepared_.lights.emits(hit, ray.ray.direction))
            add_lamp(ray, family, hit, sum);
        const int depth = ray.depth;
        if (depth >= prepared_.scene.render.max_depth) return;
        const Vertex vertex = vertex_at(prepared_, ray.ray, hit);
        const std::uint32_t at = vertex_key(ray) + std::uint32_t(ray.passed) * 0x85ebca6bu;
        const int id = material_at(prepared_, ray.ray, hit, key_, at);
        if (!result_.hit && family.white && depth == 0) see_first(prepared_, vertex, id, result_);
        if (!interact({ray, family, vertex, sum}, prepared_.scene.materials[std::size_t(id)],
                      prepared_.media.interior_of(id)))
            return;
        // A surface that is none costs no depth.
        if (ray.depth == depth) continue;
        ray.passed = 0;
        if (too_weak(ray.beta)) return;
    }
}

/// Takes the ray past one surface, and leaves others that come of it in family.pending. False: it
/// ends here.   @param interior  the medium within, if any.
bool RayTree::interact(const Meeting& at, const Material& material, int interior) {
    if (const auto* glass = std::get_if<Dielectric>(&material.surface))
        return this->glass(at, *glass, interior);
    if (ScatteringSurface::holds(material)) return scatter(at, material);
    if (const auto* mirror = std::get_if<Mirror>(&material.surface)) {
        tint(at.family, mirror->reflectance, at.vertex, at.ray.beta);
        return reflect(at);
    }
    if (const auto* conductor = std::get_if<Conductor>(&material.surface))
        return metal(at, *conductor);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return this->pane(at, *pane);
    return false;
}

/// As a mirror does.
bool RayTree::reflect(const Meeting& at) const {
    const Vec3 direction = reflected(at.vertex.wo, mirror_normal(at.vertex));
    at.ray.ray = at.vertex.leave(normalised(direction));
    at.ray.sees_lamps = true;
    ++at.ray.depth;
    return true;
}

bool RayTree::metal(const Meeting& at, const Conductor& conductor) const {
    const double cosine = std::min(1.0, dot(at.vertex.wo, mirror_normal(at.vertex)));
    for (BandBlock& block : at.family.bands.blocks()) {
        LaneValues reflectance;
        const LaneValues outside = block.indices(at.ray.media.interior());
        ConductorFresnel(conductor, block.lanes, outside).at(cosine, reflectance);
        for (int k = 0; k < block.lanes.count; ++k) at.ray.beta[block.first + k] *= reflectance[k];
    }
    return reflect(at);
}

/// Both ways; what goes through is not bent.
bool RayTree::pane(const Meeting& at, const ThinDielectric& pane) {
    TracedRay through = at.ray;
    for (BandBlock& block : at.family.bands.blocks()) {
        LaneValues index;
        pane.index->eval_lanes(block.lanes.lambdas(), index.first(block.lanes.count));
        const LaneValues outside = block.indices(at.ray.media.interior());
        for (int k = 0; k < block.lanes.count; ++k) {
            const double r =
                pane_reflectance(dot(at.vertex.wo, at.vertex.shading), index[k] / outside[k]);
            at.ray.beta[block.first + k] *= r;
            through.beta[block.first + k] *= 1.0 - r;
        }
    }
    tint(at.family, pane.tint, at.vertex, through.beta);
    through.ray = at.vertex.leave(-at.vertex.wo);
    through.branch = ++branches_;
    through.passed = 0;
    through.sees_lamps = true;
    ++through.depth;
    if (!too_weak(through.beta)) at.family.pending.push_back(through);
    return reflect(at);
}

bool RayTree::too_weak(const BandValues& beta) const {
    const double largest = beta.largest();
    return !(largest > 0.0) || largest < method_.settings().least_weight;
}

void RayTree::absorb(RayFamily& family, BandValues& beta, MediaStack media, double distance) {
    for (BandBlock& block : family.bands.blocks()) {
        const auto* sigma = block.media.extinction(media.interior());
        if (!sigma) return;
        for (int k = 0; k < block.lanes.count; ++k)
            beta[block.first + k] *= std::exp(-(*sigma)[std::size_t(k)] * distance);
    }
}

void RayTree::tint(RayFamily& family, const ColourInput& tint, const Vertex& vertex,
                   BandValues& beta) {
    if (!tint) return;
    for (BandBlock& block : family.bands.blocks()) {
        LaneValues factor;
        SurfaceInputs(vertex.at, block.reflectance).colour(tint, block.lanes, factor);
        for (int k = 0; k < block.lanes.count; ++k) beta[block.first + k] *= factor[k];
    }
}

}  // namespace dewbow::distributed_1989
