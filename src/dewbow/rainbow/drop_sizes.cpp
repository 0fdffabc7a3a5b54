// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "dewbow/base/error.h"
#include "dewbow/math/gamma_function.h"
#include "dewbow/math/root_finding.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr double kPi = std::numbers::pi;
/// Of the cross section that smallest() and largest() leave outside. Above, it counts for more in
/// ⟨r³⟩.
constexpr double kBelow = 2e-8, kAbove = 1e-8;

std::string in_suitable_unit(Length radius) {
    if (radius >= 0.1 * mm) return fmt::format("{:.6g}mm", radius.to(mm));
    return fmt::format("{:.6g}um", radius.to(um));
}

void check_radius(Length radius, const char* what) {
    if (radius >= kLeastDropRadius && radius <= kMostDropRadius) return;
    throw InputError(
        fmt::format("{} of drops is {:.6g} mm; expected 1 nm to 10 mm", what, radius.to(mm)));
}

void check_width(double width, double most, const char* kind, const char* instead) {
    if (width > 0.0 && width <= most) return;
    throw InputError(fmt::format("width {:.6g} of {} drop sizes; expected above 0 to {:.0f}%",
                                 width, kind, 100.0 * most),
                     width > most ? instead : "");
}

class SingleSize : public DropSizes {
public:
    explicit SingleSize(Length radius) : radius_(radius) {}
    double density(Length radius) const override {
        return radius == radius_ ? std::numeric_limits<double>::infinity() : 0.0;
    }
    double mean_power(double power) const override { return std::pow(radius_.to(m), power); }
    Length smallest() const override { return radius_; }
    Length largest() const override { return radius_; }
    bool is_single() const override { return true; }
    std::string describe() const override { return in_suitable_unit(radius_); }

private:
    Length radius_;
};

class NormalSizes : public DropSizes {
public:
    NormalSizes(Length mean, double width) : mean_(mean), width_(width) {}
    double density(Length radius) const override {
        const double z = (radius / mean_ - 1.0) / width_;
        return std::exp(-0.5 * z * z) / (std::sqrt(2.0 * kPi) * width_ * mean_.to(m));
    }
    double mean_power(double power) const override {
        // Σ C(power, k) w^k E[z^k] over even k: ends for whole powers, else to 1e-8 for w <= 0.2.
        double sum = 1.0, term = 1.0;
        for (int k = 2; k <= 12; k += 2) {
            // C(power, k) (k − 1)!! from the one before: (power−k+2)(power−k+1) / k.
            term *= (power - k + 2.0) * (power - k + 1.0) / k * width_ * width_;
            sum += term;
        }
        return sum * std::pow(mean_.to(m), power);
    }
    Length smallest() const override { return std::max(1e-3, 1.0 - kDeviations * width_) * mean_; }
    Length largest() const override { return (1.0 + kDeviations * width_) * mean_; }
    std::string describe() const override {
        return fmt::format("normal:mean={},width={:.6g}%", in_suitable_unit(mean_), 100.0 * width_);
    }

private:
    /// 2e-8 of the number lies above, less than 1e-7 of the cross section for widths up to 0.2.
    static constexpr double kDeviations = 5.5;
    Length mean_;
    double width_;
};

class LognormalSizes : public DropSizes {
public:
    LognormalSizes(Length mean, double width)
        : mean_(mean),
          width_(width),
          sigma_(std::sqrt(std::log1p(width * width))),
          mu_(std::log(mean.to(m)) - 0.5 * sigma_ * sigma_) {}
    double density(Length radius) const override {
        const double z = (std::log(radius.to(m)) - mu_) / sigma_;
        return std::exp(-0.5 * z * z) / (std::sqrt(2.0 * kPi) * sigma_ * radius.to(m));
    }
    double mean_power(double power) const override {
        return std::exp(power * mu_ + 0.5 * power * power * sigma_ * sigma_);
    }
    // The cross section is log-normal with its median at μ + 2σ².
    Length smallest() const override { return quantile(-5.5); }  // 2e-8
    Length largest() const override { return quantile(5.6); }    // 1e-8
    std::string describe() const override {
        return fmt::format("lognormal:mean={},width={:.6g}%", in_suitable_unit(mean_),
                           100.0 * width_);
    }

private:
    Length quantile(double z) const { return std::exp(mu_ + (2.0 * sigma_ + z) * sigma_) * m; }
    Length mean_;
    double width_, sigma_, mu_;
};

