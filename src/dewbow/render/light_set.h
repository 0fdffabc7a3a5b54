// SPDX-License-Identifier: Apache-2.0
#pragma once

// All lights of a scene, chosen and sampled for direct light.

#include <optional>

#include "dewbow/math/distribution.h"
#include "dewbow/render/environment.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/rgb_lanes.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

/// A direction towards a light.
struct LightSample {
    int light = -1;
    Vec3 direction;
    double distance = 0.0;  ///< infinite for what is infinitely far
    /// Density per steradian, choice of the light included. A light without extent has the density
    /// of its choice alone, and `factor` holds what distance and cone make of its intensity.
    double pdf = 0.0;
    double factor = 1.0;
    bool without_extent = false;
};

class LightSet {
public:
    explicit LightSet(const Scene& scene);

    /// A direction from `from` to some light: nothing if the one chosen is not visible from there.
    std::optional<LightSample> sample(Vec3 from, double u_choice, std::array<double, 2> u) const;
    /// Radiance (for lights without extent: irradiance on a surface that faces it, per pdf) that
    /// arrives by `sample`.
    void radiance(const LightSample& sample, const LaneSet& lanes, RgbLightLanes& rgb,
                  LaneValues& out) const;

    /// Whether the surface of `hit` gives off light to where the ray along `direction` comes from.
    bool emits(const Hit& hit, Vec3 direction) const;
    /// Radiance of the emitting surface at `hit`.
    void emission(const Hit& hit, const LaneSet& lanes, LaneValues& out) const;
    /// Density with which sample() would have taken this direction to the emitting surface at
    /// `hit`.
    double pdf_of_hit(Vec3 from, Vec3 direction, const Hit& hit) const;

    /// The lights that are infinitely far and can be seen.
    int infinite_count() const { return int(infinite_.size()); }
    /// Radiance of the `i`-th of them along `direction`; false if it is not there.
    bool infinite_radiance(int i, Vec3 direction, const LaneSet& lanes, RgbLightLanes& rgb,
                           LaneValues& out) const;
    double pdf_of_infinite(int i, Vec3 direction) const;

private:
    enum class Kind { triangles, disc, sphere, ellipsoid, point, spot, distant, uniform, image };
    struct Entry {
        Kind kind = Kind::point;
        SpectrumPtr spectrum;
        int shape = -1;
        bool two_sided = false;
        double area = 0.0;           // triangles, disc
        double power = 0.0;          // relative, for the choice
        Vec3 position, axis;         // of spots, distant lights, spheres
        double radius = 0.0;         // of spheres in the world's frame, of discs in their own
        double object_radius = 0.0;  // of spheres and ellipsoids in their own frame
        double cone_width = 0.0;     // 1 − cos of the half angle: distant
        double cos_scale = 0.0, cos_offset = 0.0;
        std::vector<std::array<Vec3, 3>> corners;
        std::optional<Distribution1D> by_area;
        std::optional<EnvironmentMap> map;
        Transform<World, Object> world_from_object;
    };
    struct SurfacePoint {
        Vec3 position, normal;
        double pdf_area;
    };
    void add_shape_light(const Scene& scene, int shape);
    void add_light(const Light& light, double scene_radius);
    static SurfacePoint sample_surface(const Entry& entry, std::array<double, 2> u);
    static double pdf_area(const Entry& entry, Vec3 point);
    double choice(int light) const { return choose_->probability(std::size_t(light)); }

    std::vector<Entry> lights_;
    std::vector<int> infinite_;
    std::vector<int> light_of_shape_;
    std::optional<Distribution1D> choose_;
};

}  // namespace dewbow
