// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/texture.h"

#include <algorithm>
#include <cmath>

#include "dewbow/spectrum/display.h"

namespace dewbow {
namespace {

using Rgba = std::array<double, 4>;

/// The linear value of each of the 256 codes of 8-bit sRGB.
const std::array<double, 256>& srgb_table() {
    static const std::array<double, 256> table = [] {
        std::array<double, 256> result{};
        for (std::size_t i = 0; i < 256; ++i) result[i] = srgb_decode(double(i) / 255.0);
        return result;
    }();
    return table;
}

/// The index in [0, size) that `i` stands for.
int wrapped(int i, int size, TextureWrap wrap) {
    switch (wrap) {
        case TextureWrap::repeat:
            return (i % size + size) % size;
        case TextureWrap::mirror: {
            const int period = 2 * size, j = (i % period + period) % period;
            return j < size ? j : period - 1 - j;
        }
        case TextureWrap::clamp:
            break;
    }
    return std::clamp(i, 0, size - 1);
}

Rgba linear_texel(const Texture& texture, int x, int y) {
    const TextureImage& image = *texture.image;
    x = wrapped(x, image.width, texture.wrap_u);
    y = wrapped(y, image.height, texture.wrap_v);
    if (texture.coding == TextureCoding::srgb && image.bits == 8) {
        const std::uint8_t* p =
            &image.texels8[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
        const auto& table = srgb_table();
        return {table[p[0]], table[p[1]], table[p[2]], p[3] / 255.0};
    }
    Rgba value = image.stored(x, y);
    if (texture.coding == TextureCoding::srgb)
        for (std::size_t c = 0; c < 3; ++c) value[c] = srgb_decode(value[c]);
    return value;
}

/// `x` in texels, so near the picture that it fits an int. What is no number is 0.
double in_texels(double x, int size, TextureWrap wrap) {
    const double place = x * size;
    if (std::isnan(place)) return 0.0;
    if (wrap == TextureWrap::clamp) return std::clamp(place, -1.0, size + 1.0);
    return std::isfinite(place) ? std::fmod(place, 2.0 * size) : 0.0;
}

}  // namespace

Rgba TextureImage::stored(int x, int y) const {
    const std::size_t first = 4 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
    Rgba value;
    for (std::size_t c = 0; c < 4; ++c)
        value[c] = bits == 8 ? texels8[first + c] / 255.0 : texels16[first + c] / 65535.0;
    return value;
}

Rgba Texture::eval(TexturePoint point) const {
    const auto& t = transform;
    const double u = t[0][0] * point.u + t[0][1] * point.v + t[0][2];
    const double v = t[1][0] * point.u + t[1][1] * point.v + t[1][2];
    double x = in_texels(u, image->width, wrap_u), y = in_texels(v, image->height, wrap_v);
    if (!interpolates) return linear_texel(*this, int(std::floor(x)), int(std::floor(y)));
    x -= 0.5, y -= 0.5;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    const double fx = x - x0, fy = y - y0;
    const Rgba a = linear_texel(*this, x0, y0), b = linear_texel(*this, x0 + 1, y0);
    const Rgba c = linear_texel(*this, x0, y0 + 1), d = linear_texel(*this, x0 + 1, y0 + 1);
    Rgba value;
    for (std::size_t i = 0; i < 4; ++i)
        value[i] =
            (1.0 - fy) * ((1.0 - fx) * a[i] + fx * b[i]) + fy * ((1.0 - fx) * c[i] + fx * d[i]);
    return value;
}

}  // namespace dewbow
