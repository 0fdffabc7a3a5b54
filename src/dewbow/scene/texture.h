// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures on surfaces.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace dewbow {

/// The texels of a picture, row 0 at the top, row-major, RGBA with 8 or 16 bits a channel as in its
/// file. Shared by all textures that read it.
struct TextureImage {
    std::string name;  ///< of the file, for messages
    int width = 0, height = 0;
    int bits = 8;                       ///< 8: `texels8` holds it, 16: `texels16`
    std::vector<std::uint8_t> texels8;  ///< 4 a texel
    std::vector<std::uint16_t> texels16;

    /// Channel values of texel (x, y) as stored, 0 to 1.
    std::array<double, 4> stored(int x, int y) const;
};

/// What lies beyond the picture's edges.
enum class TextureWrap { repeat, mirror, clamp };
/// Whether colours are stored by the sRGB transfer function; alpha never is.
enum class TextureCoding { linear, srgb };

/// Position on a texture: (0, 0) is the picture's upper left corner, (1, 1) its lower right.
/// [glTF 2.0, 3.8]
struct TexturePoint {
    double u = 0.0, v = 0.0;
};

struct Texture {
    std::shared_ptr<const TextureImage> image;
    TextureCoding coding = TextureCoding::srgb;
    TextureWrap wrap_u = TextureWrap::repeat, wrap_v = TextureWrap::repeat;
    bool interpolates = true;  ///< bilinear in linear values, else the nearest texel
    int texcoord_set = 0;      ///< which coordinates of the mesh, 0 or 1
    /// Rows of the affine map from the surface's coordinates to the picture's.
    /// [KHR_texture_transform]
    std::array<std::array<double, 3>, 2> transform{{{1, 0, 0}, {0, 1, 0}}};

    /// Linear RGBA at `point`, a position in the surface's coordinates.
    std::array<double, 4> eval(TexturePoint point) const;
};
using TexturePtr = std::shared_ptr<const Texture>;

}  // namespace dewbow
