// SPDX-License-Identifier: Apache-2.0

// One camera path and its packet of wavelengths.
//
// All lanes share one ray until the first dispersive boundary. There the path splits: what is
// reflected stays one shared path with each lane's own Fresnel factor; what is refracted opens into
// a ray for each lane, and each lane then decides for itself between reflection and refraction, by
// one random number for all. Where opened lanes meet a rough surface, each takes direct light by
// the same light sample, and one of them goes on for all that arrived there with it.
//
// The estimate of lane k is f_k / p_k, with p_k the density of its own vertices: while lanes share
// a path every choice has one density for all of them, and afterwards each has its own. The lane
// that goes on is weighted by the inverse of the probability that it was the one.
//
// Radiance is carried divided by the square of the index, which no boundary changes; the factor is
// put back where light is found. [L / n² is invariant: Nicodemus 1963]

#include <algorithm>
#include <bit>
#include <cmath>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/bsdf.h"
#include "dewbow/render/path/path.h"
#include "dewbow/render/refract_lanes.h"

namespace dewbow {

namespace {

/// Indices that agree to this bend all lanes alike: ten roundings.
constexpr double kSameIndex = 1e-14;
/// Boundaries that are none (between equal media, inside overlaps) passed at one go before a path
/// is given up: more than any real scene nests.
constexpr int kMostPassed = 64;
/// Of the lanes that meet something rough together, this many go on. Tuned on a room behind a pane,
/// a room lit through one and a wall behind a prism: two are worth 1.4, 1.6 and 1.4 of one (error ×
/// time).
constexpr int kLanesThatGoOn = 2;
/// Paths survive roulette with at least this probability.
constexpr double kLeastSurvival = 0.05;

/// One ray with the lanes that it carries.
struct SharedPath {
    Ray ray;
    LaneSet lanes;
    LaneValues beta;  ///< throughput / n²
    MediaStack media;
    int depth = 0;
    std::uint32_t branch = 0;  ///< tells the random numbers of suffixes apart
    int passed = 0;            ///< boundaries that are none since the last that was one
    bool scattered = false;    ///< has met something rough
    bool split = false;        ///< has split at a dispersive boundary
    // The last scattering, for the weight of light that is found by chance.
    bool from_specular = true;
    double last_pdf = 0.0;
    Vec3 last_position;
};

/// Lanes on rays of their own.
struct OpenPath {
    LaneSet lanes;
    RayLanes rays;
    LaneValues beta;
    std::array<MediaStack, kMaxLanes> media;
    LaneMask active = 0;
    int depth = 0;
    std::uint32_t branch = 0;
    std::array<bool, kMaxLanes> from_specular{};
    LaneValues last_pdf;
    std::array<Vec3, kMaxLanes> last_position;
};

/// A surface as a ray meets it.
struct Vertex {
    Vec3 position;
    Vec3 wo;         ///< towards where the path came from
    Vec3 geometric;  ///< normals, turned to the side of wo
    Vec3 shading;
    bool front = true;  ///< met from outside
    int shape = -1, primitive = -1;

    /// A ray that leaves along `direction`.
    Ray leave(Vec3 direction) const {
        const double side = dot(direction, geometric);
        const bool outward = front ? side > 0.0 : side < 0.0;
        return {position, direction, {shape, primitive, !outward}};
    }
};

double power_heuristic(double a, double b) { return a * a / (a * a + b * b); }

/// What one boundary between media is made of.
struct Boundary {
    MediaStack before, after;
    bool none = false;  ///< the same medium on both sides
};

class Tracer {
public:
    Tracer(const PreparedScene& prepared, const WavelengthPacket& packet, const SampleKey& key,
           MediaStack start, PacketMedia& media, RgbLightLanes& rgb,
           std::vector<SharedPath>& pending)
        : prepared_(prepared),
          settings_(prepared.scene.render),
          packet_(packet),
          key_(key),
          start_medium_(start.interior()),
          packet_media_(media),
          rgb_(rgb),
          pending_(pending) {}

    PixelSample run(const Ray& ray, MediaStack media);

private:
    void trace(SharedPath path);
    bool interact(SharedPath& path, const Hit& hit);
    bool scatter(SharedPath& path, const Vertex& vertex, const Material& material,
                 bool take_direct);
    bool mirror(SharedPath& path, const Vertex& vertex, const Mirror& mirror);
    bool thin(SharedPath& path, const Vertex& vertex, const ThinDielectric& pane);
    bool smooth(SharedPath& path, const Vertex& vertex, const Dielectric& glass, int id);
    bool rough(SharedPath& path, const Hit& hit, const Dielectric& glass, int id);
    void split_shared(SharedPath& path, const Vertex& vertex, const Dielectric& glass,
                      const Boundary& boundary, const LaneValues& eta);
    void open_transmitted(const SharedPath& path, const Vertex& vertex, const LaneValues& beta,
                          const Boundary& boundary, const LaneValues& eta, Vec3 normal);

