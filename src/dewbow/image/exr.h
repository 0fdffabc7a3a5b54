// SPDX-License-Identifier: Apache-2.0
#pragma once

// OpenEXR, to and from memory. Writing to disk is base/file's business.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "dewbow/image/image.h"
#include "dewbow/image/limits.h"

namespace dewbow {

struct ExrOptions {
    /// Half floats for all channels but depth ("Z", "layer.Z") and spectral ones ("S0.…", "T.…"),
    /// which stay float.
    bool half = false;
    /// Chromaticities of R, G, B and white as the header states them; x, y each. Default: sRGB,
    /// D65.
    std::array<double, 8> chromaticities{0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
    /// Luminance of (1, 1, 1) in cd m⁻²: OpenEXR's `whiteLuminance`.
    double white_luminance = 1.0;
};

/// A single-part scanline file, ZIP-compressed. Finite values beyond what a half float holds become
/// its largest (±65504). An integer attribute beyond 32 bits becomes text; "EV" and other numbers
/// that OpenEXR or the spectral layout declare as `float` are written as such. Throws InputError if
/// an attribute has the name of a field that OpenEXR itself needs ("compression", "channels"…).
std::string encode_exr(const Image& image, const Attributes& attributes, const ExrOptions& options);

/// What decode_exr found. The image is the file's data window, all of it and nothing else.
struct DecodedExr {
    Image image;
    /// The header's text and numbers, without those that describe the file's own structure.
    Attributes attributes;
    /// Values that were not finite and are 0 in `image`.
    std::int64_t non_finite = 0;
    /// As in ExrOptions, where the header states them.
    std::optional<std::array<double, 8>> chromaticities;
    std::optional<double> white_luminance;
    /// The data window's top left pixel as seen from the display window's, and the size of the
    /// display window: what the camera was asked for. They differ from (0, 0) and the image's size
    /// in crops and overscans.
    int offset_x = 0, offset_y = 0;
    int display_width = 0, display_height = 0;
};

/// Decodes a single-part file, scanline or tiled (the full-size level of a mip map). Refuses
/// multi-part, deep and subsampled files and what limits.h refuses. `name` is for error messages.
/// Throws InputError.
DecodedExr decode_exr(std::string_view bytes, const std::string& name);

}  // namespace dewbow
