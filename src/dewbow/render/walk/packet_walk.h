// SPDX-License-Identifier: Apache-2.0
#pragma once

// A packet of wavelengths on its way through a scene, from surface to surface. The walk knows no
// light and no camera: what those make of it is told by its hooks (CameraWalk, LightWalk).
//
// All lanes share one ray until the first dispersive boundary. There the path splits: what is
// reflected stays one shared path with each lane's own Fresnel factor; what is refracted opens into
// a ray for each lane, and each lane then decides for itself between reflection and refraction, by
// one random number for all. Where opened lanes meet a rough surface, each of them is shown to the
// hook, and two of them go on for all that arrived there with them.
//
// The estimate of lane k is f_k / p_k, with p_k the density of its own vertices: while lanes share
// a path every choice has one density for all of them, and afterwards each has its own. The lane
// that goes on is weighted by the inverse of the expected number of times that it does.
//
// Radiance is carried divided by the square of the index, which no boundary changes.
// [L / n² is invariant: Nicodemus 1963]
//
// shared_walk.cpp follows lanes on one ray, open_walk.cpp lanes on rays of their own, rain_walk.cpp
// both where drops turn them; packet_walk.cpp holds what all need.

#include <cmath>

#include "dewbow/base/random.h"
#include "dewbow/render/surface/local_frame.h"
#include "dewbow/render/surface/rough_dielectric.h"
#include "dewbow/render/surface/scattering_surface.h"
#include "dewbow/render/surface_inputs.h"
#include "dewbow/render/vertex.h"
#include "dewbow/render/walk/walk_memory.h"

namespace dewbow::walk {

/// Where a walk starts, and so which way light goes along it. Shading normals make a difference.
enum class Start { camera, lamp };

/// A rough surface as a path meets it.
struct Scatterer {
    const Hit& hit;
    const Vertex& vertex;
    const LocalFrame& frame;
    const Material& material;
    const ScatteringSurface& surface;  ///< in `frame`, seen from where the path comes from
};

/// A rough boundary as one lane meets it.
struct RoughGlass {
    const Hit& hit;
    const Vertex& vertex;
    const LocalFrame& frame;
    const Dielectric& glass;
    const Boundary& boundary;
    double alpha, eta;               ///< n of the far side over that of the near one
    const RoughDielectric& surface;  ///< in `frame`, seen from where the path comes from
};

/// What a medium does to the lanes of a path, m⁻¹.
struct HazeLanes {
    LaneValues scattering, extinction;
};

class PacketWalk {
public:
    PacketWalk(Start start, const PreparedScene& prepared, const WavelengthPacket& packet,
               const SampleKey& key);
    virtual ~PacketWalk() = default;

protected:
    PacketWalk(const PacketWalk&) = delete;
    PacketWalk& operator=(const PacketWalk&) = delete;

    /// All lanes at the start of `ray`, which lies in `media`.
    SharedPath shared_start(const Ray& ray, MediaStack media) const;
    /// Each lane at the start of its own ray.
    OpenPath open_start(const RayLanes& rays, MediaStack media) const;
    /// Follows a path, and all that it becomes, to their ends.
    void follow(const SharedPath& path);
    void follow(const OpenPath& path);

    // Hooks. A path of opened lanes is shown lane by lane.
    /// It met a surface of that material, with all its lanes on one ray.
    virtual void on_surface(const SharedPath&, const Vertex&, int /*material*/) {}
    /// It met what scatters, and has not been turned yet. False: all its lanes on one ray end here.
    virtual bool on_scatterer(const SharedPath&, const Scatterer&) { return true; }
    /// It goes on from there along its ray, which is the direction `wi` in the surface's frame.
    virtual void on_scattered(SharedPath&, const Scatterer&, Vec3 /*wi*/) {}
    /// One lane met rough glass, and has not been turned yet.
    virtual void on_rough_glass(const SharedPath&, const RoughGlass&) {}
    /// It goes on from there along its ray.
    virtual void on_rough_turn(SharedPath&, const RoughGlass&) {}
    /// It ran into the glowing side of a surface that gives light.
    virtual void on_lamp(const SharedPath&, const Hit&) {}
    /// It goes through what scatters, haze or weather, to the surface that it meets, if any. What
    /// that takes away on this way has not been taken yet.
    virtual void on_flight(const SharedPath&, const Hit&) {}
    /// It looks along its way to what it meets, from the camera or by way of smooth surfaces alone,
    /// through the surroundings of a scene with the paper's rainbow.
    virtual void on_sight(SharedPath&, const Hit&) {}
    /// It ran into nothing.
    virtual void on_leaving(const SharedPath&) {}
    /// The number in [0, 1) by which opened lanes choose between reflection and refraction.
    virtual double choice_of_lanes(const OpenPath& path) const {
        return key_.one(vertex_key(path.depth, path.branch), Purpose::bsdf_lobe);
    }

