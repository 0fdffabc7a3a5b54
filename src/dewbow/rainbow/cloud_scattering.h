// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light scattered by drops of many sizes together, by wavelength and angle: what a table is made of
// before the sun's disc.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/dispersion.h"
#include "dewbow/rainbow/cloud_shapes.h"
#include "dewbow/rainbow/drop_sizes.h"
#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/rainbow/size_sampling.h"

namespace dewbow {

/// What drops are made of and what they fall through; both against vacuum. The index that counts is
/// the quotient, and the wave number is that around the drop.
struct DropOptics {
    DispersionPtr drop, around;
    double extinction = 0.0;  ///< k of the drop against what is around it
    RelativeIndex index(Wavelength lambda) const { return (*drop)(lambda) / (*around)(lambda); }
    ComplexIndex complex_index(Wavelength lambda) const {
        return {index(lambda).value, extinction};
    }
    /// 2πa n_around / λ.
    double size_parameter(Length radius, Wavelength lambda) const;
};

/// Drops in classes of one radius each.
struct Cloud {
    DropOptics optics;
    std::vector<WeightedRadius> radii;    ///< ascending
    std::optional<FallingShape> falling;  ///< nothing: spheres
};

/// Sums over drops, each times its share.
struct DropSums {
    std::vector<Intensities> intensities;  ///< Σ |S|², [angle]
    double x_squared = 0.0;                ///< Σ x²
    Efficiencies efficiencies;             ///< weighted by x²; g by scattering

    void add(const DropSums& other);
};

struct CloudScattering {
    std::vector<DropSums> sums;  ///< [wavelength]
    std::string report;          ///< what was computed, for people
    double stated_error = 0.0;   ///< see ScatteringTable
};

/// By one model, wavelength by wavelength. Throws InputError as the model does.
CloudScattering scatter(const ScatteringModel& model, const Cloud& cloud,
                        std::span<const Wavelength> wavelengths, std::span<const Angle> angles);

/// By Mie theory at one wavelength, which gives efficiencies on the way.
DropSums scatter_exactly(const Cloud& cloud, Wavelength lambda, std::span<const Angle> angles);

/// Calls body(i) for i < count in parallel; throws what the first of them threw, in order of i.
void parallel_or_throw(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace dewbow
