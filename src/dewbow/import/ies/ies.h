// SPDX-License-Identifier: Apache-2.0
#pragma once

// Photometric files of luminaires, IESNA LM-63 of 1986, 1991, 1995, 2002 and 2019 (".ies"):
//
//     IESNA:LM-63-2002                     and lines of labels
//     TILT=NONE                            or INCLUDE and a table, or the name of a file
//     lamps, lumens per lamp, multiplier, vertical angles, horizontal angles, type, units, three
//     sizes, ballast factor, ballast-lamp factor, watts
//     the vertical angles, the horizontal angles, and for each horizontal angle the candela

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "dewbow/base/error.h"
#include "dewbow/scene/photometric_web.h"

namespace dewbow {

/// What the range of a file's horizontal angles says of the rest of the circle.
enum class IesSymmetry {
    axial,         ///< one angle: alike all around
    quadrant,      ///< 0 to 90 deg, mirrored twice
    bilateral,     ///< 0 to 180 deg, mirrored
    bilateral_90,  ///< 90 to 270 deg, mirrored
    none           ///< the whole circle
};

struct IesFile {
    std::string version;  ///< its first line, or "LM-63-1986", which has no such line
    int lamps = 1;
    std::optional<double> lumens_per_lamp;  ///< nothing where the file is of absolute photometry
    double multiplier = 1.0, ballast_factor = 1.0;
    double ballast_lamp_factor = 1.0;  ///< 1 from LM-63-2002 on, which uses its place otherwise
    IesSymmetry symmetry = IesSymmetry::axial;
    /// The file's candela times `multiplier` and both factors, unfolded to the whole circle.
    std::shared_ptr<const PhotometricWeb> web;
    /// What is in the file and not honoured, such as a TILT table.
    Diagnostics diagnostics;
};

/// Reads photometry of type C. Throws InputError with line and column: types A and B, numbers that
/// are missing, too many, out of order or out of range, and a web that is wholly dark.
/// @param file  name for messages.
IesFile parse_ies(const std::string& file, std::string_view bytes);

}  // namespace dewbow
