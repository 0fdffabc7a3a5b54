// SPDX-License-Identifier: Apache-2.0
#pragma once

// Captions in pictures: letters of 5 × 7 pixels.

#include <string_view>

#include "dewbow/image/image.h"

namespace dewbow::bench {

inline constexpr int kLetterWidth = 5, kLetterHeight = 7;

/// Writes `text` from (left, top) on, in that grey; letters are capitals, and what there is no
/// letter for is a space. What does not fit into the picture is cut off.
void put_letters(Image8& image, std::string_view text, int left, int top, std::uint8_t grey);

}  // namespace dewbow::bench