    void trace_open(OpenPath path);
    void open_missed(OpenPath& path, int k);
    void open_group(OpenPath& path, LaneMask group, const HitLanes& hits);
    void pass(OpenPath& path, int k, const Hit& hit, const Boundary& boundary);
    void open_smooth(OpenPath& path, LaneMask group, const HitLanes& hits, const Dielectric& glass,
                     int id);
    void open_rough(OpenPath& path, LaneMask group, const HitLanes& hits, const Dielectric& glass,
                    int id);
    void open_one_by_one(OpenPath& path, LaneMask group, const HitLanes& hits,
                         const Material& material);
    void collapse(OpenPath& path, LaneMask group, const HitLanes& hits, const Material& material);
    static int lane_at(const OpenPath& path, LaneMask group, double target);

    // Light.
    void add(const LaneSet& lanes, const LaneValues& beta, const LaneValues& radiance,
             double weight, MediaStack media);
    void add_infinite(const LaneSet& lanes, const LaneValues& beta, Vec3 direction, bool specular,
                      double pdf, MediaStack media);
    void add_emission(const LaneSet& lanes, const LaneValues& beta, const Ray& ray, const Hit& hit,
                      bool specular, double pdf, Vec3 from, MediaStack media);
    template <class Eval>
    void direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides, Eval&& eval);
    void direct_opaque(const SharedPath& path, const Vertex& vertex, const Material& material);
    void direct_rough(const SharedPath& path, const Vertex& vertex, double alpha,
                      const Boundary& boundary, const LaneValues& eta);

    // Helpers.
    Vertex vertex_at(const Ray& ray, const Hit& hit) const;
    Vec3 facing_normal(Vec3 direction, const Hit& hit, bool front) const;
    const Material& material_at(const Hit& hit, std::uint32_t vertex, int& id) const;
    Boundary boundary_at(MediaStack media, bool front, int id) const;
    void indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta);
    void absorb(const LaneSet& lanes, LaneValues& beta, MediaStack media, double distance);
    bool stops_shadows(int shape) const { return !prepared_.see_through[std::size_t(shape)]; }
    bool roulette(LaneValues& beta, int count, LaneMask mask, int depth,
                  std::uint32_t vertex) const;
    std::uint32_t vertex_key(int depth, std::uint32_t branch) const {
        return std::uint32_t(depth) + branch * 0x9e3779b9u;  // 2³² / golden ratio: far apart
    }
    SharedPath lane_of(const OpenPath& path, int k) const;
    static bool dispersive(const LaneValues& eta, int count);
    void tint(const SpectrumPtr& tint, const LaneSet& lanes, LaneValues& beta, LaneMask mask);

    const PreparedScene& prepared_;
    const RenderSettings& settings_;
    const WavelengthPacket& packet_;
    const SampleKey key_;
    const int start_medium_;
    PacketMedia& packet_media_;
    RgbLightLanes& rgb_;
    std::vector<SharedPath>& pending_;  ///< single lanes that go on from something rough
    PixelSample result_;
    std::uint32_t branches_ = 0;
};

// ---- shared paths ------------------------------------------------------------------------------

PixelSample Tracer::run(const Ray& ray, MediaStack media) {
    result_.wavelengths = packet_;
    SharedPath path;
    path.ray = ray;
    path.lanes = LaneSet::all(packet_);
    path.beta.v.fill(1.0);
    path.media = media;
    pending_.clear();
    trace(path);
    while (!pending_.empty()) {
        const SharedPath next = pending_.back();
        pending_.pop_back();
        trace(next);
    }
    return result_;
}

void Tracer::trace(SharedPath path) {
    for (;;) {
        const Hit hit = prepared_.accelerator.intersect(path.ray);
        if (hit) absorb(path.lanes, path.beta, path.media, hit.t);
        if (!hit) {
            add_infinite(path.lanes, path.beta, path.ray.direction, path.from_specular,
                         path.last_pdf, path.media);
            return;
        }
        if (prepared_.lights.emits(hit, path.ray.direction))
            add_emission(path.lanes, path.beta, path.ray, hit, path.from_specular, path.last_pdf,
                         path.last_position, path.media);
        const int depth = path.depth;
        if (depth >= settings_.max_depth || !interact(path, hit)) return;
        // A surface that is none costs no depth, and its random numbers were used before it.
        if (path.depth == depth) continue;
        path.passed = 0;
        const LaneMask all = (1u << path.lanes.count) - 1u;
        if (!roulette(path.beta, path.lanes.count, all, path.depth,
                      vertex_key(path.depth, path.branch)))
            return;
    }
}

