// SPDX-License-Identifier: Apache-2.0
#pragma once

// A picture in memory: named planes of floats, and facts about how it was made.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace dewbow {

/// One plane, row-major from the top left, `width * height` values.
struct Channel {
    std::string name;  ///< OpenEXR's convention: "R", "albedo.G", "Z", "S0.550,000000nm"
    std::vector<float> values;
};

struct Image {
    int width = 0, height = 0;
    std::vector<Channel> channels;

    /// The channel of that name, or nullptr.
    const Channel* find(std::string_view name) const;
};

/// One fact in a file's header, for instance {"dewbow:seed", 0}.
struct Attribute {
    std::string name;
    std::variant<std::string, double, std::int64_t> value;
};
using Attributes = std::vector<Attribute>;

/// 8-bit RGB, row-major from the top left, 3 bytes a pixel.
struct Image8 {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

/// RGBA with 8 or 16 bits a channel, row-major from the top left, 4 values a pixel; alpha is not
/// multiplied into the colours.
struct ImageRgba {
    int width = 0, height = 0;
    int bits = 8;  ///< 8: `values8` holds it, 16: `values16`
    std::vector<std::uint8_t> values8;
    std::vector<std::uint16_t> values16;
};

}  // namespace dewbow
