// SPDX-License-Identifier: Apache-2.0
#pragma once

// How much rain there is: drops, water that falls, or light that is lost.

#include <span>
#include <variant>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/drop_sizes.h"

namespace dewbow {

struct DropsPerVolume {
    double per_m3 = 0.0;
};
/// Of drops that fall as fast as in calm air.
struct RainRate {
    double mm_per_hour = 0.0;
};
/// At kExtinctionWavelength, as the law of rain has it (drop_cloud.h): without the light that
/// diffraction sends straight on.
struct RainExtinction {
    double per_m = 0.0;
};
using RainAmount = std::variant<DropsPerVolume, RainRate, RainExtinction>;

inline constexpr Wavelength kExtinctionWavelength = 550.0 * unit::nm;

/// How fast a drop falls in calm air of 20 °C and 1013 hPa, in m/s, by the radius of the sphere of
/// equal volume.             [Gunn & Kinzer, J. Meteor. 6, 243 (1949), table 2, linear between
/// rows] Below the table, 0.1 mm across, in proportion to the square (Stokes); above it, 5.8 mm, as
/// fast as there.
double fall_speed(Length radius);

/// ⟨4/3 π r³ v⟩ in m⁴/s: rain of one drop a cubic metre.
double mean_rain_flux(const DropSizes& sizes);

/// Geometric cross section Σ N πa² of the drops in a cubic metre, in m⁻¹.
/// @param showers     kinds of drops, each with the same part of that cross section; at least one.
/// @param efficiency  extinction as the law of rain has it over the geometric cross section.
double cross_section_per_volume(const RainAmount& amount, std::span<const DropSizesPtr> showers,
                                double efficiency);
/// The other way: of rain with 1 m⁻¹ of geometric cross section.
double rain_rate_per_cross_section(std::span<const DropSizesPtr> showers);  ///< mm/h
double number_per_cross_section(std::span<const DropSizesPtr> showers);     ///< m⁻³
/// Volume of the drops over that of the air.
double water_per_cross_section(std::span<const DropSizesPtr> showers);

}  // namespace dewbow