/// Takes the path past one surface. False: it ends here.
bool Tracer::interact(SharedPath& path, const Hit& hit) {
    const Vertex vertex = vertex_at(path.ray, hit);
    int id = -1;
    const std::uint32_t at =
        vertex_key(path.depth, path.branch) + std::uint32_t(path.passed) * 0x85ebca6bu;
    const Material& material = material_at(hit, at, id);
    if (!result_.hit && path.depth == 0 && path.branch == 0) {
        result_.hit = true;
        result_.normal = dot(vertex.shading, vertex.wo) >= 0.0 ? vertex.shading : -vertex.shading;
        result_.depth = dot(vertex.position - prepared_.camera.position(), prepared_.camera.axis());
        result_.albedo = prepared_.albedo[std::size_t(id)];
    }
    if (const auto* glass = std::get_if<Dielectric>(&material.surface))
        return glass->roughness > 0.0
                   ? rough(path, hit, *glass, prepared_.media.interior_of(id))
                   : smooth(path, vertex, *glass, prepared_.media.interior_of(id));
    if (const auto* m = std::get_if<Mirror>(&material.surface)) return mirror(path, vertex, *m);
    if (const auto* pane = std::get_if<ThinDielectric>(&material.surface))
        return thin(path, vertex, *pane);
    if (OpaqueSurface::holds(material)) return scatter(path, vertex, material, true);
    return false;
}

bool Tracer::scatter(SharedPath& path, const Vertex& vertex, const Material& material,
                     bool take_direct) {
    if (take_direct) direct_opaque(path, vertex, material);
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const LocalFrame frame(vertex.shading);
    const OpaqueSurface surface(material, path.lanes, frame.to_local(vertex.wo));
    const std::optional<Vec3> wi =
        surface.sample(key_.one(at, Purpose::bsdf_lobe), key_.two(at, Purpose::bsdf_direction));
    if (!wi) return false;
    LaneValues f;
    const double pdf = surface.eval(*wi, f);
    const Vec3 direction = frame.to_world(*wi);
    if (!(pdf > 0.0) || dot(direction, vertex.geometric) <= 0.0) return false;
    for (int k = 0; k < path.lanes.count; ++k) path.beta[k] *= f[k] / pdf;
    path.ray = vertex.leave(direction);
    path.from_specular = false;
    path.scattered = true;
    path.last_pdf = pdf;
    path.last_position = vertex.position;
    ++path.depth;
    return true;
}

Vec3 reflected(Vec3 wo, Vec3 normal) { return normal * (2.0 * dot(wo, normal)) - wo; }

/// The shading normal, unless it would send a mirror ray below the true surface.
Vec3 mirror_normal(const Vertex& vertex) {
    return dot(reflected(vertex.wo, vertex.shading), vertex.geometric) > 0.0 ? vertex.shading
                                                                             : vertex.geometric;
}

bool Tracer::mirror(SharedPath& path, const Vertex& vertex, const Mirror& mirror) {
    tint(mirror.reflectance, path.lanes, path.beta, ~0u);
    path.ray = vertex.leave(normalised(reflected(vertex.wo, mirror_normal(vertex))));
    path.from_specular = true;
    ++path.depth;
    return true;
}

/// Reflectance of a pane: r + t² r + t² r³ + … = 2r / (1 + r).
double pane_reflectance(double cosine, double n) {
    const double r = fresnel_dielectric(std::min(1.0, cosine), n).unpolarised();
    return 2.0 * r / (1.0 + r);
}

bool Tracer::thin(SharedPath& path, const Vertex& vertex, const ThinDielectric& pane) {
    LaneValues n, r;
    pane.index->eval_lanes(path.lanes.lambdas(), n.first(path.lanes.count));
    const auto& around = packet_media_.index(path.media.interior());
    double mean = 0.0;
    for (int k = 0; k < path.lanes.count; ++k) {
        r[k] = pane_reflectance(dot(vertex.wo, vertex.shading),
                                n[k] / around[std::size_t(path.lanes.id[std::size_t(k)])]);
        mean += r[k] / path.lanes.count;
    }
    const bool reflects = key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe) < mean;
    for (int k = 0; k < path.lanes.count; ++k)
        path.beta[k] *= reflects ? r[k] / mean : (1.0 - r[k]) / (1.0 - mean);
    if (!reflects) tint(pane.tint, path.lanes, path.beta, ~0u);
    const Vec3 direction =
        reflects ? normalised(reflected(vertex.wo, mirror_normal(vertex))) : -vertex.wo;
    path.ray = vertex.leave(direction);
    path.from_specular = true;
    ++path.depth;
    return true;
}

