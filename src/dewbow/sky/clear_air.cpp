// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/clear_air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "dewbow/math/interpolation.h"
#include "dewbow/sky/diffuse_source.h"

namespace dewbow {
namespace {

constexpr int kMostSteps = 12;
/// Steps of a flight of so many metres: one where the air is the same all the way.
int steps_of(double distance_m) {
    return distance_m < 500.0 ? 1 : distance_m < 2e3 ? 2 : distance_m < 10e3 ? 4 : kMostSteps;
}

/// A piece of a flight: what lies in it, and the light that meets it.
struct AirStep {
    AirParts mass;             ///< relative masses
    AirParts to_sun;           ///< from its middle
    double visible;            ///< share of the sun's disc
    DiffuseSource::Row again;  ///< of light that was scattered before
};

/// A flight over a sphere, as far as the top of the air.
struct FlightLine {
    FlightLine(double height_m, double sine, double distance_m)
        : radius(kSkyRadius_m + std::clamp(height_m, 0.0, kSkyTop_m)), along(radius * sine) {
        const double top = kSkyRadius_m + kSkyTop_m;
        const double end = std::sqrt(top * top - radius * radius + along * along) - along;
        length = std::min(distance_m, end);
    }
    double height_at(double s) const {
        const double r = std::sqrt(radius * radius + s * (s + 2.0 * along));
        return radius - kSkyRadius_m + s * (s + 2.0 * along) / (r + radius);
    }
    double radius, along, length;
};

DiffuseSource::Value between(const DiffuseSource::Row& row, double lambda_nm) {
    constexpr double kStep_nm = (kLambdaMax_nm - kLambdaMin_nm) / (kSkyWavelengths - 1);
    const auto [k, t] = knot_interval((lambda_nm - kLambdaMin_nm) / kStep_nm, kSkyWavelengths);
    const float share = static_cast<float>(t);
    return {row[k].air + share * (row[k + 1].air - row[k].air),
            row[k].haze + share * (row[k + 1].haze - row[k].haze)};
}

/// air_density every 100 m, linear between: 0.06 % of the haze.
class DensityTable {
public:
    DensityTable() {
        for (int k = 0; k < kKnots; ++k) knots_.push_back(air_density(kStep_m * k));
    }
    AirParts at(double height_m) const {
        const auto [k, t] = knot_interval(height_m / kStep_m, kKnots);
        return (1.0 - t) * knots_[k] + t * knots_[k + 1];
    }

private:
    static constexpr double kStep_m = 100.0;
    static constexpr int kKnots = static_cast<int>(kSkyTop_m / kStep_m) + 1;
    std::vector<AirParts> knots_;
};

class ClearAir final : public Aerial {
public:
    ClearAir(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun, SpectrumPtr above)
        : asymmetry_(sky.aerosol_asymmetry),
          sun_(day.sun),
          to_sun_(to_sun),
          above_(std::move(above)),
          masses_(day.masses),
          source_(day) {
        for (int f = 0; f < SkyTable::kFineWavelengths; ++f)
            optics_[f] = air_optics(sky, (kLambdaMin_nm + SkyTable::kFineStep_nm * f) * unit::nm);
    }

    void eval_lanes(double height_m, Dir<World> direction, double distance_m,
                    std::span<const double> lambda_nm, std::span<double> transmittance,
                    std::span<double> airlight) const override {
        std::array<AirStep, kMostSteps> storage;
        const std::span<const AirStep> steps =
            cut(FlightLine(height_m, direction.v.y, distance_m), direction, storage);
        const double cosine = dot(direction, to_sun_);
        const double p_air = air_phase(cosine), p_haze = haze_phase(cosine, asymmetry_);
        above_->eval_lanes(lambda_nm, airlight);
        for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
            const AirOptics optics = optics_at(lambda_nm[i]);
            double left = 1.0, sum = 0.0;
            for (const AirStep& step : steps) {
                const double sunlight = step.visible * std::exp(-dot(optics.depth, step.to_sun));
                const DiffuseSource::Value again = between(step.again, lambda_nm[i]);
                const double scattered =
                    optics.depth.air * step.mass.air * (sunlight * p_air + again.air) +
                    optics.haze_scattering * step.mass.haze * (sunlight * p_haze + again.haze);
                const double depth = dot(optics.depth, step.mass);
                const double through = std::exp(-depth);
                sum += left * scattered * (depth > 1e-6 ? (1.0 - through) / depth : 1.0);
                left *= through;
            }
            transmittance[i] *= left;
            airlight[i] *= sum;
        }
    }

private:
    /// Pieces that grow as squares; their air by Simpson's rule.
    std::span<const AirStep> cut(const FlightLine& line, Dir<World> direction,
                                 std::array<AirStep, kMostSteps>& steps) const {
        const int n = steps_of(line.length);
        const double azimuth = azimuth_from(to_sun_, direction);
        const double towards = dot(direction, to_sun_);
        for (int k = 0; k < n; ++k) {
            const double a = line.length * k * k / (n * n);
            const double b = line.length * (k + 1) * (k + 1) / (n * n);
            const double s = 0.5 * (a + b), height = line.height_at(s), r = kSkyRadius_m + height;
            const double sin_sun = (line.radius * sun_.sine + s * towards) / r;
            steps[k].mass =
                ((b - a) / 6.0) * (density_.at(line.height_at(a)) + 4.0 * density_.at(height) +
                                   density_.at(line.height_at(b)));
            steps[k].visible = visible_share_of_sun(std::max(height, 0.0), sin_sun);
            steps[k].to_sun = masses_.at(std::max(height, 0.0), sin_sun);
            steps[k].again = source_.at(std::max(height, 0.0), (line.along + s) / r, azimuth);
        }
        return std::span(steps).first(n);
    }

    AirOptics optics_at(double lambda_nm) const {
        const double x = std::clamp((lambda_nm - kLambdaMin_nm) / SkyTable::kFineStep_nm, 0.0,
                                    SkyTable::kFineWavelengths - 1.0);
        const int f = std::min(static_cast<int>(x), SkyTable::kFineWavelengths - 2);
        const AirOptics &a = optics_[f], &b = optics_[f + 1];
        const double t = x - f;
        return {(1.0 - t) * a.depth + t * b.depth,
                (1.0 - t) * a.haze_scattering + t * b.haze_scattering};
    }

    double asymmetry_;
    SunPlace sun_;
    Dir<World> to_sun_;
    SpectrumPtr above_;
    SunMasses masses_;
    DiffuseSource source_;
    DensityTable density_;
    std::array<AirOptics, SkyTable::kFineWavelengths> optics_;  ///< every 5 nm
};

}  // namespace

AerialPtr make_clear_air(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun,
                         SpectrumPtr above) {
    return std::make_shared<ClearAir>(sky, day, to_sun, std::move(above));
}

}  // namespace dewbow
