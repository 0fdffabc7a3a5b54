// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/airy.h"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "dewbow/math/airy.h"
#include "dewbow/rainbow/bow_model.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/geometric_flux.h"
#include "dewbow/rainbow/uniform_bow.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

/// ε and dε/db of one polarisation.
struct AmplitudeSlope {
    double value, slope;
};
/// `outer` and `inner` are 1 and n for perpendicular light, n and 1 for parallel:
/// r = (outer cos i - inner cos r) / (outer cos i + inner cos r).
AmplitudeSlope amplitude_slope(const DescartesRay& bow, double n, double outer, double inner) {
    const double b = bow.impact_parameter, C = cos(bow.ray.incidence), c = cos(bow.ray.refraction);
    const double C_slope = -b / C, c_slope = -b / (n * n * c), sum = outer * C + inner * c;
    const double r = (outer * C - inner * c) / sum;
    const double r_slope = 2.0 * outer * inner * (c * C_slope - C * c_slope) / (sum * sum);
    const double power = std::pow(-r, bow.p - 2);
    return {(1.0 - r * r) * power * -r,
            r_slope * power * (2.0 * r * r - (bow.p - 1) * (1.0 - r * r))};
}

class AiryBow final : public BowPattern {
public:
    AiryBow(RelativeIndex n, int p)
        : bow_(descartes_ray(n, p)),
          region_(two_ray_region(n, p)),
          perpendicular_(amplitude_slope(bow_, n.value, 1.0, n.value)),
          parallel_(amplitude_slope(bow_, n.value, n.value, 1.0)),
          turns_(std::lround(bow_.deviation.to(unit::rad) / (2.0 * kPi))),
          path_(2.0 * (p * n.value * cos(bow_.ray.refraction) - cos(bow_.ray.incidence))) {}

    void add_amplitudes(std::span<const Drop> drops, std::span<const Angle> theta,
                        std::span<Amplitudes> sums) const override {
        auto sum = sums.begin();
        for (const Drop& drop : drops) {
            const Angle shift = drop.shifts[std::size_t(bow_.p)];
            for (const Angle angle : theta) {
                const Amplitudes s =
                    amplitudes(drop.size_parameter, angle_without_shift(angle, shift));
                const double scale = std::sqrt(brightness_of_shift(angle, shift));
                sum->perpendicular += scale * s.perpendicular;
                sum->parallel += scale * s.parallel;
                ++sum;
            }
        }
    }

private:
    Amplitudes amplitudes(double x, Angle theta) const {
        if (!region_.contains(theta)) {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            return {nan, nan};
        }
        const double h = bow_.airy_constant, b = bow_.impact_parameter;
        const double offset = bow_.bright_side * (theta - bow_.scattering_angle).to(unit::rad);
        const AiryPair ai = airy(-offset * std::cbrt(x * x / h));
        // Near the bow the path grows by b for each radian; the rest as in uniform_bow.
        const double phase = x * (path_ + b * offset) +
                             kPi * (turns_ - 0.5 * (bow_.p - 1) - 0.25 * bow_.bright_side);
        const Complex scale = -std::pow(x, 7.0 / 6.0) / std::cbrt(h) *
                              std::sqrt(2.0 * kPi * b / sin(bow_.scattering_angle)) *
                              std::polar(1.0, phase);
        const auto sum = [&](const AmplitudeSlope& e) {
            return scale * Complex(e.value * ai.value, e.slope / std::cbrt(x * h) * ai.derivative);
        };
        return {sum(perpendicular_), sum(parallel_)};
    }

    DescartesRay bow_;
    TwoRayRegion region_;
    AmplitudeSlope perpendicular_, parallel_;
    long turns_;   ///< D = 2π turns ± θ
    double path_;  ///< of the Descartes ray, against one through the centre of no drop, in radii
};

class Airy final : public BowModel {
public:
    explicit Airy(const Orders& orders) : BowModel(orders, {2, 3}) {}
    std::string_view name() const override { return "airy"; }

private:
    std::unique_ptr<BowPattern> make_pattern(RelativeIndex n, int p) const override {
        return std::make_unique<AiryBow>(n, p);
    }
};

}  // namespace

std::unique_ptr<ScatteringModel> make_airy(const ModelOptions& options) {
    return std::make_unique<Airy>(options.orders);
}

}  // namespace dewbow
