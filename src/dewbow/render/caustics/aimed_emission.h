// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light paths begin here: a lamp is chosen, and one of its rays towards the casters. Both choices
// follow one density of random numbers, which is uniform on their cube until it has been learnt
// (training.h). Uniform numbers choose lamps by what they send towards casters, were nothing in
// between.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/base/random.h"
#include "dewbow/render/caustics/emission_map.h"
#include "dewbow/render/caustics/learnt_density.h"

namespace dewbow::caustics {

/// Immutable but for learn().
class AimedEmission {
public:
    /// `prepared` must outlive this.
    explicit AimedEmission(const PreparedScene& prepared);
    AimedEmission(const AimedEmission&) = delete;
    AimedEmission& operator=(const AimedEmission&) = delete;

    /// No lamp shines on a caster: there are no light paths.
    bool empty() const { return edges_.back() == 0.0; }

    /// A ray, whose pdf includes the choice of the lamp. Nothing where the numbers give none; their
    /// share is lost. Stratified numbers give stratified rays.
    std::optional<EmittedRay> sample(double u_light, const std::array<double, 4>& u) const;
    /// The numbers of a light path that sample() takes: those of the ray are stratified together.
    static AimPoint numbers(const SampleKey& key);
    std::optional<EmittedRay> sample(const SampleKey& key) const { return aim(numbers(key)).ray; }
    /// What `ray` carries at each lane; not divided by pdf.
    void radiance(const EmittedRay& ray, const LaneSet& lanes, RgbLightLanes& rgb,
                  LaneValues& out) const {
        caustics::radiance(ray, prepared_.lights, lanes, rgb, out);
    }

    // Density with which sample() gives the ray that a camera ray has found backwards, m⁻² sr⁻¹;
    // 0 if it cannot.
    /// @param lamp  the glowing surface that `camera_ray` meets at `point`.
    double density_of_hit(const Hit& lamp, Vec3 point, const Ray& camera_ray) const;
    /// @param i  number of the light among the infinitely far ones, which `camera_ray` leaves for.
    double density_of_infinite(int i, const Ray& camera_ray) const;

    /// @param light  that direct light at `receiver` takes. Of light without extent it is what
    /// sample() would do before it has learnt, in EmittedRay's units: numbers that such a light
    /// does not look at tell what is learnt, too, and no ray tells them.
    double density_of_sample(const LightSample& light, Vec3 receiver) const;

    // For training.
    /// What sample() does in two steps, so that there is more to learn from.
    struct Aim {
        AimPoint at;     ///< on the cube
        double density;  ///< of the point there
        std::optional<EmittedRay> ray;
    };
    Aim aim(const AimPoint& u) const;
    /// Where along the first coordinate one lamp ends and the next begins.
    std::span<const double> lamp_edges() const { return std::span(edges_).subspan(1); }
    void learn(LearntDensity density) { density_ = std::move(density); }

private:
    std::size_t lamp_at(double choice) const;
    double density_of(std::size_t lamp, const Ray& ray) const;

    const PreparedScene& prepared_;
    Casters casters_;
    EmissionMaps maps_;
    std::vector<double> edges_;  ///< lamp i is chosen in [edges_[i], edges_[i + 1])
    LearntDensity density_;
};

}  // namespace dewbow::caustics
