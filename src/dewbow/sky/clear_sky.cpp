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
#include "dewbow/math/quadrature.h"
#include "dewbow/sky/clear_air.h"
#include "dewbow/sky/sky_light.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLumenPerWatt = 683.002;

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

/// Of the sky alone on level ground, over the sun's irradiance, every 5 nm.
std::vector<double> diffuse_share(const SkyTable& table) {
    constexpr int kSines = 20, kTurns = 36;
    std::vector<double> lambda_nm(SkyTable::kFineWavelengths), sum(lambda_nm.size()),
        sky(lambda_nm.size());
    for (std::size_t f = 0; f < lambda_nm.size(); ++f)
        lambda_nm[f] = kLambdaMin_nm + SkyTable::kFineStep_nm * static_cast<double>(f);
    const QuadratureRule rule = gauss_legendre(kSines);
    for (int i = 0; i < kSines; ++i) {
        const double sine = 0.5 + 0.5 * rule.nodes[i];
        for (int j = 0; j < kTurns; ++j) {
            table.eval_lanes(std::asin(sine), kPi * (j + 0.5) / kTurns, lambda_nm, sky);
            const double weight = 0.5 * rule.weights[i] * sine * 2.0 * kPi / kTurns;
            for (std::size_t f = 0; f < sky.size(); ++f) sum[f] += weight * sky[f];
        }
    }
    return sum;
}

/// Weights of the 5 nm knots that make luminance of a ratio to `light`.
std::vector<double> luminance_weights(const Spectrum& light) {
    std::vector<double> weights(SkyTable::kFineWavelengths);
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0) {
        const double x = (nm - kLambdaMin_nm) / SkyTable::kFineStep_nm;
        const int k = std::min(static_cast<int>(x), SkyTable::kFineWavelengths - 2);
        const double w = kLumenPerWatt * cie_xyz_bar(nm)[1] * light(nm * unit::nm);
        weights[k] += (k + 1 - x) * w;
        weights[k + 1] += (x - k) * w;
    }
    return weights;
}

class Dome final : public ClearSkyDome {
public:
    Dome(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun, SpectrumPtr above)
        : to_sun_(to_sun),
          above_(std::move(above)),
          table_(sky_light(day)),
          diffuse_(diffuse_share(table_)),
          aerial_(make_clear_air(sky, day, to_sun, above_)) {
        light_ground(sky.ground_albedo, day);
        const std::vector<double> weights = luminance_weights(*above_);
        luminance_ = table_.weighted_sum(weights);
        for (int f = 0; f < SkyTable::kFineWavelengths; ++f)
            ground_luminance_ += weights[f] * ground_[f];
    }

    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        if (direction.v.y < 0.0) {
            for (std::size_t i = 0; i < out.size(); ++i) out[i] = fine_value(ground_, lambda_nm[i]);
        } else {
            table_.eval_lanes(elevation_of(direction), azimuth_from(to_sun_, direction), lambda_nm,
                              out);
        }
        std::array<double, 16> light;
        for (std::size_t at = 0; at < out.size(); at += light.size()) {
            const std::size_t n = std::min(light.size(), out.size() - at);
            above_->eval_lanes(lambda_nm.subspan(at, n), std::span(light).first(n));
            for (std::size_t i = 0; i < n; ++i) out[at + i] *= light[i];
        }
    }

    double luminance(Dir<World> direction) const override {
        if (direction.v.y < 0.0) return ground_luminance_;
        const SkyStencil stencil(elevation_of(direction), azimuth_from(to_sun_, direction));
        double sum = 0.0;
        for (int k = 0; k < 16; ++k) sum += stencil.weights[k] * luminance_[stencil.knots[k]];
        return std::max(sum, 0.0);
    }

    AerialPtr aerial() const override { return aerial_; }
    SpectrumPtr diffuse_irradiance() const override {
        return std::make_shared<FineTimesLight>(diffuse_, above_);
    }

private:
    static double elevation_of(Dir<World> d) { return std::atan2(d.v.y, std::hypot(d.v.x, d.v.z)); }
    /// The ground sends back what comes down on it from sky and sun.
    void light_ground(double albedo, const ClearDay& day) {
        const AirParts mass = air_mass_to_space(0.0, day.sun.sine);
        std::array<double, kSkyWavelengths> direct;
        for (int k = 0; k < kSkyWavelengths; ++k)
            direct[k] = std::exp(-dot(day.optics[k].depth, mass));
        ground_ = refine_over_wavelength(direct);
        for (std::size_t f = 0; f < ground_.size(); ++f)
            ground_[f] = albedo / kPi * (ground_[f] * day.sun.sine + diffuse_[f]);
    }

    Dir<World> to_sun_;
    SpectrumPtr above_;
    SkyTable table_;                 ///< sky over the sun's irradiance, sr⁻¹
    std::vector<double> diffuse_;    ///< every 5 nm
    std::vector<double> ground_;     ///< over the sun's irradiance, sr⁻¹, every 5 nm
    std::vector<double> luminance_;  ///< at the knots of table_, cd m⁻²
    double ground_luminance_ = 0.0;
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
