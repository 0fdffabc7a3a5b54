// SPDX-License-Identifier: Apache-2.0
#pragma once

// What this reader knows of glTF's extensions by name.

#include <string_view>

#include "dewbow/import/json/json.h"

namespace dewbow::gltf {

/// True for extensions that are honoured, and for those that cannot change what is read here (ways
/// of storing textures, which are not read).
bool may_be_required(std::string_view name);

/// Whether ignoring `extension` shows in a picture: not if it is a mere note, a second encoding of
/// what is there anyway, or has the values that do nothing.
bool changes_picture(std::string_view name, const Json& extension);

}  // namespace dewbow::gltf
