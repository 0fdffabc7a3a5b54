// SPDX-License-Identifier: Apache-2.0
#pragma once

// glTF 2.0, as .gltf and as .glb.  [Khronos glTF 2.0.1 specification]
//
// Taken over: triangles, lists, strips and fans, quantised, sparse, packed by Draco or meshopt,
// with texture coordinates, colours and tangents; morph targets; node hierarchies and instances;
// animations at one time; perspective cameras; lights (KHR_lights_punctual); materials with their
// textures, alpha and the extensions of extensions.cpp; `extras.glass` of a material and
// `extras.spectrum` of a light, names of our catalogues. Skins stand at rest, points and lines are
// not shown, and other extensions are not used: diagnostics name what would look different.

// Photometry is absolute: an emission of 1 nit has a luminance of 1 cd m⁻², lights are in lux and
// candela, and the film's white is 1 cd m⁻².

#include <filesystem>
#include <optional>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// Reads a .gltf or .glb file, whichever it is by its first bytes. Errors and diagnostics name
/// their place by JSON pointer. External buffers and pictures lie in the file's folder.
/// @param time_s  when its animations are looked at, in seconds; none: at rest. Throws InputError.
ParsedScene load_gltf(const std::filesystem::path& path, std::optional<double> time_s = {});

/// The same of bytes in memory.
ParsedScene parse_gltf(const std::filesystem::path& path, std::string_view bytes,
                       std::optional<double> time_s = {});

}  // namespace dewbow