    // For hooks.
    Vertex vertex_at(const Ray& ray, const Hit& hit) const {
        return dewbow::vertex_at(prepared_, ray, hit);
    }
    int material_at(const Ray& ray, const Hit& hit, std::uint32_t vertex) const {
        const int id = prepared_.scene.shapes[std::size_t(hit.shape)].material;
        return std::holds_alternative<Mix>(material(id).surface)
                   ? dewbow::material_at(prepared_, ray, hit, key_, vertex)
                   : id;
    }
    /// What colours of light and of surfaces are at the packet's wavelengths.
    RgbLightLanes& light_colours() { return memory_.light; }
    RgbReflectanceLanes& share_colours() { return memory_.reflectance; }
    PacketMedia& packet_media() { return *memory_.media; }
    PacketWeather& packet_weather() { return memory_.weather; }
    RainMemory& rain_memory() { return memory_.rain; }
    /// Seen from vertex.wo, in `media`.
    ScatteringSurface surface_at(const LaneSet& lanes, MediaStack media, const Vertex& vertex,
                                 const LocalFrame& frame, const Material& material);
    HazeLanes haze_around(const LaneSet& lanes, MediaStack media);
    /// Whether the medium of a flight scatters.
    bool in_haze(MediaStack media) {
        return prepared_.haze && packet_media().scattering(media.interior());
    }
    /// Whether a flight goes through the surroundings, and there is weather.
    bool in_weather(MediaStack media) const { return prepared_.weather && media.interior() == 0; }
    /// Multiplies by what is left at the end of a way through `media`: of the medium, which takes
    /// nothing from what is infinitely far, and of the weather.
    void absorb(const Way& way, const LaneSet& lanes, LaneValues& beta, MediaStack media);
    /// The weather's part of it, in the surroundings.
    void dim(const Way& way, const LaneSet& lanes, LaneValues& beta);
    void tint(const ColourInput& tint, const Vertex& vertex, const LaneSet& lanes,
              LaneValues& beta);
    /// The flight of a path to `hit`, along which light goes.
    static Way flight(const SharedPath& path, const Hit& hit);
    /// From a point of a path to a light or a camera; `at` tells its random numbers apart.
    static Way shadow_way(Vec3 from, Vec3 direction, double length, std::uint32_t at) {
        return {from, direction, length, at, Purpose::rain_to_light};
    }
    /// Of a path's next flight.
    static std::uint32_t flight_key(const SharedPath& path) {
        return vertex_key(path.depth, path.branch) + std::uint32_t(path.passed) * 0x85ebca6bu;
    }
    static std::uint32_t vertex_key(int depth, std::uint32_t branch) {
        return std::uint32_t(depth) + branch * 0x9e3779b9u;  // 2³² / golden ratio: far apart
    }

    const PreparedScene& prepared_;
    const RenderSettings& settings_;
    const WavelengthPacket& packet_;
    const SampleKey key_;

private:
    // Lanes on one ray. What returns false ends the path.
    void trace(SharedPath path);
    void finish_pending();
    bool interact(SharedPath& path, const Hit& hit);
    // In rain of which higher orders of light are looked for (rain_walk.cpp).
    enum class Flight { straight, turned, ended };
    bool may_meet_drops(const SharedPath& path) const;
    Flight fly_in_rain(SharedPath& path, const Hit& hit);
    bool turn_by_drop(SharedPath& path, const Way& way, double distance, double pdf);
    bool open_in_rain(OpenPath& path, int k, const Hit& hit);
    bool scatter(SharedPath& path, const Hit& hit, const Vertex& vertex, const Material& material,
                 bool show);
    void turn(SharedPath& path, const Vertex& vertex, Vec3 normal, Vec3 direction) const;
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

    // Lanes on rays of their own.
    void trace_open(OpenPath path);
    void open_arrive(OpenPath& path, int k, const HitLanes& hits);
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
    SharedPath lane_of(const OpenPath& path, int k) const;

    // Both.
    const Material& material(int id) const { return prepared_.scene.materials[std::size_t(id)]; }
    bool has_true_normals(int shape) const;
    double shading_factor(const Vertex& vertex, Vec3 shading, Vec3 next) const;
    /// Whether light is scattered on the way there, and such paths are looked for.
    bool scatters(MediaStack media, int depth) {
        return depth < settings_.max_depth && (in_haze(media) || in_weather(media));
    }
    bool sees_fog(MediaStack media, bool scattered) const {
        return prepared_.paper_fog && start_ == Start::camera && !scattered &&
               media.interior() == 0;
    }
    bool stops_shadows(int shape) const { return !prepared_.see_through[std::size_t(shape)]; }
    void indices(const LaneSet& lanes, const Boundary& boundary, LaneValues& eta);
    void index_around(const LaneSet& lanes, MediaStack media, LaneValues& index);
    static bool dispersive(const LaneValues& eta, int count);
    bool roulette(LaneValues& beta, int count, LaneMask mask, int depth,
                  std::uint32_t vertex) const;
    SurfaceInputs inputs_at(const Vertex& vertex) { return {vertex.at, memory_.reflectance}; }
    void tint_open(const ColourInput& tint, OpenPath& path, LaneMask mask, const RayLanes& arriving,
                   const HitLanes& hits);

    const Start start_;
    WalkMemory& memory_;
    std::uint32_t branches_ = 0;
};

/// Indices that agree to this bend all lanes alike: ten roundings.
inline constexpr double kSameIndex = 1e-14;

}  // namespace dewbow::walk