bool Tracer::smooth(SharedPath& path, const Vertex& vertex, const Dielectric& glass, int id) {
    const Boundary boundary = boundary_at(path.media, vertex.front, id);
    if (boundary.none || !stops_shadows(vertex.shape)) {
        path.media = boundary.after;
        path.ray = vertex.leave(path.ray.direction);
        // Shadow rays do not know it: what lies behind is found by chance alone.
        path.from_specular = path.from_specular || stops_shadows(vertex.shape);
        return ++path.passed <= kMostPassed;
    }
    const int count = path.lanes.count;
    LaneValues eta;
    indices(path.lanes, boundary, eta);
    const bool spreads = count > 1 && dispersive(eta, count);
    if (spreads && !path.scattered && !path.split) {
        split_shared(path, vertex, glass, boundary, eta);
        return true;
    }
    const Vec3 normal = mirror_normal(vertex);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    LaneValues r;
    double mean = 0.0;
    for (int k = 0; k < count; ++k) {
        r[k] = spreads || k == 0 ? fresnel_dielectric(cos_i, eta[k]).unpolarised() : r[0];
        mean += r[k] / count;
    }
    if (!spreads) mean = r[0];
    const bool reflects = key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe) < mean;
    if (spreads)
        for (int k = 0; k < count; ++k)
            path.beta[k] *= reflects ? r[k] / mean : (1.0 - r[k]) / (1.0 - mean);
    path.from_specular = true;
    if (reflects) {
        path.media = boundary.before;
        path.ray = vertex.leave(normalised(reflected(vertex.wo, normal)));
        ++path.depth;
        return true;
    }
    tint(glass.tint, path.lanes, path.beta, ~0u);
    if (spreads) {
        open_transmitted(path, vertex, path.beta, boundary, eta, normal);
        return false;
    }
    const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_i, eta[0])));
    path.media = boundary.after;
    path.ray =
        vertex.leave(normalised(normal * (cos_i / eta[0] - cos_t) - vertex.wo * (1.0 / eta[0])));
    ++path.depth;
    return true;
}

/// Both ways at once: the refracted lanes are followed to their ends, the reflected path goes on.
void Tracer::split_shared(SharedPath& path, const Vertex& vertex, const Dielectric& glass,
                          const Boundary& boundary, const LaneValues& eta) {
    const Vec3 normal = mirror_normal(vertex);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    LaneValues refracted_beta = path.beta;
    for (int k = 0; k < path.lanes.count; ++k) {
        const double r = fresnel_dielectric(cos_i, eta[k]).unpolarised();
        refracted_beta[k] = path.beta[k] * (1.0 - r);
        path.beta[k] *= r;
    }
    tint(glass.tint, path.lanes, refracted_beta, ~0u);
    open_transmitted(path, vertex, refracted_beta, boundary, eta, normal);
    path.media = boundary.before;
    path.ray = vertex.leave(normalised(reflected(vertex.wo, normal)));
    path.split = true;
    path.from_specular = true;
    path.branch = ++branches_;
    ++path.depth;
}

void Tracer::open_transmitted(const SharedPath& path, const Vertex& vertex, const LaneValues& beta,
                              const Boundary& boundary, const LaneValues& eta, Vec3 normal) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = beta;
    open.depth = path.depth + 1;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.last_pdf.v.fill(0.0);
    open.from_specular.fill(true);
    open.media.fill(boundary.after);
    const double cos_i = std::min(1.0, dot(vertex.wo, normal));
    for (int k = 0; k < path.lanes.count; ++k) {
        const double cos2_t = cos2_transmitted(cos_i, eta[k]);
        if (!(cos2_t > 0.0) || beta[k] == 0.0) continue;
        const Vec3 d =
            normalised(normal * (cos_i / eta[k] - std::sqrt(cos2_t)) - vertex.wo * (1.0 / eta[k]));
        open.rays.set(k, vertex.leave(d));
        open.active |= 1u << k;
    }
    for (int k = 0; k < path.lanes.count; ++k)
        if (!(open.active >> k & 1u) && open.active)
            open.rays.set(k, open.rays.ray(std::countr_zero(open.active)));
    if (open.active) trace_open(open);
}

/// Rough glass is followed lane by lane from the first surface on.
bool Tracer::rough(SharedPath& path, const Hit& hit, const Dielectric& glass, int id) {
    OpenPath open;
    open.lanes = path.lanes;
    open.beta = path.beta;
    open.depth = path.depth;
    open.branch = ++branches_;
    open.rays.count = path.lanes.count;
    open.active = (1u << path.lanes.count) - 1u;
    open.media.fill(path.media);
    open.from_specular.fill(path.from_specular);
    open.last_pdf.v.fill(path.last_pdf);
    open.last_position.fill(path.last_position);
    for (int k = 0; k < path.lanes.count; ++k) open.rays.set(k, path.ray);
    HitLanes hits;
    hits.fill(hit);
    open_rough(open, open.active, hits, glass, id);
    ++open.depth;
    trace_open(open);
    return false;
}

