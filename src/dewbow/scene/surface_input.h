// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a material is given for a colour or a number: one for the whole surface, or a texture.

#include "dewbow/scene/texture.h"
#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

/// A reflectance or transmittance. Where neither a texture nor the mesh's colours shape it, it is
/// `spectrum`; else the smooth reflectance of `factor` × texel × vertex colour.
struct ColourInput {
    SpectrumPtr spectrum;
    TexturePtr texture;
    Colour<LinearSrgb> factor{{1.0, 1.0, 1.0}};
    bool vertex_colour = false;

    ColourInput(SpectrumPtr s = nullptr) : spectrum(std::move(s)) {}
    ColourInput(std::nullptr_t) {}
    bool varies() const { return texture || vertex_colour; }
    /// Whether there is anything: an empty one stands for the factor 1.
    explicit operator bool() const { return spectrum || varies(); }
};

/// `value`, times a channel of a texture if there is one.
struct NumberInput {
    double value = 0.0;
    TexturePtr texture;
    int channel = 0;  ///< of R, G, B, A

    NumberInput(double v = 0.0) : value(v) {}
    bool varies() const { return texture != nullptr; }
    bool operator==(double other) const { return !texture && value == other; }
};

}  // namespace dewbow
