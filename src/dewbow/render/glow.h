// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a material glows, at one place of a surface.

#include "dewbow/render/surface_inputs.h"

namespace dewbow {

class Glow {
public:
    /// `material` gives light.
    explicit Glow(const Material& material);

    bool two_sided() const { return two_sided_; }
    /// Whether radiance or alpha differ from place to place.
    bool varies() const { return texture_ || coverage_; }
    /// Whether the radiance is a colour and not one spectrum.
    bool coloured() const { return texture_.has_value(); }
    const Spectrum& spectrum() const { return *spectrum_; }
    /// Linear sRGB of the radiance; (1, 1, 1) is D65 as bright as the constant 1.
    Colour<LinearSrgb> colour(const SurfaceCoordinates& at) const;
    /// How much of the surface is there.
    double alpha(const SurfaceCoordinates& at) const;

    /// Y of the radiance that arrives from there on average, 1 for the constant 1; where it varies,
    /// somewhat more than nothing for places between those that were looked at.
    double brightness(const SurfaceCoordinates& at) const;
    /// The same where it does not vary.
    double brightness() const { return brightness_; }

private:
    SpectrumPtr spectrum_;
    std::optional<EmissionTexture> texture_;
    std::optional<Coverage> coverage_;
    bool two_sided_;
    double brightness_;  ///< of the spectrum, or of a white texel
};

}  // namespace dewbow
