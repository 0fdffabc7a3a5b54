// SPDX-License-Identifier: Apache-2.0
#include "picture_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "dewbow/base/error.h"
#include "dewbow/image/flip.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

void check_same_size(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height)
        throw InputError("pictures of different sizes are compared");
}

double square_or_infinity(double d) {
    return std::isfinite(d) ? d * d : std::numeric_limits<double>::infinity();
}

/// Squares of one pixel, averaged over its three numbers.
struct PixelErrors {
    double square = 0.0, relative = 0.0, xyz = 0.0, clipped = 0.0;
};
PixelErrors pixel_errors(Colour<LinearSrgb> difference, Colour<LinearSrgb> reference) {
    const Colour<Xyz> xyz = xyz_from_rgb(difference);
    PixelErrors errors;
    for (std::size_t c = 0; c < 3; ++c) {
        const double square = square_or_infinity(difference[c]) / 3.0;
        errors.square += square;
        errors.relative += square / (reference[c] * reference[c] + kFloor * kFloor);
        errors.xyz += square_or_infinity(xyz[c]) / 3.0;
        errors.clipped += square_or_infinity(std::min(reference[c] + difference[c], kBrightest) -
                                             std::min(reference[c], kBrightest)) /
                          3.0;
    }
    return errors;
}

/// All but FLIP, of a picture of differences.
PictureErrors mean_squares(const std::vector<Colour<LinearSrgb>>& differences,
                           const Picture& reference, const Mask& mask) {
    PictureErrors sum;
    std::vector<double> relative;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        if (!mask[i]) continue;
        const PixelErrors errors = pixel_errors(differences[i], reference.pixels[i]);
        sum.mse += errors.square;
        sum.xyz_mse += errors.xyz;
        sum.clipped += errors.clipped;
        relative.push_back(errors.relative);
    }
    if (relative.empty()) return {};
    const auto count = double(relative.size());
    std::sort(relative.begin(), relative.end());
    const auto kept = relative.end() - std::ptrdiff_t(kTrimmedShare * count);
    sum.mse /= count;
    sum.xyz_mse /= count;
    sum.clipped /= count;
    sum.relative_mse = std::accumulate(relative.begin(), relative.end(), 0.0) / count;
    sum.trimmed = std::accumulate(relative.begin(), kept, 0.0) / double(kept - relative.begin());
    return sum;
}

}  // namespace

const std::vector<ErrorKind>& error_kinds() {
    static const std::vector<ErrorKind> kinds = {
        {"MSE", &PictureErrors::mse, true},
        {"relative MSE", &PictureErrors::relative_mse, true},
        {"trimmed", &PictureErrors::trimmed, true},
        {"XYZ MSE", &PictureErrors::xyz_mse, true},
        {"clipped", &PictureErrors::clipped, true},
        {"FLIP", &PictureErrors::flip, false},
    };
    return kinds;
}

Reference make_reference(const Picture& first, const Picture& second) {
    check_same_size(first, second);
    Reference reference{first, first};
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
        reference.mean.pixels[i] = (first.pixels[i] + second.pixels[i]) * 0.5;
        reference.half_difference.pixels[i] = (first.pixels[i] - second.pixels[i]) * 0.5;
    }
    return reference;
}

PictureErrors own_errors(const Reference& reference, const Mask& mask) {
    return mean_squares(reference.half_difference.pixels, reference.mean, mask);
}

Comparison::Comparison(const Picture& picture, const Reference& reference)
    : reference_(&reference) {
    check_same_size(picture, reference.mean);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        differences_.push_back(picture.pixels[i] - reference.mean.pixels[i]);
    flip_ = flip(image_of(picture), image_of(reference.mean));
}

PictureErrors Comparison::errors(const Mask& mask) const {
    PictureErrors errors = mean_squares(differences_, reference_->mean, mask);
    const PictureErrors own = own_errors(*reference_, mask);
    double count = 0.0;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) errors.flip += flip_[i], count += 1.0;
    if (count > 0.0) errors.flip /= count;
    for (const ErrorKind& kind : error_kinds())
        errors.*kind.value = std::max(0.0, errors.*kind.value - own.*kind.value);
    return errors;
}

std::vector<NamedMask> make_masks(const Picture& reference) {
    /// Coloured: the channels lie further apart than this share of the largest, which is not dark.
    constexpr double kApart = 0.05, kDark = 0.02;
    NamedMask whole{"whole", "all pixels", Mask(reference.pixels.size(), true)};
    NamedMask coloured{
        "coloured",
        "pixels whose reference has a channel above 2 % of white, and channels that differ by "
        "more than 5 % of the largest",
        {}};
    for (const Colour<LinearSrgb>& pixel : reference.pixels) {
        const auto [low, high] = std::minmax_element(pixel.v.begin(), pixel.v.end());
        coloured.mask.push_back(*high > kDark && *high - *low > kApart * *high);
    }
    return {whole, coloured};
}

std::vector<NamedMask> make_masks(const Picture& reference, const Picture& direct,
                                  const Mask& seen) {
    /// A caustic is brighter than what the lamps do by this share of white.
    constexpr double kBrighter = 0.02;
    std::vector<NamedMask> masks = make_masks(reference);
    NamedMask caustic{"caustic",
                      "pixels that lamps alone would leave darker by more than 2 % of white", seen};
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const double brighter = xyz_from_rgb(reference.pixels[i] - direct.pixels[i])[1];
        caustic.mask[i] = brighter > kBrighter;
    }
    masks.push_back(std::move(caustic));
    for (NamedMask& mask : masks)
        for (std::size_t i = 0; i < seen.size(); ++i) mask.mask[i] = mask.mask[i] && seen[i];
    return masks;
}

Colour<LinearSrgb> mean_colour(const Picture& picture, const Mask& mask) {
    Colour<LinearSrgb> sum;
    double count = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (mask[i]) sum = sum + picture.pixels[i], count += 1.0;
    return count == 0.0 ? sum : sum * (1.0 / count);
}

Image image_of(const Picture& picture) {
    Image image{picture.width, picture.height, {{"R", {}}, {"G", {}}, {"B", {}}}};
    for (const Colour<LinearSrgb>& pixel : picture.pixels)
        for (std::size_t c = 0; c < 3; ++c) image.channels[c].values.push_back(float(pixel[c]));
    return image;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n == 0 ? 0.0 : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

}  // namespace dewbow::bench
