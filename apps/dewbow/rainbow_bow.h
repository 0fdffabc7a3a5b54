// SPDX-License-Identifier: Apache-2.0
#pragma once

// The bow that pictures show.

#include "dewbow/export/bow_picture.h"
#include "rainbow_tables.h"

namespace dewbow {

/// Its colours under the clock angle that was asked for, at the angles that were asked for, or else
/// these.
BowAround bow_of(RainbowTables& tables, const std::vector<Angle>& angles);
/// The same under all clock angles, where they differ.
BowAround bow_all_around(RainbowTables& tables, const std::vector<Angle>& angles);
BowLook look_of(const RainbowSetup& setup);
/// Exposed for what lies between these angles from the antisolar point, without a polariser, so
/// that pictures through one can be compared.
DisplaySettings display_of(const BowAround& bow, Angle from, Angle to, const RainbowSetup& setup);
/// What a picture has to say about how it was made.
Attributes picture_facts(const RainbowSetup& setup, const DisplaySettings& settings);

}  // namespace dewbow