/// n ∝ r^α e^{−b r^γ} up to a largest radius, which may be infinite.
class GammaSizes : public DropSizes {
public:
    /// @param scale  b^{−1/γ}.
    /// @param uncut_per_m3  number of drops, if it is known, as if there were no largest radius.
    GammaSizes(double alpha, double gamma, Length scale, Length most, std::string description,
               std::optional<double> uncut_per_m3 = std::nullopt)
        : alpha_(alpha),
          gamma_(gamma),
          scale_(scale),
          most_(most),
          end_(std::pow(most / scale, gamma)),
          log_norm_(std::log(gamma / lower_gamma_share(order(0.0), end_)) -
                    std::lgamma(order(0.0))),
          description_(std::move(description)) {
        if (uncut_per_m3) per_m3_ = *uncut_per_m3 * lower_gamma_share(order(0.0), end_);
    }
    double density(Length radius) const override {
        if (radius > most_) return 0.0;
        const double x = radius / scale_;
        // In logarithms: for narrow distributions the factors leave the range of doubles.
        return std::exp(log_norm_ + alpha_ * std::log(x) - std::pow(x, gamma_)) / scale_.to(m);
    }
    double mean_power(double power) const override {
        return std::exp(std::lgamma(order(power)) - std::lgamma(order(0.0))) *
               lower_gamma_share(order(power), end_) / lower_gamma_share(order(0.0), end_) *
               std::pow(scale_.to(m), power);
    }
    Length smallest() const override {
        return quantile([](double a, double x) { return lower_gamma_share(a, x); }, kBelow);
    }
    Length largest() const override {
        if (upper_gamma_share(order(2.0), end_) > kAbove) return most_;
        return quantile([](double a, double x) { return upper_gamma_share(a, x); }, kAbove);
    }
    std::optional<double> number_per_m3() const override { return per_m3_; }
    std::string describe() const override { return description_; }

private:
    /// ∫ r^power n dr is an incomplete gamma function of this order.
    double order(double power) const { return (alpha_ + 1.0 + power) / gamma_; }
    /// Where `share` of the cross section of an uncut distribution is `wanted`; in ln x^γ.
    template <class Share>
    Length quantile(const Share& share, double wanted) const {
        const double a = order(2.0);
        const auto excess = [&](double u) { return std::log(share(a, std::exp(u)) / wanted); };
        const double u = find_root(excess, std::log(a) - 60.0, std::log(a + 700.0)).value_or(0.0);
        return std::min(std::exp(u / gamma_) * scale_, most_);
    }
    double alpha_, gamma_;
    Length scale_, most_;
    double end_, log_norm_;
    std::string description_;
    std::optional<double> per_m3_;
};

constexpr Length kNoEnd = Length::from_base(std::numeric_limits<double>::infinity());

void check_rain_rate(double mm_per_hour) {
    if (mm_per_hour >= 0.01 && mm_per_hour <= 300.0) return;
    throw InputError(fmt::format("rain rate {:.6g} mm/h; expected 0.01 to 300 mm/h", mm_per_hour));
}

}  // namespace

Length mean_radius(const DropSizes& sizes) { return sizes.mean_power(1.0) * m; }

Length effective_radius(const DropSizes& sizes) {
    return sizes.mean_power(3.0) / sizes.mean_power(2.0) * m;
}

Area mean_cross_section(const DropSizes& sizes) { return kPi * sizes.mean_power(2.0) * (m * m); }

double relative_width(const DropSizes& sizes) {
    if (sizes.is_single()) return 0.0;
    const double mean = sizes.mean_power(1.0);
    return std::sqrt(std::max(0.0, sizes.mean_power(2.0) / (mean * mean) - 1.0));
}

DropSizesPtr single_drop_size(Length radius) {
    check_radius(radius, "radius");
    return std::make_shared<SingleSize>(radius);
}

