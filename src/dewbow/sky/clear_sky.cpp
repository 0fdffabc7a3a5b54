// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/clear_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/math/interpolation.h"
#include "dewbow/sky/clear_air.h"
#include "dewbow/sky/sky_light.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

SunPlace sun_place(Dir<World> to_sun) {
    if (!(to_sun.v.y >= 0.0))
        throw InputError(
            fmt::format("the sun at {:.6g}°; a clear sky is known for 0° (the horizon) to 90°",
                        std::asin(std::clamp(to_sun.v.y, -1.0, 1.0)) * 180.0 / kPi));
    return SunPlace(std::asin(std::min(to_sun.v.y, 1.0)));
}

double fine_value(std::span<const double> fine, double lambda_nm) {
    return interpolate_linear_regular(kLambdaMin_nm, SkyTable::kFineStep_nm, fine, lambda_nm);
}

/// A ratio known every 5 nm times a light.
class FineTimesLight final : public Lanewise<FineTimesLight> {
public:
    FineTimesLight(std::vector<double> fine, SpectrumPtr light)
        : fine_(std::move(fine)), light_(std::move(light)) {}
    double value_at(double lambda_nm) const {
        return fine_value(fine_, lambda_nm) * (*light_)(lambda_nm * unit::nm);
    }
    double max_value() const override {
        return *std::max_element(fine_.begin(), fine_.end()) * light_->max_value();
    }

private:
    std::vector<double> fine_;
    SpectrumPtr light_;
};

/// Weights of the 5 nm knots that make luminance of a ratio to `light`.
std::vector<double> luminance_weights(const Spectrum& light) {
    std::vector<double> weights(SkyTable::kFineWavelengths);
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0) {
        const double x = (nm - kLambdaMin_nm) / SkyTable::kFineStep_nm;
        const int k = std::min(static_cast<int>(x), SkyTable::kFineWavelengths - 2);
        const double w = kLuminousEfficacy * cie_xyz_bar(nm)[1] * light(nm * unit::nm);
        weights[k] += (k + 1 - x) * w;
        weights[k + 1] += (x - k) * w;
    }
    return weights;
}

/// One half of the dome.
struct Half {
    Half(const ClearDay& day, SkyHalf half, double eye_m, std::span<const double> weights)
        : reach(reach_of(half, eye_m)),
          table(sky_light(day, half, eye_m)),
          luminance(table.weighted_sum(weights)) {}

    double luminance_at(double share, double azimuth) const {
        const SkyStencil stencil(share, azimuth);
        double sum = 0.0;
        for (int k = 0; k < 16; ++k) sum += stencil.weights[k] * luminance[stencil.knots[k]];
        return std::max(sum, 0.0);
    }

    double reach;                   ///< from the horizon straight up or down, radians
    SkyTable table;                 ///< over the sun's irradiance, sr⁻¹
    std::vector<double> luminance;  ///< at the knots of table, cd m⁻²
};

class Dome final : public ClearSkyDome {
public:
    Dome(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun, SpectrumPtr above)
        : to_sun_(to_sun),
          light_(std::move(above)),
          dip_(dip_of_horizon(sky.eye_height_m)),
          weights_(luminance_weights(*light_)),
          above_(day, SkyHalf::above, sky.eye_height_m, weights_),
          below_(day, SkyHalf::below, sky.eye_height_m, weights_),
          aerial_(make_clear_air(sky, day, to_sun, light_)) {
        std::array<double, kSkyWavelengths> diffuse;
        for (int k = 0; k < kSkyWavelengths; ++k) diffuse[k] = day.diffuse[k].ground_irradiance;
        diffuse_ = refine_over_wavelength(diffuse);
    }

    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        const Place at = place_of(direction);
        at.half->table.eval_lanes(at.share, at.azimuth, lambda_nm, out);
        std::array<double, 16> light;
        for (std::size_t first = 0; first < out.size(); first += light.size()) {
            const std::size_t n = std::min(light.size(), out.size() - first);
            light_->eval_lanes(lambda_nm.subspan(first, n), std::span(light).first(n));
            for (std::size_t i = 0; i < n; ++i) out[first + i] *= light[i];
        }
    }

    double luminance(Dir<World> direction) const override {
        const Place at = place_of(direction);
        return at.half->luminance_at(at.share, at.azimuth);
    }

    AerialPtr aerial() const override { return aerial_; }
    SpectrumPtr diffuse_irradiance() const override {
        return std::make_shared<FineTimesLight>(diffuse_, light_);
    }

private:
    struct Place {
        const Half* half;
        double share, azimuth;
    };
    Place place_of(Dir<World> d) const {
        const double over = std::atan2(d.v.y, std::hypot(d.v.x, d.v.z)) + dip_;
        const Half& half = over >= 0.0 ? above_ : below_;
        return {&half, std::abs(over) / half.reach, azimuth_from(to_sun_, d)};
    }

    Dir<World> to_sun_;
    SpectrumPtr light_;            ///< above the atmosphere
    double dip_;                   ///< of the horizon, radians
    std::vector<double> weights_;  ///< of luminance
    Half above_, below_;
    std::vector<double> diffuse_;  ///< on the ground, over the sun's irradiance, every 5 nm
    AerialPtr aerial_;
};

}  // namespace

ClearSkyDomePtr make_clear_sky_dome(const ClearSky& sky, Dir<World> to_sun,
                                    SpectrumPtr above_atmosphere) {
    validate(sky);
    const ClearDay day(sky, sun_place(to_sun));
    return std::make_shared<Dome>(sky, day, to_sun, std::move(above_atmosphere));
}

}  // namespace dewbow
