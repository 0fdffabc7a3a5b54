// SPDX-License-Identifier: Apache-2.0
#pragma once

// PNG, to and from memory.

#include "dewbow/image/image.h"

namespace dewbow {

/// 8-bit sRGB with an sRGB chunk. `attributes` become text entries, numbers in the shortest decimal
/// that reads back the same. A name that PNG does not take as a keyword (over 79 bytes, not ASCII)
/// goes into a "Comment".
std::string encode_png(const Image8& image, const Attributes& attributes);
/// Palettes and grey become RGB, 16 bits become 8, alpha is dropped (colours stay as they are,
/// whatever their alpha). Values are taken as sRGB: gAMA, cHRM and iCCP chunks are ignored, as glTF
/// asks for. Throws InputError naming `name`; limits are those of limits.h.
Image8 decode_png(std::string_view bytes, const std::string& name);
/// All that the file holds: files of 16 bits stay so, others have 8. Alpha is the largest value
/// where the file has none. Otherwise as decode_png.
ImageRgba decode_png_rgba(std::string_view bytes, const std::string& name);

bool is_png(std::string_view bytes);

}  // namespace dewbow
