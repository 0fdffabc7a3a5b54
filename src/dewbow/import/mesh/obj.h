// SPDX-License-Identifier: Apache-2.0
#pragma once

// Wavefront OBJ: v, vt, vn and f, with polygons, negative indices and lines continued by a
// backslash; o, g and usemtl divide the faces, and mtllib names libraries of materials (mtl.h).
// Lines, points and other statements are noted as not used; smoothing groups are passed over.
// [Wavefront Advanced Visualizer, appendix B1]

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// Faces that belong to one object in one material.
struct ObjPart {
    std::string name;      ///< of its object or group; empty = none
    std::string material;  ///< by usemtl; empty = none
    std::size_t material_line = 0;
    Mesh mesh;
};

/// A statement mtllib: names of files, between spaces.
struct ObjLibraries {
    std::string names;
    std::size_t line = 0;
};

struct ObjModel {
    std::vector<ObjPart> parts;  ///< each with a triangle, in the order of the file
    std::vector<ObjLibraries> libraries;
};

enum class ObjDivision {
    none,                   ///< one part, whatever objects and materials there are
    objects_and_materials,  ///< objects (where a file has none: groups), in each material
};

/// @param file  name for messages.
/// A vertex that faces use with several normals or texture coordinates becomes several vertices.
/// Normals are dropped from a part, with a note, where only some corners have one. Groups of one
/// material that share a vertex stay one part, so that closed bodies stay closed. Polygons are
/// split around their first corner. Colours that stand behind a vertex's place (x y z r g b) are
/// coded as sRGB. Throws InputError with line and excerpt.
ObjModel parse_obj(const std::string& file, std::string_view text, ObjDivision division,
                   Diagnostics& diagnostics);

}  // namespace dewbow
