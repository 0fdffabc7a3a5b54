// SPDX-License-Identifier: Apache-2.0
#pragma once

// JPEG, from memory: the format of most textures.

#include <string>
#include <string_view>

#include "dewbow/image/image.h"

namespace dewbow {

/// Baseline or progressive, grey or colour; CMYK is refused. Colour profiles and the orientation
/// that a camera notes are ignored, as glTF asks for. A file that ends early is refused, where
/// viewers show grey. Throws InputError naming `name`; limits are those of limits.h.
Image8 decode_jpeg(std::string_view bytes, const std::string& name);

bool is_jpeg(std::string_view bytes);

}  // namespace dewbow
