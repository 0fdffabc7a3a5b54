// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

namespace dewbow {

/// `text` with spaces for ends of lines: a name that a file gives, which may hold any character,
/// must not look like another message.
inline std::string one_line(std::string text) {
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace dewbow
