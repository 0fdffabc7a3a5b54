// SPDX-License-Identifier: Apache-2.0
#pragma once

// The lines of a glass catalogue, whatever it is encoded in.

#include <string>
#include <string_view>
#include <vector>

namespace dewbow::glass_import {

struct TextLines {
    std::vector<std::string> lines;     ///< UTF-8, without their ends
    std::vector<std::string> findings;  ///< what was unusual: "UTF-16, little-endian"
};

/// UTF-16 with or without a byte order mark, UTF-8, or else Latin-1; lines end with LF, CR, CR LF
/// or NEL (U+0085). Throws InputError (without a place) if it is not text.
TextLines lines_of_text(std::string_view bytes);

}  // namespace dewbow::glass_import
