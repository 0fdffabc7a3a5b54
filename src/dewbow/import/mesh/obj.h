// SPDX-License-Identifier: Apache-2.0
#pragma once

// Wavefront OBJ: v, vn and f, with polygons, negative indices and lines continued by a backslash.
// Groups and objects are names and go into one mesh; materials, lines and points are noted as not
// shown; texture coordinates and smoothing groups are passed over.  [Wavefront Advanced Visualizer,
// appendix B1]

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// @param file  name for messages.
/// A vertex that faces use with several normals becomes several vertices. Normals are dropped, with
/// a note, where only some corners have one. Polygons are split around their first corner. Throws
/// InputError with line and excerpt.
Mesh parse_obj(const std::string& file, std::string_view text, Diagnostics& diagnostics);

}  // namespace dewbow
