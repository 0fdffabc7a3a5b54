// SPDX-License-Identifier: Apache-2.0
#pragma once

// PLY: ascii, binary_little_endian and binary_big_endian 1.0. Vertices with x, y, z and, if there
// are, nx, ny, nz, a colour and texture coordinates; faces with a list vertex_indices (or
// vertex_index). All other elements and properties are passed over.
// [Turk, "The PLY Polygon File Format", 1994]

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// @param file  name for messages.
/// Counts are held against the bytes that are there before memory is taken. Polygons are split
/// around their first corner. Colours (red, green, blue, and alpha) that are whole numbers are
/// coded as sRGB, with the type's largest number for 1; those that are float are linear. They are
/// held in 0 to 1, with a note. Texture coordinates (s, t or u, v or texture_u, texture_v) have v
/// upwards. Throws InputError with the line (ascii) or the byte (binary).
Mesh parse_ply(const std::string& file, std::string_view bytes, Diagnostics& diagnostics);

}  // namespace dewbow
