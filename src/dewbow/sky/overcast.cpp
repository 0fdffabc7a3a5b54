// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/overcast.h"

#include <fmt/format.h>

#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow {

namespace {

class OvercastDome final : public SkyDome {
public:
    OvercastDome(double illuminance_lx, double ground_albedo)
        : zenith_(9.0 / (7.0 * std::numbers::pi) * illuminance_lx),
          ground_(ground_albedo / std::numbers::pi * illuminance_lx),
          per_luminance_(
              make_scaled(find_illuminant("D65"), 1.0 / (kLuminousEfficacy * cie_y_integral()))) {}

    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        per_luminance_->eval_lanes(lambda_nm, out);
        const double here = luminance(direction);
        for (double& value : out) value *= here;
    }
    double luminance(Dir<World> direction) const override {
        const double sine = direction.v.y;
        return sine < 0.0 ? ground_ : zenith_ * (1.0 + 2.0 * sine) / 3.0;
    }

private:
    double zenith_, ground_;  ///< cd m⁻²
    SpectrumPtr per_luminance_;
};

}  // namespace

double overcast_illuminance_lx(Angle sun_altitude) {
    if (!(sun_altitude >= Angle{} && sun_altitude <= 90.0 * unit::deg))
        throw InputError(fmt::format("the sun at {:.6g}°; expected 0° (the horizon) to 90°",
                                     sun_altitude.to(unit::deg)));
    return 300.0 + 21000.0 * sin(sun_altitude);
}

SkyDomePtr make_overcast_dome(Angle sun_altitude, double ground_albedo) {
    if (!(ground_albedo >= 0.0 && ground_albedo <= 1.0))
        throw InputError(fmt::format("a ground of albedo {:.6g}; expected 0 to 1", ground_albedo));
    return std::make_shared<OvercastDome>(overcast_illuminance_lx(sun_altitude), ground_albedo);
}

}  // namespace dewbow
