// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/cloud_bank.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/sky/chaos.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

constexpr double kPi = std::numbers::pi;

void check_range(const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw InputError(
        fmt::format("{} {:.6g} of a bank of cloud; expected {} to {}", what, value, least, most));
}

/// From 0 to 1 where `x` goes from −softness/2 to softness/2; without softness a step.
double edge(double x, double softness) {
    if (!(softness > 0.0)) return x >= 0.0 ? 1.0 : 0.0;
    const double t = std::clamp(x / softness + 0.5, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// −1 to 1, 0 in the mean: chaos on directions, flattened as clouds are that are seen from below.
double unevenness(const CloudBank& cloud, Dir<World> direction) {
    Chaos texture;
    texture.octaves = 6;
    texture.base_frequency = 2.5;  // cells a radian
    texture.exponent = 3.4;        // softer than 1/f²: clouds have no grain
    texture.stretch = 0.5;
    texture.seed = cloud.seed;
    return 2.0 * chaos(direction.v, texture) - 1.0;
}

class CloudBankDome final : public SkyDome {
public:
    CloudBankDome(SkyDomePtr behind, const CloudBank& cloud, const SpectrumPtr& light)
        : behind_(std::move(behind)), cloud_(cloud) {
        luminance_ = cloud.luminance_share * illuminance_lx(*behind_) / kPi;
        radiance_ =
            make_scaled(light, luminance_ / (kLuminousEfficacy * xyz_from_spectrum(*light)[1]));
    }

    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        behind_->radiance_lanes(direction, lambda_nm, out);
        const double cover = cover_towards(cloud_, direction);
        if (cover == 0.0) return;
        const double mottle = mottle_at(direction);
        for (std::size_t i = 0; i < out.size(); ++i)
            out[i] += cover * (mottle * (*radiance_)(lambda_nm[i] * unit::nm) - out[i]);
    }
    double luminance(Dir<World> direction) const override {
        const double cover = cover_towards(cloud_, direction);
        if (cover == 0.0) return behind_->luminance(direction);
        return (1.0 - cover) * behind_->luminance(direction) +
               cover * mottle_at(direction) * luminance_;
    }

private:
    double mottle_at(Dir<World> direction) const {
        return cloud_.texture > 0.0 ? 1.0 + cloud_.texture * unevenness(cloud_, direction) : 1.0;
    }

    SkyDomePtr behind_;
    CloudBank cloud_;
    double luminance_;  ///< cd m⁻²
    SpectrumPtr radiance_;
};

class SumOfDomes final : public SkyDome {
public:
    SumOfDomes(SkyDomePtr a, SkyDomePtr b) : a_(std::move(a)), b_(std::move(b)) {}
    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        std::vector<double> other(out.size());
        a_->radiance_lanes(direction, lambda_nm, out);
        b_->radiance_lanes(direction, lambda_nm, other);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] += other[i];
    }
    double luminance(Dir<World> direction) const override {
        return a_->luminance(direction) + b_->luminance(direction);
    }

private:
    SkyDomePtr a_, b_;
};

}  // namespace

void validate(const CloudBank& cloud) {
    check_range("width in degrees", cloud.width.to(unit::deg), 0.0, 360.0);
    check_range("lower edge in degrees", cloud.bottom.to(unit::deg), -90.0, 90.0);
    check_range("upper edge in degrees", cloud.top.to(unit::deg), -90.0, 90.0);
    if (!(cloud.bottom < cloud.top))
        throw InputError("the upper edge of a bank of cloud must be above its lower edge");
    check_range("softness in degrees", cloud.softness.to(unit::deg), 0.0, 60.0);
    check_range("luminance share", cloud.luminance_share, 0.0, 2.0);
    check_range("cover", cloud.cover, 0.0, 1.0);
    check_range("texture", cloud.texture, 0.0, 1.0);
}

double cover_towards(const CloudBank& cloud, Dir<World> direction) {
    const double altitude = std::asin(std::clamp(direction.v.y, -1.0, 1.0));
    if (altitude < cloud.horizon.to(unit::rad)) return 0.0;
    const double softness = cloud.softness.to(unit::rad);
    // Ragged edges: they wander by up to their own width.
    const double ragged = cloud.texture > 0.0 && softness > 0.0
                              ? softness * cloud.texture * unevenness(cloud, direction)
                              : 0.0;
    double cover = cloud.cover;
    if (cloud.bottom > -90.0 * unit::deg)
        cover *= edge(altitude + ragged - cloud.bottom.to(unit::rad), softness);
    if (cloud.top < 90.0 * unit::deg)
        cover *= edge(cloud.top.to(unit::rad) + ragged - altitude, softness);
    if (cloud.width < 360.0 * unit::deg) {
        const double azimuth = std::atan2(direction.v.x, -direction.v.z);
        const double apart =
            std::abs(std::remainder(azimuth - cloud.azimuth.to(unit::rad), 2.0 * kPi));
        cover *= edge(0.5 * cloud.width.to(unit::rad) + ragged - apart, softness);
    }
    return cover;
}

SkyDomePtr make_cloud_bank_dome(SkyDomePtr behind, const CloudBank& cloud, SpectrumPtr light) {
    validate(cloud);
    return std::make_shared<CloudBankDome>(std::move(behind), cloud, light);
}

SkyDomePtr make_sum_of_domes(SkyDomePtr a, SkyDomePtr b) {
    return std::make_shared<SumOfDomes>(std::move(a), std::move(b));
}

double illuminance_lx(const SkyDome& sky) {
    constexpr int kHeights = 64, kTurns = 256;
    double sum = 0.0;
    for (int i = 0; i < kHeights; ++i) {
        // Even in sin² h, where equal parts light the ground alike.
        const double sine = std::sqrt((i + 0.5) / kHeights), cosine = std::sqrt(1.0 - sine * sine);
        for (int k = 0; k < kTurns; ++k) {
            const double turn = 2.0 * kPi * (k + 0.5) / kTurns;
            sum += sky.luminance({{cosine * std::sin(turn), sine, -cosine * std::cos(turn)}});
        }
    }
    return kPi * sum / (kHeights * kTurns);
}

}  // namespace dewbow
