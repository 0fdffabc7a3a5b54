// SPDX-License-Identifier: Apache-2.0
#pragma once

// Light of the sky by direction: what every model of a sky is to those who are lit by it.

#include <memory>
#include <span>

#include "dewbow/math/vector.h"

namespace dewbow {

/// The light of a sky without the disc of its sun or moon, in the world's frame: +y is up, north is
/// −z, east is +x. Immutable; safe from several threads.
class SkyDome {
public:
    virtual ~SkyDome() = default;

    /// Spectral radiance, W m⁻² sr⁻¹ nm⁻¹, at each vacuum wavelength, into `out` of the same
    /// length. Below the horizon: what the ground sends back.
    /// @param direction  that one looks along, of unit length.
    virtual void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                                std::span<double> out) const = 0;
    /// cd m⁻² of radiance_lanes, to a few per cent: what light is sampled by. Never negative.
    virtual double luminance(Dir<World> direction) const = 0;
};
using SkyDomePtr = std::shared_ptr<const SkyDome>;

}  // namespace dewbow