DropSizesPtr normal_drop_sizes(Length mean, double width) {
    check_radius(mean, "mean radius");
    check_width(width, 0.2, "normal",
                "wider ones would have drops of negative radius: lognormal and gamma have none");
    return std::make_shared<NormalSizes>(mean, width);
}

DropSizesPtr lognormal_drop_sizes(Length mean, double width) {
    check_radius(mean, "mean radius");
    check_width(width, 2.0, "lognormal", "");
    return std::make_shared<LognormalSizes>(mean, width);
}

DropSizesPtr gamma_drop_sizes(Length mean, double width) {
    check_radius(mean, "mean radius");
    check_width(width, 1.0, "gamma", "lognormal can be wider");
    const double w2 = width * width;
    return std::make_shared<GammaSizes>(
        1.0 / w2 - 1.0, 1.0, w2 * mean, kNoEnd,
        fmt::format("gamma:mean={},width={:.6g}%", in_suitable_unit(mean), 100.0 * width));
}

DropSizesPtr effective_gamma_drop_sizes(Length effective_radius, double effective_variance) {
    check_radius(effective_radius, "effective radius");
    const double v = effective_variance;
    if (!(v > 0.0 && v <= 1.0 / 3.0))
        throw InputError(fmt::format("effective variance {:.6g}; expected above 0 to 1/3", v));
    return std::make_shared<GammaSizes>(
        1.0 / v - 3.0, 1.0, v * effective_radius, kNoEnd,
        fmt::format("gamma:effective-radius={},effective-variance={:.6g}",
                    in_suitable_unit(effective_radius), v));
}

DropSizesPtr deirmendjian_drop_sizes(double alpha, double gamma, Length mode) {
    check_radius(mode, "mode radius");
    if (!(alpha >= 0.1 && alpha <= 20.0))
        throw InputError(fmt::format("alpha {:.6g} of drop sizes; expected 0.1 to 20", alpha));
    if (!(gamma >= 0.1 && gamma <= 5.0))
        throw InputError(fmt::format("gamma {:.6g} of drop sizes; expected 0.1 to 5", gamma));
    // b r_c^γ = α/γ
    return std::make_shared<GammaSizes>(
        alpha, gamma, std::pow(gamma / alpha, 1.0 / gamma) * mode, kNoEnd,
        fmt::format("deirmendjian:alpha={:.6g},gamma={:.6g},mode={}", alpha, gamma,
                    in_suitable_unit(mode)));
}

DropSizesPtr marshall_palmer_drop_sizes(double mm_per_hour) {
    check_rain_rate(mm_per_hour);
    constexpr double kIntercept_per_m3_mm = 8000.0;
    const double slope_per_mm = 4.1 * std::pow(mm_per_hour, -0.21);
    return std::make_shared<GammaSizes>(
        0.0, 1.0, 0.5 / slope_per_mm * mm, kLargestRaindrop,
        fmt::format("rain:marshall-palmer,rate={:.6g}mm/h", mm_per_hour),
        kIntercept_per_m3_mm / slope_per_mm);
}

DropSizesPtr ulbrich_drop_sizes(double mm_per_hour, double shape) {
    check_rain_rate(mm_per_hour);
    if (!(shape >= 0.0 && shape <= 6.0))
        throw InputError(
            fmt::format("shape {:.6g} of Ulbrich's raindrops; expected 0 to 6", shape));
    /// π/6 · 17.67 m/s · 3600 s/h, in mm/h of drops of 1 cm at one a cubic metre.
    constexpr double kRainOfDrops = kPi / 6.0 * 17.67 * 3600.0 * 1e-3;
    const double intercept = 6e4 * std::exp(3.2 * shape), order = 4.67 + shape;
    const double slope_per_cm =
        std::pow(kRainOfDrops * intercept * std::tgamma(order) / mm_per_hour, 1.0 / order);
    return std::make_shared<GammaSizes>(
        shape, 1.0, 0.5 / slope_per_cm * cm, kLargestRaindrop,
        fmt::format("rain:ulbrich,rate={:.6g}mm/h,shape={:.6g}", mm_per_hour, shape),
        intercept * std::tgamma(shape + 1.0) / std::pow(slope_per_cm, shape + 1.0));
}

}  // namespace dewbow
