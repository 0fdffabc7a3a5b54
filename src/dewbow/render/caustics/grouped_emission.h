// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the maps of all kinds of lamps share: one of the four numbers chooses the group of casters
// that the ray is aimed at, by what the lamp sends there, and is stretched to be used again. A ray
// belongs to the group that it meets first, and those aimed at one behind are given up: so each ray
// comes from one place.

#include "dewbow/math/distribution.h"
#include "dewbow/render/caustics/aims.h"
#include "dewbow/render/caustics/emission_map.h"

namespace dewbow::caustics {

class GroupedEmission : public EmissionMap {
public:
    std::optional<EmittedRay> ray(const std::array<double, 4>& u) const final;
    std::optional<Place> place(const Ray& ray) const final;
    double power() const final { return power_; }

protected:
    /// @param axis  of the number that chooses.
    GroupedEmission(LightSample::Source source, int index, const Aims& aims, std::size_t axis)
        : EmissionMap(source, index), aims_(aims), axis_(axis) {}

    /// A ray towards one target; `pdf` without the choice of the target. A target is a group of
    /// casters, or all of them.
    virtual std::optional<EmittedRay> towards(int target, const std::array<double, 4>& u) const = 0;
    /// The inverse; nothing if the ray does not meet the target.
    virtual std::optional<Place> place_towards(int target, const Ray& ray) const = 0;
    /// Y of what radiance() gives, white 1.
    virtual double brightness(const EmittedRay& ray) const = 0;

    /// Chooses by the mean of brightness / pdf over some rays. To be called once all is ready.
    /// @param targets  how many there are.   @param dark  those that get no light for certain.
    /// @param whole  flux of the whole lamp.
    void weigh(std::size_t targets, const std::vector<bool>& dark, double whole);

    EmittedRay lit(const Ray& ray, double pdf, bool without_extent) const {
        return {ray, source(), index(), without_extent, 1.0, {}, pdf};
    }
    const std::vector<CasterBounds>& groups() const { return aims_.groups; }

private:
    /// The target that the ray belongs to, −1 for none.
    int target_of(const Ray& ray) const;
    std::optional<EmittedRay> first_towards(int target, const std::array<double, 4>& u) const;

    const Aims& aims_;
    std::size_t axis_;
    bool one_ = false;                      ///< one target for all groups
    std::optional<Distribution1D> choose_;  ///< nothing: it gives none light
    double power_ = 0.0;
};

/// The number by which `distribution` gives a place in a cell.
double number_of(const Distribution1D& distribution, std::size_t cell, double offset);

}  // namespace dewbow::caustics
