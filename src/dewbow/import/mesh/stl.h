// SPDX-License-Identifier: Apache-2.0
#pragma once

// STL, as text and as bytes: triangles alone, with the facets' normals stated beside them.
// [3D Systems, "Stereolithography Interface Specification", 1989]

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// @param file  name for messages.
/// Corners at the very same place become one vertex, so that what is closed stays closed; facets
/// are flat. Stated normals and colours are passed over: the order of the corners tells the front.
/// A file is binary unless it begins with "solid" and has another size than its count of triangles
/// asks for. Throws InputError with the line (text) or the byte (binary).
Mesh parse_stl(const std::string& file, std::string_view bytes, Diagnostics& diagnostics);

}  // namespace dewbow
