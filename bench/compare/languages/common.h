// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the languages have in common.

#include <filesystem>
#include <string>
#include <vector>

#include "languages.h"

namespace dewbow::bench {

/// Index of the body against what surrounds it. Our scenes lie in air, whose index others take for
/// 1.
double relative_index(const PlainScene& scene, Wavelength lambda);
double relative_index(const PlainScene& scene, const PlainBody& body, Wavelength lambda);

/// The four corners of a rectangle, counter-clockwise as seen from where its normal points.
std::array<Vec3, 4> corners(const PlainLamp& lamp);

/// A disc so far away that it is the sun, for those who know no sun: seen from points a centimetre
/// apart its place differs by 0.01°.
PlainLamp lamp_for(const PlainSun& sun);

/// Numbers between commas, in the fewest digits that read back the same.
std::string joined(Vec3 v, const char* between = ", ");
std::string joined(const Colour<LinearSrgb>& colour, const char* between = ", ");

SceneOrder scene_order(const Order& order);

/// R, G and B of the file that the program left in `folder`. Throws InputError (none, another
/// size).
Picture read_left_picture(const Order& order);

/// What a program says when it is asked for its version, from the line that has `with`; "?" if it
/// says nothing.
std::string version_line(const std::filesystem::path& program, const std::string& option,
                         const std::string& with);

}  // namespace dewbow::bench
