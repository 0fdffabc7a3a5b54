// SPDX-License-Identifier: Apache-2.0
#pragma once

// The keys that say what drops there are and how light in them is computed: those of storm.toml,
// and of each [[rain]] of a scene file.

#include <filesystem>
#include <span>

#include "dewbow/import/toml/storm.h"
#include "dewbow/import/toml/table.h"
#include "dewbow/rainbow/cloud_scattering.h"

namespace dewbow::toml_import {

/// `model`, `orders`, `tolerance`, and all about the drops, into `storm`.
/// @param folder  where files of glasses lie.   Throws InputError with its place.
void read_storm_drops(Table& table, const std::filesystem::path& folder, Storm& storm);

}  // namespace dewbow::toml_import

namespace dewbow {

/// Of what drops are, and in what they fall, where nobody says.
inline constexpr const char *kDropWater = "water@20C", *kDropAir = "air";
/// The mean of sodium's lines D1 and D2 in vacuum, for what is asked of one wavelength.
inline constexpr Wavelength kSodium = 589.46 * unit::nm;

/// What the storm's drops are of, and in what they fall. Throws InputError: no data at one of
/// `wavelengths`, an index of 1 or less.
DropOptics drop_optics(const Storm& storm, std::span<const Wavelength> wavelengths);

}  // namespace dewbow
