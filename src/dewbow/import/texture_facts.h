// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a picture is for, told by what is in it.

#include "dewbow/scene/texture.h"

namespace dewbow {

/// Whether alpha is below 1 anywhere.
bool has_holes(const TextureImage& image);
/// Whether red, green and blue are the same everywhere.
bool is_grey(const TextureImage& image);
/// Where the picture says how much of a surface is there: its alpha (3), or if that is 1
/// everywhere its red channel (0).
inline int coverage_channel(const TextureImage& image) { return has_holes(image) ? 3 : 0; }

}  // namespace dewbow
