// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/glow.h"

#include "dewbow/render/brightness.h"
#include "dewbow/render/scene_opacity.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {

namespace {

/// What a place counts for at least, as a share of a white texel: a bright one may lie between
/// those that were looked at, and is then sampled a hundred times too seldom at worst.
constexpr double kLeastTexel = 0.01;

}  // namespace

Glow::Glow(const Material& material)
    : spectrum_(material.emission),
      texture_(material.emission_texture),
      coverage_(material.coverage),
      two_sided_(material.two_sided_emission),
      brightness_(texture_ ? xyz_from_rgb(texture_->factor)[1] : dewbow::brightness(*spectrum_)) {}

Colour<LinearSrgb> Glow::colour(const SurfaceCoordinates& at) const {
    const auto texel = texture_->texture->eval(at.uv[std::size_t(texture_->texture->texcoord_set)]);
    Colour<LinearSrgb> rgb = texture_->factor;
    for (std::size_t c = 0; c < 3; ++c) rgb[c] *= texel[c];
    return rgb;
}

double Glow::alpha(const SurfaceCoordinates& at) const {
    return coverage_ ? alpha_at(*coverage_, at) : 1.0;
}

double Glow::brightness(const SurfaceCoordinates& at) const {
    const double here = texture_ ? xyz_from_rgb(colour(at))[1] : brightness_;
    return here * alpha(at) + kLeastTexel * brightness_;
}

}  // namespace dewbow