// ---- opened lanes ------------------------------------------------------------------------------

void Tracer::trace_open(OpenPath path) {
    HitLanes hits;
    while (path.active) {
        prepared_.accelerator.intersect(path.rays, path.active, hits);
        for (int k = 0; k < path.lanes.count; ++k) {
            if (!(path.active >> k & 1u)) continue;
            const Hit& hit = hits[std::size_t(k)];
            if (!hit) {
                open_missed(path, k);
                continue;
            }
            const auto i = std::size_t(k);
            if (const auto* sigma = packet_media_.absorption(path.media[i].interior()))
                path.beta[k] *= std::exp(-(*sigma)[std::size_t(path.lanes.id[i])] * hit.t);
            if (prepared_.lights.emits(hit, path.rays.direction(k))) {
                const SharedPath lane = lane_of(path, k);
                add_emission(lane.lanes, lane.beta, lane.ray, hit, lane.from_specular,
                             lane.last_pdf, lane.last_position, lane.media);
            }
        }
        if (path.depth >= settings_.max_depth) return;
        // Lanes that meet the same surface in the same way go together.
        for (LaneMask rest = path.active; rest;) {
            const auto first = std::size_t(std::countr_zero(rest));
            const bool front = dot(path.rays.direction(int(first)), hits[first].normal) < 0.0;
            LaneMask group = 0;
            for (int k = int(first); k < path.lanes.count; ++k) {
                const auto i = std::size_t(k);
                const bool same = (rest >> k & 1u) && hits[i].shape == hits[first].shape &&
                                  path.media[i] == path.media[first] &&
                                  (dot(path.rays.direction(k), hits[i].normal) < 0.0) == front;
                group |= LaneMask(same) << k;
            }
            rest &= ~group;
            open_group(path, group, hits);
        }
        ++path.depth;
        if (path.active && !roulette(path.beta, path.lanes.count, path.active, path.depth,
                                     vertex_key(path.depth, path.branch)))
            return;
    }
}

void Tracer::open_missed(OpenPath& path, int k) {
    const SharedPath lane = lane_of(path, k);
    add_infinite(lane.lanes, lane.beta, lane.ray.direction, lane.from_specular, lane.last_pdf,
                 lane.media);
    path.active &= ~(1u << k);
}

void Tracer::open_group(OpenPath& path, LaneMask group, const HitLanes& hits) {
    int id = -1;
    const Material& material = material_at(hits[std::size_t(std::countr_zero(group))],
                                           vertex_key(path.depth, path.branch), id);
    const int medium = prepared_.media.interior_of(id);
    if (const auto* glass = std::get_if<Dielectric>(&material.surface)) {
        if (glass->roughness > 0.0)
            open_rough(path, group, hits, *glass, medium);
        else
            open_smooth(path, group, hits, *glass, medium);
    } else if (OpaqueSurface::holds(material)) {
        collapse(path, group, hits, material);
    } else if (std::holds_alternative<Black>(material.surface)) {
        path.active &= ~group;
    } else {
        open_one_by_one(path, group, hits, material);
    }
}

/// Takes a lane straight through a surface that is none. Shadow rays mostly know nothing of that:
/// what lies behind such a surface is found by chance alone.
void Tracer::pass(OpenPath& path, int k, const Hit& hit, const Boundary& boundary) {
    const auto i = std::size_t(k);
    path.media[i] = boundary.after;
    path.rays.set(k, vertex_at(path.rays.ray(k), hit).leave(path.rays.direction(k)));
    path.from_specular[i] = path.from_specular[i] || stops_shadows(hit.shape);
}

void Tracer::open_smooth(OpenPath& path, LaneMask group, const HitLanes& hits,
                         const Dielectric& glass, int id) {
    const auto first = std::size_t(std::countr_zero(group));
    const bool front = dot(path.rays.direction(int(first)), hits[first].normal) < 0.0;
    const Boundary boundary = boundary_at(path.media[first], front, id);
    const int count = path.lanes.count;
    if (boundary.none || !stops_shadows(hits[first].shape)) {
        for (int k = 0; k < count; ++k)
            if (group >> k & 1u) pass(path, k, hits[std::size_t(k)], boundary);
        return;
    }
    BoundaryLanes lanes;
    indices(path.lanes, boundary, lanes.eta);
    std::array<Vec3, kMaxLanes> position;
    for (int k = 0; k < count; ++k) {
        const auto i = std::size_t(k);
        Vec3 n{};  // lanes outside the group are computed along and not used
        if (group >> k & 1u) {
            position[i] = path.rays.origin(k) + path.rays.direction(k) * hits[i].t;
            n = facing_normal(path.rays.direction(k), hits[i], front);
        }
        lanes.nx.v[i] = n.x, lanes.ny.v[i] = n.y, lanes.nz.v[i] = n.z;
    }
    const double u = key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe);
    refract_or_reflect_lanes(count, u, path.rays, lanes);
    LaneMask refracted = 0;
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        const auto i = std::size_t(k);
        const bool reflects = lanes.reflected.v[i] != 0.0;
        refracted |= LaneMask(!reflects) << k;
        path.media[i] = reflects ? boundary.before : boundary.after;
        path.rays.set(k, {position[i],
                          {lanes.dx.v[i], lanes.dy.v[i], lanes.dz.v[i]},
                          {hits[i].shape, hits[i].primitive, front != reflects}});
        path.from_specular[i] = true;
    }
    if (glass.tint) tint(glass.tint, path.lanes, path.beta, refracted);
}

