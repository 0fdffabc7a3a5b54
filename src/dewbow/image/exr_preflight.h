// SPDX-License-Identifier: Apache-2.0
#pragma once

// A look at an OpenEXR header without the OpenEXR library, so that a file that asks for too much,
// or for what is not read, is refused in a sentence before the library takes memory for it.
// [OpenEXR file layout, openexr.com/en/latest/OpenEXRFileLayout.html]

#include <cstdint>
#include <string>
#include <string_view>

namespace dewbow {

struct ExrFacts {
    std::int64_t width = 0, height = 0;  ///< of the data window
    int channels = 0;
};

/// Throws InputError naming `name` unless `bytes` begin with the header of a single-part flat image
/// whose channels are all full size and whose size check_image_size takes.
ExrFacts check_exr_header(std::string_view bytes, const std::string& name);

}  // namespace dewbow
