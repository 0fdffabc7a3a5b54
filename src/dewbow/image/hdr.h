// SPDX-License-Identifier: Apache-2.0
#pragma once

// Radiance HDR, from memory: the format of most environment maps.

#include <string>
#include <string_view>

#include "dewbow/image/image.h"

namespace dewbow {

/// Channels R, G, B of a 32-bit_rle_rgbe picture whose lines run from top to bottom and from left
/// to right ("-Y height +X width"), flat or in either run-length form. A value is m * 2^(e - 136),
/// as other readers take it, divided by the header's EXPOSURE and COLORCORR. Error: the largest
/// component to 1/128. Throws InputError naming `name`; limits are those of limits.h.
Image decode_hdr(std::string_view bytes, const std::string& name);

}  // namespace dewbow