/// Each lane at a rough boundary, by one microfacet for all of them.
void Tracer::open_rough(OpenPath& path, LaneMask group, const HitLanes& hits,
                        const Dielectric& glass, int id) {
    const auto first = std::size_t(std::countr_zero(group));
    const bool front = dot(path.rays.direction(int(first)), hits[first].normal) < 0.0;
    const Boundary boundary = boundary_at(path.media[first], front, id);
    const double alpha = std::max(kLeastAlpha, glass.roughness * glass.roughness);
    LaneValues eta;
    indices(path.lanes, boundary, eta);
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const double u = key_.one(at, Purpose::bsdf_lobe);
    const std::array<double, 2> u_facet = key_.two(at, Purpose::bsdf_direction);
    LaneMask refracted = 0;
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const auto i = std::size_t(k);
        const Vertex vertex = vertex_at(path.rays.ray(k), hits[i]);
        if (boundary.none || std::abs(eta[k] - 1.0) <= kSameIndex) {
            pass(path, k, hits[i], boundary);
            refracted |= LaneMask(!boundary.none) << k;
            continue;
        }
        SharedPath lane = lane_of(path, k);
        LaneValues lane_eta;
        lane_eta[0] = eta[k];
        direct_rough(lane, vertex, alpha, boundary, lane_eta);
        const LocalFrame frame(vertex.shading);
        const Vec3 wo = frame.to_local(vertex.wo);
        path.active &= ~(1u << k);
        if (wo.z <= 0.0) continue;
        const Vec3 m = sample_visible_normal(wo, alpha, u_facet);
        const double cos_m = std::min(1.0, dot(wo, m));
        if (cos_m <= 0.0) continue;
        const bool reflects = u < fresnel_dielectric(cos_m, eta[k]).unpolarised();
        Vec3 wi = m * (2.0 * cos_m) - wo;
        if (!reflects) {
            const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_m, eta[k])));
            wi = m * (cos_m / eta[k] - cos_t) - wo * (1.0 / eta[k]);
        }
        wi = normalised(wi);
        const Vec3 direction = frame.to_world(wi);
        if ((wi.z > 0.0) != reflects || (dot(direction, vertex.geometric) > 0.0) != reflects)
            continue;
        const RoughDielectricValue value = eval_rough_dielectric(wo, wi, alpha, eta[k]);
        if (!(value.pdf > 0.0)) continue;
        path.beta[k] *= value.f_cos / value.pdf;
        path.media[i] = reflects ? boundary.before : boundary.after;
        path.rays.set(k, vertex.leave(direction));
        path.from_specular[i] = false;
        path.last_pdf[k] = value.pdf;
        path.last_position[i] = vertex.position;
        path.active |= 1u << k;
        refracted |= LaneMask(!reflects) << k;
    }
    if (glass.tint) tint(glass.tint, path.lanes, path.beta, refracted);
}

/// Mirrors and panes: rare among opened lanes.
void Tracer::open_one_by_one(OpenPath& path, LaneMask group, const HitLanes& hits,
                             const Material& material) {
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const auto i = std::size_t(k);
        SharedPath lane = lane_of(path, k);
        const Vertex vertex = vertex_at(lane.ray, hits[i]);
        if (const auto* m = std::get_if<Mirror>(&material.surface))
            mirror(lane, vertex, *m);
        else
            thin(lane, vertex, std::get<ThinDielectric>(material.surface));
        path.rays.set(k, lane.ray);
        path.beta[k] = lane.beta[0];
        path.media[i] = lane.media;
        path.from_specular[i] = true;
    }
}

