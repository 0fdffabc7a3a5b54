// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/caustics/weights.h"
#include "dewbow/render/film.h"
#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::walk {

/// A point of a flight where drops are, as what lights it needs it.
struct RainPoint {
    const Way& flight;
    Vec3 position;
    std::uint32_t at;  ///< of its random numbers
    double metres;     ///< RainLight::Sample::metres
    LaneValues left;   ///< of light on the flight to there
    /// One a rain of the scene: its density there, 0 outside of it.
    std::span<const double> density;
};

/// A path from the camera. At each rough surface it asks one light for direct light, and what it
/// runs into that gives light counts too; the power heuristic weighs both, and light paths where
/// there are any (caustics/weights.h).                                       [Veach 1997, 9.2]
///
/// Behind a lens with dispersion a path begins open. All lanes start at one point of the lens,
/// whose density is the same for each, so that it cancels against the mean over the aperture that a
/// pixel shows, and each lane begins with the throughput 1.
///
/// A path's note is what the density of a lamp's ray is multiplied with to be the number of light
/// paths for each camera path, in m² sr; 0 where light paths do not come.
class CameraWalk : public PacketWalk {
public:
    /// @param light_paths  those of this render, or nullptr.
    CameraWalk(const PreparedScene& prepared, const caustics::LightPaths* light_paths,
               const WavelengthPacket& packet, const SampleKey& key, MediaStack start);

    PixelSample run(const Ray& ray);
    /// Each lane on its own ray from the start; `first` is what the layers see.
    PixelSample run_open(const Ray& first, const RayLanes& rays);

protected:
    void on_flight(const SharedPath& path, const Hit& hit) override;
    void on_leaving(const SharedPath& path) override;
    /// Radiance that arrives at the end of the path.
    void add(const SharedPath& path, const LaneValues& radiance, double weight);

private:
    void on_surface(const SharedPath& path, const Vertex& vertex, int material) override;
    bool on_scatterer(const SharedPath& path, const Scatterer& at) override;
    void on_scattered(SharedPath& path, const Scatterer& at, Vec3 wi) override;
    void on_rough_glass(const SharedPath& lane, const RoughGlass& at) override;
    void on_lamp(const SharedPath& path, const Hit& hit) override;
    void on_sight(SharedPath& path, const Hit& hit) override;
    double choice_of_lanes(const OpenPath& path) const override;

    PixelSample behind_polariser();
    template <class Eval>
    void direct_light(const SharedPath& path, const Vertex& vertex, bool both_sides, double note,
                      Eval&& eval);
    double weight_of_direct(const LightSample& light, Vec3 receiver, double chance,
                            double note) const;
    static bool shared_with_light(const SharedPath& path);
    static bool found_at_drop(const SharedPath& path);
    static double weight_of_chance(const SharedPath& path, double next_event, double density);
    void light_in_haze(const SharedPath& path, const Hit& hit);
    void light_of_air(const SharedPath& path, const Hit& hit);
    void air_before_rain(const SharedPath& path, const Way& way);
    void light_in_rain(const SharedPath& path, const Hit& hit);
    void sun_in_rain(const SharedPath& path, const Way& way, std::size_t sun);
    void mirror_in_rain(const RainSun& sun, const Way& way, const ReflectanceLanes& shares,
                        const LaneSet& lanes, std::span<RainLight::RainLanes> rains) const;
    static Way way_to_mirror(const RainSun& sun, Vec3 point, std::uint32_t at);
    void dim_to_sun(const RainSun& sun, Vec3 point, std::uint32_t at, const LaneSet& lanes,
                    LaneValues& radiance);
    void sun_at_point_of_rain(const SharedPath& path, const Way& way, const RainSun& sun,
                              const RainLight::Sample& sample, std::uint32_t at, double share);
    void sky_in_rain(const SharedPath& path, const Way& way);
    std::optional<RainLight::Sample> point_in_rain(const SharedPath& path, const Way& way,
                                                   double u);
    void direct_light_in_rain(const SharedPath& path, const RainPoint& at, double chance,
                              double u_choice, std::array<double, 2> u);
    void sky_by_chance_in_rain(const SharedPath& path, const RainPoint& at, double u_rain,
                               std::array<double, 2> u);
    void set_extinction_of_rains(const LaneSet& lanes);
    std::span<const double> haze_on(const SharedPath& path, LaneValues& extinction);
    double density_in_rain(const RainPoint& at, double cosine) const;
    bool scattered_in_rain(const SharedPath& path, const RainPoint& at, Vec3 towards,
                           double distance, LaneValues& radiance);
    bool left_to_light_paths(const SharedPath& path, Vec3 point, const LightSample& light) const;

    const caustics::LightPaths* light_paths_;
    const MediaStack start_;
    Vec3 eye_;  ///< where the camera's rays start, a point of the lens
    PixelSample result_;
};

}  // namespace dewbow::walk
