// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include "dewbow/base/error.h"

namespace dewbow::bench {

Picture picture_of(const Image& image, const std::string& name) {
    Picture picture{image.width, image.height, {}};
    picture.pixels.resize(std::size_t(image.width) * std::size_t(image.height));
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel* const channel = image.find(names[c]);
        if (!channel) throw InputError(name + ": there is no channel " + names[c]);
        for (std::size_t i = 0; i < picture.pixels.size(); ++i)
            picture.pixels[i][c] = double(channel->values[i]);
    }
    return picture;
}

}  // namespace dewbow::bench
