// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays that leave a lamp towards casters, as a map from the unit cube: uniform numbers become rays
// of known density, and each ray finds back the numbers that give it, so that a density on the cube
// (learnt_density.h) is one on rays.
//
// Densities are of rays: per m² of area perpendicular to the ray and per sr. Of lamps that are a
// point they are per sr, of parallel light per m². The power that a ray stands for is
// radiance / density.

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "dewbow/render/caustics/casters.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/prepared_scene.h"

namespace dewbow::caustics {

struct EmittedRay {
    Ray ray;  ///< away from the lamp; `from` names the lamp's surface, if it has one
    LightSample::Source source = LightSample::Source::shape;
    int index = 0;  ///< among those of its source, as in LightSample
    /// A point or parallel light: no ray finds it by chance.
    bool without_extent = false;
    double factor = 1.0;          ///< on its spectrum: fall-off of a spot, opacity of a surface
    Colour<LinearSrgb> colour{};  ///< of a surface that glows in colours
    /// m⁻² sr⁻¹; without extent: sr⁻¹ of points (point, spot, profile), m⁻² of parallel light.
    double pdf = 0.0;
};

/// What the ray carries at each lane: radiance, W m⁻² sr⁻¹ nm⁻¹; of points intensity, W sr⁻¹ nm⁻¹;
/// of parallel light irradiance, W m⁻² nm⁻¹. Not divided by pdf.
void radiance(const EmittedRay& ray, const LightSet& lights, const LaneSet& lanes,
              RgbLightLanes& rgb, LaneValues& out);

/// The rays of one lamp.
class EmissionMap {
public:
    virtual ~EmissionMap() = default;

    LightSample::Source source() const { return source_; }
    int index() const { return index_; }
    /// The first two numbers are the place, the last two the direction; of lamps without extent
    /// only two count, and the others are not looked at.
    ///
    /// Nothing where the numbers give no ray towards a caster; their share is lost.
    virtual std::optional<EmittedRay> ray(const std::array<double, 4>& u) const = 0;

    struct Place {
        std::array<double, 4> u;  ///< those that do not count are 0.5
        double pdf;               ///< > 0, in the unit of EmittedRay::pdf
    };
    /// The place that gives `ray`, which leaves this lamp; nothing if it can give no such ray.
    /// @param ray  as ray() gives it. Its `from` is looked at if the lamp is a surface. Of lamps
    /// infinitely far the origin may lie anywhere along the ray.
    virtual std::optional<Place> place(const Ray& ray) const = 0;

    /// About the flux towards the casters (Y of W nm⁻¹, white 1), were nothing in between. 0 only
    /// if there is none for certain.
    virtual double power() const = 0;

protected:
    EmissionMap(LightSample::Source source, int index) : source_(source), index_(index) {}

private:
    LightSample::Source source_;
    int index_;
};

struct Aims;

/// All lamps of a scene: shapes, then points, beams, and what is infinitely far, in LightSet's
/// order. Lamps that shine on no caster are there, and give nothing.
class EmissionMaps {
public:
    /// All must outlive this.
    EmissionMaps(const PreparedScene& prepared, const Casters& casters);
    ~EmissionMaps();

    int size() const { return int(maps_.size()); }
    const EmissionMap& operator[](int i) const { return *maps_[std::size_t(i)]; }
    /// Which of them it is.
    int of(LightSample::Source source, int index) const {
        return first_[std::size_t(source)] + index;
    }

private:
    std::unique_ptr<const Aims> aims_;
    std::vector<std::unique_ptr<const EmissionMap>> maps_;
    std::array<int, 4> first_{};  ///< of each source
};

}  // namespace dewbow::caustics