/// Lanes that meet something rough together: each takes direct light, a few go on.
void Tracer::collapse(OpenPath& path, LaneMask group, const HitLanes& hits,
                      const Material& material) {
    double total = 0.0;
    for (int k = 0; k < path.lanes.count; ++k) {
        if (!(group >> k & 1u)) continue;
        const SharedPath lane = lane_of(path, k);
        direct_opaque(lane, vertex_at(lane.ray, hits[std::size_t(k)]), material);
        total += path.beta[k];
    }
    path.active &= ~group;
    if (!(total > 0.0)) return;
    const int count = std::min(kLanesThatGoOn, std::popcount(group));
    const double u = key_.one(vertex_key(path.depth, path.branch), Purpose::lane_choice);
    for (int i = 0; i < count; ++i) {
        const int chosen = lane_at(path, group, (u + i) / count * total);
        SharedPath lane = lane_of(path, chosen);
        lane.branch = ++branches_;
        const Vertex vertex = vertex_at(lane.ray, hits[std::size_t(chosen)]);
        lane.beta[0] = total / count;  // β over the expected number of times that it is chosen
        if (scatter(lane, vertex, material, false) &&
            roulette(lane.beta, 1, 1u, lane.depth, vertex_key(lane.depth, lane.branch)))
            pending_.push_back(lane);
    }
}

/// The lane of `group` in which the running sum of throughputs passes `target`.
int Tracer::lane_at(const OpenPath& path, LaneMask group, double target) {
    int chosen = std::countr_zero(group);
    for (LaneMask rest = group; rest; rest &= rest - 1) {
        const int k = std::countr_zero(rest);
        if (path.beta[k] == 0.0) continue;
        chosen = k;
        target -= path.beta[k];
        if (target < 0.0) break;
    }
    return chosen;
}

// ---- light -------------------------------------------------------------------------------------

void Tracer::add(const LaneSet& lanes, const LaneValues& beta, const LaneValues& radiance,
                 double weight, MediaStack media) {
    const int medium = media.interior();
    if (medium == start_medium_) {
        for (int k = 0; k < lanes.count; ++k)
            result_.radiance[std::size_t(lanes.id[std::size_t(k)])] +=
                weight * beta[k] * radiance[k];
        return;
    }
    const auto& here = packet_media_.index(medium);
    const auto& start = packet_media_.index(start_medium_);
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        const double ratio = start[id] / here[id];
        result_.radiance[id] += weight * beta[k] * radiance[k] * ratio * ratio;
    }
}

void Tracer::add_infinite(const LaneSet& lanes, const LaneValues& beta, Vec3 direction,
                          bool specular, double pdf, MediaStack media) {
    const LightSet& lights = prepared_.lights;
    LaneValues radiance;
    for (int i = 0; i < lights.infinite_count(); ++i) {
        if (!lights.infinite_radiance(i, direction, lanes, rgb_, radiance)) continue;
        const double weight =
            specular ? 1.0 : power_heuristic(pdf, lights.pdf_of_infinite(i, direction));
        add(lanes, beta, radiance, weight, media);
    }
}

void Tracer::add_emission(const LaneSet& lanes, const LaneValues& beta, const Ray& ray,
                          const Hit& hit, bool specular, double pdf, Vec3 from, MediaStack media) {
    LaneValues radiance;
    prepared_.lights.emission(hit, lanes, radiance);
    double weight = 1.0;
    if (!specular) {
        Hit seen_from = hit;
        seen_from.t = length(ray.origin + ray.direction * hit.t - from);
        weight = power_heuristic(pdf, prepared_.lights.pdf_of_hit(from, ray.direction, seen_from));
    }
    add(lanes, beta, radiance, weight, media);
}

/// Direct light at `vertex`. `eval(wi, f)` gives BSDF × cosine at each lane and returns the density
/// of the surface's own sampling.
template <class Eval>
void Tracer::direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides,
                          Eval&& eval) {
    const std::uint32_t at = vertex_key(path.depth, path.branch);
    const std::optional<LightSample> light = prepared_.lights.sample(
        vertex.position, key_.one(at, Purpose::light_choice), key_.two(at, Purpose::light_point));
    if (!light || !(light->pdf > 0.0)) return;
    const double side = dot(light->direction, vertex.geometric);
    if (side == 0.0 || (side < 0.0 && !both_sides)) return;
    LaneValues f{};
    const double pdf = eval(light->direction, f);
    if (!(pdf > 0.0)) return;
    if (prepared_.accelerator.occluded(vertex.leave(light->direction), light->distance)) return;
    LaneValues radiance;
    prepared_.lights.radiance(*light, path.lanes, rgb_, radiance);
    for (int k = 0; k < path.lanes.count; ++k) radiance[k] *= f[k];
    // What is infinitely far is not absorbed, as where a path misses everything.
    if (std::isfinite(light->distance)) absorb(path.lanes, radiance, path.media, light->distance);
    const double weight = light->without_extent ? 1.0 : power_heuristic(light->pdf, pdf);
    add(path.lanes, path.beta, radiance, weight / light->pdf, path.media);
}

