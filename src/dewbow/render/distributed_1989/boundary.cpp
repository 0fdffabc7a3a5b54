// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/distributed_1989/ray_tree.h"
#include "dewbow/render/surface/ggx_lobe.h"

namespace dewbow::distributed_1989 {

namespace {

/// Boundaries that are none (between equal media, inside overlaps) passed at one go before a ray is
/// given up: more than any real scene nests.
constexpr int kMostPassed = 64;

/// Snell's: none beyond the critical angle.
std::optional<Vec3> refracted(Vec3 wo, Vec3 normal, double cos_i, double eta) {
    const double cos2_t = cos2_transmitted(cos_i, eta);
    if (!(cos2_t > 0.0)) return std::nullopt;
    return normalised(normal * (cos_i / eta - std::sqrt(cos2_t)) - wo * (1.0 / eta));
}

/// Share of light that gets past the facets of a rough boundary along `direction`; 0 to the wrong
/// side.
double unmasked(const Vertex& vertex, const Interface& face, Vec3 direction, bool reflects) {
    if ((dot(direction, vertex.geometric) > 0.0) != reflects) return 0.0;
    if (face.alpha == 0.0) return 1.0;
    const Vec3 local = LocalFrame(vertex.shading).to_local(direction);
    if ((local.z > 0.0) != reflects) return 0.0;
    return ggx_g1({local.x, local.y, std::abs(local.z)}, face.alpha);
}

/// 256 values a channel: what is beyond 1 begins at 0 again.
double wrapped(double value) {
    constexpr double kLevels = 256.0, kWhite = 255.0;
    const double level = std::floor(kWhite * value + 0.5);
    return (level - kLevels * std::floor(level / kLevels)) / kWhite;
}

}  // namespace

bool RayTree::glass(const Meeting& at, const Dielectric& glass, int interior) {
    const Vertex& vertex = at.vertex;
    const Boundary boundary = boundary_at(at.ray.media, vertex.front, interior);
    if (boundary.none || !stops_shadows(vertex.shape)) {
        at.ray.media = boundary.after;
        at.ray.ray = vertex.leave(at.ray.ray.direction);
        // Shadow rays do not know it: the lamps behind it have not been counted.
        at.ray.sees_lamps = at.ray.sees_lamps || stops_shadows(vertex.shape);
        return ++at.ray.passed <= kMostPassed;
    }
    const Vec3 normal = mirror_normal(vertex);
    const std::optional<Interface> face =
        facet(at, {glass, boundary, normal, std::min(1.0, dot(vertex.wo, normal))});
    if (!face) return false;
    at.ray.media = boundary.before;
    const BandValues r = reflectance(at.family, *face);
    if (at.family.white && method_.disperses(boundary))
        split(at, *face);
    else
        refract(at, *face, r);

    const Vec3 direction = normalised(reflected(vertex.wo, face->normal));
    const double share = unmasked(vertex, *face, direction, true);
    for (int k = 0; k < r.count(); ++k) at.ray.beta[k] *= r[k] * share;
    at.ray.ray = vertex.leave(direction);
    at.ray.sees_lamps = true;
    ++at.ray.depth;
    return true;
}

/// Of a rough boundary a facet, drawn among those that the ray sees.
std::optional<Interface> RayTree::facet(const Meeting& at, Interface smooth) const {
    if (!is_rough(smooth.glass)) return smooth;
    const LocalFrame frame(at.vertex.shading);
    const Vec3 wo = frame.to_local(at.vertex.wo);
    if (wo.z <= 0.0) return std::nullopt;
    smooth.alpha = alpha_of_roughness(number_at(smooth.glass.roughness, at.vertex.at));
    const auto u = key_.two(vertex_key(at.ray), Purpose::bsdf_direction);
    const Vec3 m = sample_visible_normal(wo, smooth.alpha, u);
    smooth.cos_i = std::min(1.0, dot(wo, m));
    smooth.normal = frame.to_world(m);
    if (smooth.cos_i <= 0.0) return std::nullopt;
    return smooth;
}

double RayTree::eta(PacketMedia& media, const Boundary& boundary) {
    return media.index(boundary.after.interior())[0] / media.index(boundary.before.interior())[0];
}

double RayTree::nominal_reflectance(const Interface& face) {
    return fresnel_dielectric(face.cos_i, eta(workspace_.white.bend, face.boundary)).unpolarised();
}

/// Of each band of a ray. A ray of one wavelength goes by its own index, but for the nominal
/// reflectance as far as it is not reflected totally.
BandValues RayTree::reflectance(RayFamily& family, const Interface& face) {
    BandValues r(family.bands.count());
    const bool nominal = method_.settings().reflectance == ReflectanceAt::nominal;
    if (family.white && !nominal) {
        for (BandBlock& block : family.bands.blocks()) {
            const auto& before = block.media.index(face.boundary.before.interior());
            const auto& after = block.media.index(face.boundary.after.interior());
            for (int k = 0; k < block.lanes.count; ++k) {
                const double eta = after[std::size_t(k)] / before[std::size_t(k)];
                r[block.first + k] = fresnel_dielectric(face.cos_i, eta).unpolarised();
            }
        }
        return r;
    }
    const double own = eta(family.bend, face.boundary);
    const bool total = !(cos2_transmitted(face.cos_i, own) > 0.0);
    const double value = total     ? 1.0
                         : nominal ? nominal_reflectance(face)
                                   : fresnel_dielectric(face.cos_i, own).unpolarised();
    return {r.count(), value};
}

/// What is not reflected goes on as one ray.
void RayTree::refract(const Meeting& at, const Interface& face, const BandValues& reflectance) {
    const auto direction =
        refracted(at.vertex.wo, face.normal, face.cos_i, eta(at.family.bend, face.boundary));
    if (!direction) return;
    TracedRay next = at.ray;
    const double share = unmasked(at.vertex, face, *direction, false);
    for (int k = 0; k < next.beta.count(); ++k) next.beta[k] *= (1.0 - reflectance[k]) * share;
    tint(at.family, face.glass.tint, at.vertex, next.beta);
    if (too_weak(next.beta)) return;
    next.ray = at.vertex.leave(*direction);
    next.media = face.boundary.after;
    next.branch = ++branches_;
    next.passed = 0;
    next.sees_lamps = true;
    ++next.depth;
    at.family.pending.push_back(next);
}

/// The first refraction: what is not reflected of a ray without wavelength goes on as N rays of one
/// each.
void RayTree::split(const Meeting& at, const Interface& face) {
    RayFamily& family = workspace_.sample;
    draw_samples(vertex_key(at.ray));
    MonitorRgb total;
    for (const SpectralSample& sample : workspace_.samples) {
        start_sample(sample);
        TracedRay ray = at.ray;
        ray.beta = method_.for_sample(at.ray.beta, sample);
        const BandValues r = reflectance(family, face);
        refract({ray, family, at.vertex, total}, face, r);
        if (family.pending.empty()) continue;
        const TracedRay first = family.pending.back();
        family.pending.pop_back();
        total = total + follow(first, family);
    }
    const MonitorRgb white = method_.white_through(at.ray.beta) * (1.0 - nominal_reflectance(face));
    at.sum = at.sum + limited(total, white);
}

void RayTree::draw_samples(std::uint32_t vertex) {
    std::uint32_t number = 0;
    for (double& offset : workspace_.offsets)
        offset = key_.one(vertex + number++ * 0xc2b2ae35u, Purpose::spectral_offset);
    draw_spectral_samples(method_.sampling(), workspace_.offsets, workspace_.samples);
}

void RayTree::start_sample(const SpectralSample& sample) {
    workspace_.sample.bend.begin(packet_of_one(method_.index_nm(sample)));
    method_.set_sample(sample, workspace_.sample.bands);
}

/// @param white  what a white surround would give, without dispersion.
MonitorRgb RayTree::limited(MonitorRgb total, MonitorRgb white) const {
    const SampleSum sum = method_.settings().sum;
    for (std::size_t c = 0; c < 3; ++c) {
        if (sum == SampleSum::free || !(white[c] > 0.0)) continue;
        const double share = total[c] / white[c];
        total[c] = white[c] * (sum == SampleSum::clamp ? std::min(share, 1.0) : wrapped(share));
    }
    return total;
}

}  // namespace dewbow::distributed_1989
