// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model `auto`: the cheapest way that holds a stated error, by size and by angle.
//
// What it chooses from, measured against Mie (automatic_error.h):
// - Mie theory for drops with x < 200, for one size alone, and for drops that absorb: exact.
// - For larger drops whose sizes differ by so much that light of different orders no longer
//   interferes on average, the sum of orders (Composition). It costs about the same for any number
//   of radii and of wavelengths.
// - At angles where that sum is not good enough, Mie theory as well, at some of the radii and some
//   of the wavelengths: what it adds to the sum is smooth, goes like 1/x, and is interpolated.

#include <memory>
#include <span>

#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/models.h"

namespace dewbow {

/// All drops at all wavelengths: what the table uses. [wavelength].
/// `options.averaging` says what will be done to the result; `options.tolerance` is the error that
/// is allowed, |ΔI| over the larger of I and the primary bow's peak, for light without
/// polarisation. The error stated is at most that. Throws InputError for drops that Mie theory
/// cannot treat, and for orders outside 0 to 7.
CloudScattering scatter_automatically(const Cloud& cloud, std::span<const Wavelength> wavelengths,
                                      std::span<const Angle> angles, const ModelOptions& options);

/// The same for one wavelength, drop by drop, with Mie theory at all radii: slower.
std::unique_ptr<ScatteringModel> make_automatic(const ModelOptions& options);

}  // namespace dewbow
