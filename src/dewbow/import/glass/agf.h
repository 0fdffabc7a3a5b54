// SPDX-License-Identifier: Apache-2.0
#pragma once

// Zemax glass catalogues.
//
// A record of a glass is a line NM (name, formula number, MIL, n_d, V_d, …), then CD
// (coefficients), TD (thermal), LD (range in µm), IT (wavelength in µm, internal transmittance,
// thickness in mm) and others. Lines that begin with ! or CC are comments.       [Zemax OpticStudio
// help, glass catalogs] What makers' files do otherwise, each of which is read and noted: UTF-16;
// NEL as the end of lines; CD wrapped onto lines that begin with a number; "-" or nothing for what
// is not known; n_d of 1 as a placeholder; LD 0 0.

#include <string>
#include <string_view>

#include "dewbow/import/glass/glass_file.h"

namespace dewbow::glass_import {

/// @param file  its name, for places.   @param group  what stands before the slash of names.
/// Throws InputError if `bytes` are no such catalogue.
GlassFile read_agf(std::string_view bytes, const std::string& file, const std::string& group);

}  // namespace dewbow::glass_import
