// SPDX-License-Identifier: Apache-2.0
#pragma once

// .glb: the JSON text and the bytes that come with it.  [glTF 2.0, §4 GLB]

#include <optional>
#include <string>
#include <string_view>

namespace dewbow::gltf {

/// Parts of the file's bytes.
struct Container {
    std::string_view json;
    std::optional<std::string_view> binary;  ///< the BIN chunk
};

/// A file that begins with "glTF" is a .glb, any other is JSON as a whole. Chunks of other kinds
/// are passed over. Throws InputError that names the byte.
Container open_container(const std::string& file, std::string_view bytes);

}  // namespace dewbow::gltf
