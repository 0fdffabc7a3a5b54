// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/compare.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using RgbPlanes = std::array<const Channel*, 3>;

RgbPlanes rgb_planes(const Image& image) {
    const RgbPlanes planes{image.find("R"), image.find("G"), image.find("B")};
    for (const Channel* plane : planes)
        if (!plane) throw InputError("pictures are compared by their channels R, G and B");
    return planes;
}

void check_same_size(const Image& image, const Image& reference) {
    if (image.width == reference.width && image.height == reference.height) return;
    throw InputError(fmt::format("a picture of {} x {} is compared with one of {} x {}",
                                 image.width, image.height, reference.width, reference.height));
}

/// |a - b|; infinite if either is not finite, so that no NaN hides in a comparison.
double distance(double a, double b) {
    const double difference = std::abs(a - b);
    return std::isfinite(difference) ? difference : std::numeric_limits<double>::infinity();
}

}  // namespace

ImageDifference compare_rgb(const Image& image, const Image& reference, double floor) {
    DEWBOW_CHECK(floor > 0.0, "the floor of relative differences is positive");
    check_same_size(image, reference);
    const RgbPlanes planes = rgb_planes(image), reference_planes = rgb_planes(reference);

    ImageDifference result;
    const auto width = static_cast<std::size_t>(image.width);
    const std::size_t pixels = width * static_cast<std::size_t>(image.height);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (std::size_t c = 0; c < 3; ++c) {
            const double b = reference_planes[c]->values[pixel];
            const double d = distance(planes[c]->values[pixel], b);
            result.mean_squared += d * d;
            result.relative_mean_squared += std::isfinite(d) ? d * d / (b * b + floor * floor) : d;
            if (d > result.worst) {
                result.worst = d;
                result.worst_x = static_cast<int>(pixel % width);
                result.worst_y = static_cast<int>(pixel / width);
            }
        }
    const double count = 3.0 * static_cast<double>(pixels);
    result.mean_squared /= count;
    result.relative_mean_squared /= count;
    return result;
}

}  // namespace dewbow
