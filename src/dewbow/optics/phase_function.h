// SPDX-License-Identifier: Apache-2.0
#pragma once

// Into which directions a medium scatters light.

#include <memory>
#include <span>

namespace dewbow {

/// Of what is scattered, the share per steradian by the angle from the old direction to the new. It
/// may differ from wavelength to wavelength; at each its integral over the sphere is 1.
class PhaseFunction {
public:
    virtual ~PhaseFunction() = default;

    /// Per sr, at each of the vacuum wavelengths `lambda_nm`, into `out` of the same length.
    /// @param cosine  of the scattering angle: 1 forward, −1 back to where the light came from.
    virtual void eval_lanes(double cosine, std::span<const double> lambda_nm,
                            std::span<double> out) const = 0;
};
using PhaseFunctionPtr = std::shared_ptr<const PhaseFunction>;

/// $p = (1 - g^2) / (4\pi (1 + g^2 - 2 g \cos\theta)^{3/2})$ at every wavelength.
/// [Henyey & Greenstein, "Diffuse radiation in the Galaxy", Astrophysical Journal 93, 1941, eq. 2]
/// @param g  mean cosine of the scattering angle, −1 < g < 1: 0 scatters all ways alike, haze has
/// about 0.7, forward.
PhaseFunctionPtr henyey_greenstein(double g);

}  // namespace dewbow
