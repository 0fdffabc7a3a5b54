// SPDX-License-Identifier: Apache-2.0
#pragma once

// storm.toml: what drops a rainbow is made of, what light, and how it is computed. The same may be
// said by options of `dewbow rainbow`; docs/rainbow.md is the manual of both.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/import/range.h"
#include "dewbow/optics/glass.h"
#include "dewbow/rainbow/drop_sizes.h"
#include "dewbow/rainbow/scattering.h"
#include "dewbow/spectrum/lamp.h"

namespace dewbow {

/// Which part of the light counts, by the plane of the sun's ray and the eye's.
enum class Polarisation { unpolarised, perpendicular, parallel };
const std::vector<std::string>& polarisation_names();

enum class DropShape { sphere, oblate };
const std::vector<std::string>& drop_shape_names();

/// A rainbow as it is asked for. What nobody said is nothing, or empty.
struct Storm {
    std::vector<std::string> models;  ///< the first makes the table, the others stand beside it
    Orders orders;
    std::optional<double> tolerance;
    std::optional<bool> paper;  ///< as Musgrave published it in 1989

    // The drops: of water in air, or of an index.
    /// One entry for each shower; they hold as much of the drops' cross section as each other.
    std::vector<DropSizesPtr> sizes;
    std::optional<DropShape> shape;
    std::optional<double> oscillation;  ///< of flattened drops, as ShapeSpread
    std::optional<Angle> tilt;
    std::optional<Glass> water, air;
    std::optional<ComplexIndex> index;  ///< against what is around the drops

    // The sun.
    const Lamp* illuminant = nullptr;
    std::optional<Angle> sun_altitude, sun_radius;
    std::optional<double> limb_darkening;
    std::optional<bool> reddened;  ///< by the air that a low sun shines through
    std::optional<double> haze;    ///< optical depth of that air's aerosol at 500 nm

    // What is looked at.
    std::vector<Wavelength> wavelengths;  ///< in vacuum, ascending
    std::vector<Angle> angles;            ///< scattering angles, ascending
    std::optional<Polarisation> polarisation;
    std::optional<Angle> polariser;    ///< of its axis from the vertical
    std::optional<Angle> clock_angle;  ///< around the bow, from its top
};

/// `storm` with what `above` says instead. An index takes the place of water and air, and the other
/// way round.
Storm with_above(Storm storm, const Storm& above);

/// Throws InputError with line, column and excerpt: no TOML, unknown keys with the nearest word,
/// values of a wrong kind or outside their range, two keys that contradict each other.
Storm load_storm(const std::filesystem::path& path);
/// The same of text in memory; `file` is for messages.
Storm parse_storm(const std::string& file, std::string text);

/// `from`, `from` + `step`, … up to `to`, which is one of them if it is within a millionth of a
/// step.
std::vector<double> stepped(double from, double to, double step);

// What each of these takes, in files and as options.
inline constexpr Range kDropRadii_mm{kLeastDropRadius.to(unit::mm), kMostDropRadius.to(unit::mm)};
inline constexpr Range kOscillations{0.0, 1.0};
inline constexpr Range kTilts_deg{0.0, 30.0};
inline constexpr Range kHazes{0.0, 5.0};
inline constexpr Range kTolerances{1e-4, 0.5};
inline constexpr Range kSunAltitudes_deg{0.0, 90.0};
inline constexpr Range kSunRadii_deg{0.0, 5.0};
inline constexpr Range kRainbowWavelengths_nm{100.0, 20000.0};
inline constexpr Range kScatteringAngles_deg{0.0, 180.0};
inline constexpr Range kPolariserAngles_deg{-360.0, 360.0};
inline constexpr Range kClockAngles_deg{-180.0, 180.0};
inline constexpr Range kDropIndices{1.0, 10.0, true, false};
inline constexpr Range kDropExtinctions{0.0, 10.0};
inline constexpr std::size_t kMostListed = 100'000;  ///< wavelengths or angles

}  // namespace dewbow
