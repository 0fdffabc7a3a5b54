// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/clear_air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "dewbow/math/interpolation.h"

namespace dewbow {
namespace {

/// Steps of a flight of so many metres: one where the air is the same all the way.
int steps_of(double distance_m) {
    return distance_m < 500.0 ? 1 : distance_m < 2e3 ? 2 : distance_m < 10e3 ? 4 : 12;
}

/// A step of a flight: what lies in it, and its middle.
struct AirStep {
    AirParts mass;
    double height_m;
};

/// A flight over a sphere, as far as the top of the air.
class Flight {
public:
    Flight(double height_m, double sine, double distance_m)
        : radius_(kSkyRadius_m + std::clamp(height_m, 0.0, kSkyTop_m)), along_(radius_ * sine) {
        const double top = kSkyRadius_m + kSkyTop_m;
        const double end = std::sqrt(top * top - radius_ * radius_ + along_ * along_) - along_;
        length_ = std::min(distance_m, end);
        steps_ = steps_of(length_);
    }
    int steps() const { return steps_; }
    /// Steps grow as squares. Simpson's rule over each.
    AirStep step(int k) const {
        const double a = end_of(k), b = end_of(k + 1);
        const double middle = height_at(0.5 * (a + b));
        const AirParts mass =
            ((b - a) / 6.0) *
            (air_density(height_at(a)) + 4.0 * air_density(middle) + air_density(height_at(b)));
        return {mass, middle};
    }

private:
    double end_of(int k) const {
        const double u = static_cast<double>(k) / steps_;
        return length_ * u * u;
    }
    double height_at(double s) const {
        const double r = std::sqrt(radius_ * radius_ + s * (s + 2.0 * along_));
        return radius_ - kSkyRadius_m + s * (s + 2.0 * along_) / (r + radius_);
    }

    double radius_, along_, length_;
    int steps_;
};

class ClearAir final : public Aerial {
public:
    ClearAir(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun, SpectrumPtr above)
        : sky_(sky), sun_(day.sun), to_sun_(to_sun), above_(std::move(above)), masses_(day.masses) {
        for (int f = 0; f < SkyTable::kFineWavelengths; ++f)
            optics_[f] = air_optics(sky, (kLambdaMin_nm + SkyTable::kFineStep_nm * f) * unit::nm);
    }

    void eval_lanes(double height_m, Dir<World> direction, double distance_m,
                    std::span<const double> lambda_nm, std::span<double> transmittance,
                    std::span<double> airlight) const override {
        const Flight flight(height_m, direction.v.y, distance_m);
        const double cosine = dot(direction, to_sun_);
        const double p_air = air_phase(cosine);
        const double p_haze = haze_phase(cosine, sky_.aerosol_asymmetry);
        above_->eval_lanes(lambda_nm, airlight);
        for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
            const AirOptics optics = optics_at(lambda_nm[i]);
            double left = 1.0, sum = 0.0;
            for (int k = 0; k < flight.steps(); ++k) {
                const AirStep step = flight.step(k);
                const double depth = dot(optics.depth, step.mass);
                const double scattered = optics.depth.air * step.mass.air * p_air +
                                         optics.haze_scattering * step.mass.haze * p_haze;
                const double lit =
                    std::exp(-dot(optics.depth, masses_.at(step.height_m, sun_.sine)));
                const double through = std::exp(-depth);
                sum += left * lit * scattered * (depth > 1e-6 ? (1.0 - through) / depth : 1.0);
                left *= through;
            }
            transmittance[i] *= left;
            airlight[i] *= sum;
        }
    }

private:
    AirOptics optics_at(double lambda_nm) const {
        const double x = std::clamp((lambda_nm - kLambdaMin_nm) / SkyTable::kFineStep_nm, 0.0,
                                    SkyTable::kFineWavelengths - 1.0);
        const int f = std::min(static_cast<int>(x), SkyTable::kFineWavelengths - 2);
        const AirOptics &a = optics_[f], &b = optics_[f + 1];
        const double t = x - f;
        return {(1.0 - t) * a.depth + t * b.depth,
                (1.0 - t) * a.haze_scattering + t * b.haze_scattering};
    }

    ClearSky sky_;
    SunPlace sun_;
    Dir<World> to_sun_;
    SpectrumPtr above_;
    SunMasses masses_;
    std::array<AirOptics, SkyTable::kFineWavelengths> optics_;
};

}  // namespace

AerialPtr make_clear_air(const ClearSky& sky, const ClearDay& day, Dir<World> to_sun,
                         SpectrumPtr above) {
    return std::make_shared<ClearAir>(sky, day, to_sun, std::move(above));
}

}  // namespace dewbow
