// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/texture_facts.h"

namespace dewbow {
namespace {

/// Whether `matches(rgba)` for every texel.
template <class Matches>
bool all_texels(const TextureImage& image, Matches matches) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (!matches(image.stored(x, y))) return false;
    return true;
}

}  // namespace

bool has_holes(const TextureImage& image) {
    return !all_texels(image, [](const auto& rgba) { return rgba[3] == 1.0; });
}

bool is_grey(const TextureImage& image) {
    return all_texels(image,
                      [](const auto& rgba) { return rgba[0] == rgba[1] && rgba[1] == rgba[2]; });
}

}  // namespace dewbow
