// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0, as .gltf and as .glb.  [Khronos glTF 2.0.1 specification]
//
// Taken over: triangles, lists, strips and fans; node hierarchies; perspective cameras;
// metallic-roughness factors; KHR_lights_punctual, KHR_materials_emissive_strength, _transmission,
// _ior, _volume and _dispersion; and `extras.dewbow.glass` of a material, a name of the glass
// catalogue. Textures, animations, skins and morph targets are not: diagnostics name what would
// look different.
//
// Photometry is absolute: an emission of 1 nit has a luminance of 1 cd m⁻², lights are in lux and
// candela, and the film's white is 1 cd m⁻².

#include <filesystem>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// Reads a .gltf or .glb file, whichever it is by its first bytes. Errors and diagnostics name
/// their place by JSON pointer. External buffers lie in the file's folder. Throws InputError.
ParsedScene load_gltf(const std::filesystem::path& path);

/// The same of bytes in memory.
ParsedScene parse_gltf(const std::filesystem::path& path, std::string_view bytes);

}  // namespace dewbow
