// SPDX-License-Identifier: Apache-2.0
#pragma once

// What contestants make.

#include <string>
#include <vector>

#include "dewbow/image/image.h"
#include "dewbow/spectrum/colour.h"

namespace dewbow::bench {

/// Row by row from the top left. (1, 1, 1) is the film's white; colours outside sRGB have negative
/// parts.
struct Picture {
    int width = 0, height = 0;
    std::vector<Colour<LinearSrgb>> pixels;
};

/// The channels R, G, B of an image that holds linear sRGB. Throws InputError naming `name` where
/// one is missing.
Picture picture_of(const Image& image, const std::string& name);

}  // namespace dewbow::bench
