// SPDX-License-Identifier: Apache-2.0
#pragma once

// The diffuse field of a clear day as a table, for flights through its air: what air and haze
// scatter of it towards an eye, by height, direction and wavelength.

#include <array>
#include <cstddef>
#include <vector>

#include "dewbow/sky/sky_light.h"

namespace dewbow {

class DiffuseSource {
public:
    explicit DiffuseSource(const ClearDay& day);

    /// Radiance for an irradiance of 1 above the atmosphere, sr⁻¹, per optical depth of scattering.
    struct Value {
        float air, haze;
    };
    using Row = std::array<Value, kSkyWavelengths>;
    /// By wavelength; linear between knots 5° apart and every second level of DiffuseField.
    /// @param height_m  0 to kSkyTop_m.   @param sine  of the altitude that is looked along, −1 to
    /// 1.   @param azimuth  from the sun, radians, 0 to π.
    Row at(double height_m, double sine, double azimuth) const;

private:
    std::vector<Row> rows_;  ///< [level][altitude][azimuth]
};

}  // namespace dewbow