void Tracer::direct_opaque(const SharedPath& path, const Vertex& vertex, const Material& material) {
    const LocalFrame frame(vertex.shading);
    const OpaqueSurface surface(material, path.lanes, frame.to_local(vertex.wo));
    direct_light(path, vertex, false, [&](Vec3 direction, LaneValues& f) {
        return surface.eval(frame.to_local(direction), f);
    });
}

void Tracer::direct_rough(const SharedPath& path, const Vertex& vertex, double alpha,
                          const Boundary& boundary, const LaneValues& eta) {
    const LocalFrame frame(vertex.shading);
    const Vec3 wo = frame.to_local(vertex.wo);
    if (wo.z <= 0.0) return;
    SharedPath there = path;
    direct_light(there, vertex, true, [&](Vec3 direction, LaneValues& f) {
        const Vec3 wi = frame.to_local(direction);
        const bool above = dot(direction, vertex.geometric) > 0.0;
        if ((wi.z > 0.0) != above) return 0.0;
        there.media = above ? boundary.before : boundary.after;
        const RoughDielectricValue value = eval_rough_dielectric(wo, wi, alpha, eta[0]);
        f[0] = value.f_cos;
        return value.pdf;
    });
}

// ---- helpers -----------------------------------------------------------------------------------

Vertex Tracer::vertex_at(const Ray& ray, const Hit& hit) const {
    Vertex v;
    v.position = ray.origin + ray.direction * hit.t;
    v.wo = -ray.direction;
    v.front = dot(ray.direction, hit.normal) < 0.0;
    const double side = v.front ? 1.0 : -1.0;
    v.geometric = hit.normal * side;
    v.shading = prepared_.accelerator.shading_normal(hit) * side;
    if (dot(v.shading, v.wo) <= 0.0) v.shading = v.geometric;
    v.shape = hit.shape;
    v.primitive = hit.primitive;
    return v;
}

/// The normal that a smooth boundary turns rays by: on the side that the ray comes from.
Vec3 Tracer::facing_normal(Vec3 direction, const Hit& hit, bool front) const {
    if (prepared_.accelerator.flat(hit.shape)) return front ? hit.normal : -hit.normal;
    return mirror_normal(vertex_at({{}, direction, {}}, hit));
}

const Material& Tracer::material_at(const Hit& hit, std::uint32_t vertex, int& id) const {
    id = prepared_.scene.shapes[std::size_t(hit.shape)].material;
    const Material* material = &prepared_.scene.materials[std::size_t(id)];
    while (const auto* mix = std::get_if<Mix>(&material->surface)) {
        id = key_.two(vertex, Purpose::bsdf_lobe)[1] < mix->second_share ? mix->second : mix->first;
        material = &prepared_.scene.materials[std::size_t(id)];
    }
    return *material;
}

Boundary Tracer::boundary_at(MediaStack media, bool front, int id) const {
    Boundary b;
    // A path that leaves a body which it never entered (an open mesh) was inside after all.
    b.before = !front && !media.holds(id) ? media.entered(id) : media;
    b.after = front ? b.before.entered(id) : b.before.left(id);
    b.none = b.before.interior() == b.after.interior();
    return b;
}

void Tracer::indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta) {
    const auto& before = packet_media_.index(boundary.before.interior());
    const auto& after = packet_media_.index(boundary.after.interior());
    for (int k = 0; k < lanes.count; ++k) {
        const auto id = std::size_t(lanes.id[std::size_t(k)]);
        eta[k] = after[id] / before[id];
    }
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

void Tracer::tint(const SpectrumPtr& tint, const LaneSet& lanes, LaneValues& beta, LaneMask mask) {
    if (!tint) return;
    LaneValues factor;
    tint->eval_lanes(lanes.lambdas(), factor.first(lanes.count));
    for (int k = 0; k < lanes.count; ++k)
        if (mask >> k & 1u) beta[k] *= factor[k];
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
    lane.last_position = path.last_position[i];
    return lane;
}

/// Memory that one thread needs for its packets, kept between samples.
struct Scratch {
    std::uint64_t serial = 0;
    std::optional<PacketMedia> media;
    RgbLightLanes rgb;
    std::vector<SharedPath> pending;
};

}  // namespace

PixelSample trace_sample(const PreparedScene& prepared, const Ray& ray, MediaStack media,
                         const WavelengthPacket& wavelengths, const SampleKey& key) {
    thread_local Scratch scratch;
    if (scratch.serial != prepared.serial) {
        scratch.serial = prepared.serial;
        scratch.media.emplace(prepared.media);
    }
    scratch.media->begin(wavelengths);
    scratch.rgb.begin(wavelengths);
    return Tracer(prepared, wavelengths, key, media, *scratch.media, scratch.rgb, scratch.pending)
        .run(ray, media);
}

}  // namespace dewbow
