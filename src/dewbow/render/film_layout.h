// SPDX-License-Identifier: Apache-2.0
#pragma once

// What films have in common that can be added, and how they count light.

#include <cstdint>
#include <span>

#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// A rectangle of pixels, [x0, x1) × [y0, y1).
struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    std::int64_t area() const { return std::int64_t{width()} * height(); }
    bool operator==(const PixelRect&) const = default;
};

/// Films of one layout can be added.
struct FilmLayout {
    int width = 0, height = 0;  ///< of the whole picture
    PixelRect crop;             ///< the part of it that there are sums of
    int spectral_bins = 0;
    /// The quanta are powers of two that follow from 2 to this power, in W m⁻² sr⁻¹ nm⁻¹.
    int reference_exponent = 0;
    bool operator==(const FilmLayout&) const = default;
};

/// The exponent of the power of two that is nearest (by ratio) to `radiance` > 0.
int reference_exponent(double radiance);

/// XYZ of a packet's radiance, W m⁻² sr⁻¹ nm⁻¹, as the film has it: Y of the constant spectrum 1 is
/// 1.
Colour<Xyz> film_xyz(const WavelengthPacket& packet, std::span<const double> radiance);

}  // namespace dewbow
