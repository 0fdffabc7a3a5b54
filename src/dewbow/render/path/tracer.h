// SPDX-License-Identifier: Apache-2.0
#pragma once

// One camera path and its packet of wavelengths.
//
// All lanes share one ray until the first dispersive boundary. There the path splits: what is
// reflected stays one shared path with each lane's own Fresnel factor; what is refracted opens into
// a ray for each lane, and each lane then decides for itself between reflection and refraction, by
// one random number for all. Where opened lanes meet a rough surface, each takes direct light by
// the same light sample, and two of them go on for all that arrived there with them.
//
// The estimate of lane k is f_k / p_k, with p_k the density of its own vertices: while lanes share
// a path every choice has one density for all of them, and afterwards each has its own. The lane
// that goes on is weighted by the inverse of the expected number of times that it does.
//
// Behind a lens with dispersion a path begins open. All lanes start at one point of the lens, whose
// density is the same for each, so that it cancels against the mean over the aperture that a pixel
// shows, and each lane begins with the throughput 1.
//
// Radiance is carried divided by the square of the index, which no boundary changes; the factor is
// put back where light is found. [L / n² is invariant: Nicodemus 1963]
//
// shared_path.cpp follows lanes on one ray, open_path.cpp lanes on rays of their own,
// path_light.cpp adds the light that they find, tracer.cpp holds what these share.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "dewbow/base/random.h"
#include "dewbow/render/path/path.h"
#include "dewbow/render/surface/local_frame.h"
#include "dewbow/render/surface/rough_dielectric.h"
#include "dewbow/render/surface/scattering_surface.h"
#include "dewbow/render/surface_inputs.h"
#include "dewbow/render/vertex.h"

namespace dewbow::path_tracing {

/// Indices that agree to this bend all lanes alike: ten roundings.
inline constexpr double kSameIndex = 1e-14;

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
    Receiver last_receiver;
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
    std::array<Receiver, kMaxLanes> last_receiver;
};

/// Spectra of RGB colours at the packet's wavelengths.
struct RgbLanesOfPath {
    RgbLightLanes light;
    RgbReflectanceLanes reflectance;
};

class Tracer {
public:
    Tracer(const PreparedScene& prepared, const WavelengthPacket& packet, const SampleKey& key,
           MediaStack start, PacketMedia& media, RgbLanesOfPath& rgb,
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
    /// Each lane on its own ray from the start; `first` is what the layers see.
    PixelSample run_open(const Ray& first, const RayLanes& rays, MediaStack media);

private:
    void finish_pending();
    void trace(SharedPath path);
    bool interact(SharedPath& path, const Hit& hit);
    bool scatter(SharedPath& path, const Vertex& vertex, const Material& material,
                 bool take_direct);
    ScatteringSurface surface_at(const SharedPath& path, const Vertex& vertex,
                                 const LocalFrame& frame, const Material& material);
    bool reflect(SharedPath& path, const Vertex& vertex);
    bool mirror(SharedPath& path, const Vertex& vertex, const Mirror& mirror);
    bool metal(SharedPath& path, const Vertex& vertex, const Conductor& conductor);
    bool thin(SharedPath& path, const Vertex& vertex, const ThinDielectric& pane);
    bool smooth(SharedPath& path, const Vertex& vertex, const Dielectric& glass, int id);
    bool rough(SharedPath& path, const Hit& hit, const Dielectric& glass, int id);
    void split_shared(SharedPath& path, const Vertex& vertex, const Dielectric& glass,
                      const Boundary& boundary, const LaneValues& eta);
    void open_transmitted(const SharedPath& path, const Vertex& vertex, const LaneValues& beta,
                          const Boundary& boundary, const LaneValues& eta, Vec3 normal);

    void trace_open(OpenPath path);
    void open_arrive(OpenPath& path, int k, const HitLanes& hits);
    void open_missed(OpenPath& path, int k);
    void open_group(OpenPath& path, LaneMask group, const HitLanes& hits, int material_id);
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
                      double pdf, const Receiver& from, MediaStack media);
    void add_emission(const LaneSet& lanes, const LaneValues& beta, const Ray& ray, const Hit& hit,
                      bool specular, double pdf, const Receiver& from, MediaStack media);
    template <class Eval>
    void direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides, Eval&& eval);
    void direct_scattered(const SharedPath& path, const Vertex& vertex, const LocalFrame& frame,
                          const ScatteringSurface& surface, const Material& material);
    void direct_rough(const SharedPath& path, const Vertex& vertex, const LocalFrame& frame,
                      const RoughDielectric& surface, const Dielectric& glass,
                      const Boundary& boundary);

    // Helpers.
    Vertex vertex_at(const Ray& ray, const Hit& hit) const {
        return dewbow::vertex_at(prepared_, ray, hit);
    }
    bool has_true_normals(int shape) const;
    int material_at(const Ray& ray, const Hit& hit, std::uint32_t vertex) const {
        const int id = prepared_.scene.shapes[std::size_t(hit.shape)].material;
        return std::holds_alternative<Mix>(material(id).surface)
                   ? dewbow::material_at(prepared_, ray, hit, key_, vertex)
                   : id;
    }
    const Material& material(int id) const { return prepared_.scene.materials[std::size_t(id)]; }
    void indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta);
    void index_around(const LaneSet& lanes, MediaStack media, LaneValues& index);
    void absorb(const LaneSet& lanes, LaneValues& beta, MediaStack media, double distance);
    bool stops_shadows(int shape) const { return !prepared_.see_through[std::size_t(shape)]; }
    double choice_at(const OpenPath& path) const;
    bool roulette(LaneValues& beta, int count, LaneMask mask, int depth,
                  std::uint32_t vertex) const;
    std::uint32_t vertex_key(int depth, std::uint32_t branch) const {
        return std::uint32_t(depth) + branch * 0x9e3779b9u;  // 2³² / golden ratio: far apart
    }
    SharedPath lane_of(const OpenPath& path, int k) const;
    static bool dispersive(const LaneValues& eta, int count);
    SurfaceInputs inputs_at(const Vertex& vertex) { return {vertex.at, rgb_.reflectance}; }
    void tint(const ColourInput& tint, const Vertex& vertex, const LaneSet& lanes,
              LaneValues& beta);
    void tint_open(const ColourInput& tint, OpenPath& path, LaneMask mask, const RayLanes& arriving,
                   const HitLanes& hits);

    const PreparedScene& prepared_;
    const RenderSettings& settings_;
    const WavelengthPacket& packet_;
    const SampleKey key_;
    const int start_medium_;
    PacketMedia& packet_media_;
    RgbLanesOfPath& rgb_;
    std::vector<SharedPath>& pending_;  ///< single lanes that go on from something rough
    PixelSample result_;
    std::uint32_t branches_ = 0;
};

}  // namespace dewbow::path_tracing
