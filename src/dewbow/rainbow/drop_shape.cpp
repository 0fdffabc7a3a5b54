// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/drop_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "dewbow/base/error.h"
#include "dewbow/math/vector.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// The sun's light, and the directions across it: up and right as one who looks along it has them.
struct SunFrame {
    Vec3 light, up, right;
};
SunFrame sun_frame(Angle altitude) {
    // x points away from the sun, z up.
    const Vec3 light{cos(altitude), 0.0, -sin(altitude)}, up{sin(altitude), 0.0, cos(altitude)};
    return {light, up, cross(light, up)};
}

/// Rays through a spheroid of half-axis k along `axis` and 1 across.
class SpheroidRays {
public:
    SpheroidRays(const Spheroid& shape, RelativeIndex n) : k_(shape.axis_ratio), n_(n.value) {
        axis_ = normalised({-tan(shape.tilt_to_sun), -tan(shape.tilt_to_right), 1.0});
    }

    /// Direction in which light of order p leaves, for light along frame.light that meets the drop
    /// at b (0 to 1 at grazing) and the clock angle psi; nothing where it cannot leave.
    std::optional<Vec3> leave(const SunFrame& frame, double b, double psi, int p) const {
        // Offsets across the direction of light, in the space where the drop is a sphere.
        const Vec3 d = normalised(to_sphere(frame.light));
        const Vec3 aside = to_sphere(std::cos(psi) * frame.up + std::sin(psi) * frame.right);
        const Vec3 across = normalised(aside - dot(aside, d) * d);
        Vec3 place = from_sphere(b * across - std::sqrt(1.0 - b * b) * d);

        const std::optional<Vec3> inside = refract(frame.light, normal(place), 1.0 / n_);
        Vec3 direction = *inside;  // into the denser medium: always
        for (int j = 1; j < p; ++j) {
            place = opposite(place, direction);
            const Vec3 normal_here = normal(place);
            direction = direction - 2.0 * dot(direction, normal_here) * normal_here;
        }
        place = opposite(place, direction);
        return refract(direction, -normal(place), n_);
    }

private:
    Vec3 to_sphere(Vec3 v) const { return v + (1.0 / k_ - 1.0) * dot(v, axis_) * axis_; }
    Vec3 from_sphere(Vec3 v) const { return v + (k_ - 1.0) * dot(v, axis_) * axis_; }
    Vec3 normal(Vec3 place) const {
        return normalised(place + (1.0 / (k_ * k_) - 1.0) * dot(place, axis_) * axis_);
    }
    /// Where a chord from `place` ends.
    Vec3 opposite(Vec3 place, Vec3 direction) const {
        const Vec3 p = to_sphere(place), d = to_sphere(direction);
        return place - 2.0 * dot(p, d) / dot(d, d) * direction;
    }
    /// @param eta  index before over behind.   @param normal  towards the light.
    static std::optional<Vec3> refract(Vec3 direction, Vec3 normal, double eta) {
        const double cosine = -dot(direction, normal);
        const double behind = 1.0 - eta * eta * (1.0 - cosine * cosine);
        if (behind < 0.0) return std::nullopt;
        return eta * direction + (eta * cosine - std::sqrt(behind)) * normal;
    }

    double k_, n_;
    Vec3 axis_;
};

/// The scattering angle of the light of order p that leaves towards one clock angle, as a function
/// of b: a bow is its extremum.
class Meridian {
public:
    Meridian(const SpheroidRays& drop, const SunFrame& frame, const DescartesRay& bow, Angle clock)
        : drop_(drop), frame_(frame), p_(bow.p) {
        // Light comes from the bow's place: it travels to the opposite clock angle. For p = 2 it
        // leaves below the axis if it has come in above.
        wanted_ = clock.to(unit::rad) + kPi;
        psi_ = clock.to(unit::rad) + (bow.bright_side > 0 ? 0.0 : kPi);
    }

    /// In radians; nothing where no ray leaves towards the clock angle. Starts from the last one.
    std::optional<double> scattering_angle(double b) {
        constexpr double kFound = 1e-10;
        double step = 0.0, before = 0.0;
        for (int round = 0; round < 30; ++round) {
            const std::optional<Vec3> out = drop_.leave(frame_, b, psi_, p_);
            if (!out) return std::nullopt;
            const double along = dot(*out, frame_.light), up = dot(*out, frame_.up),
                         right = dot(*out, frame_.right);
            const double error = std::remainder(std::atan2(right, up) - wanted_, 2.0 * kPi);
            if (std::abs(error) < kFound) return std::atan2(std::hypot(up, right), along);
            // Secants, from the sphere's slope of 1.
            const double slope = round == 0 ? 1.0 : (error - before) / step;
            step = -error / (std::abs(slope) > 0.1 ? slope : 1.0);
            before = error;
            psi_ += step;
        }
        return std::nullopt;
    }

private:
    const SpheroidRays& drop_;
    const SunFrame& frame_;
    int p_;
    double wanted_, psi_;
};

/// The extremum near the Descartes ray, by parabolas; nothing if they lead nowhere.
std::optional<double> extreme_angle(Meridian& meridian, const DescartesRay& bow) {
    constexpr double kFound = 1e-4;  // of b; the angle errs by its cube
    // What third derivatives do to the vertex over this, and the angle errs by: less than 1e-7.
    constexpr double kReach = 5e-4;
    double b = bow.impact_parameter;
    for (int round = 0; round < 12; ++round) {
        const double reach = std::min(kReach, 0.5 * (1.0 - b));
        const auto left = meridian.scattering_angle(b - reach),
                   middle = meridian.scattering_angle(b),
                   right = meridian.scattering_angle(b + reach);
        if (!left || !middle || !right) return std::nullopt;
        const double slope = *right - *left, bend = *right - 2.0 * *middle + *left;
        if (!(bend * bow.bright_side > 0.0)) return std::nullopt;
        const double step = -0.5 * slope / bend * reach;
        if (std::abs(step) < kFound) return *middle - slope * slope / (8.0 * bend);
        b += std::clamp(step, -0.03, 0.03);
        if (!(b > 0.3 && b < 1.0)) return std::nullopt;
    }
    return std::nullopt;
}

double oblateness(double axis_ratio) { return (1.0 - axis_ratio) / (1.0 + axis_ratio); }

}  // namespace

double raindrop_axis_ratio(Length radius) {
    const double d = std::min(2.0 * radius.to(unit::mm), 6.0);
    return std::min(1.0, 1.0048 + d * (5.7e-4 + d * (-2.628e-2 + d * (3.682e-3 + d * -1.677e-4))));
}

double oblateness_amplitude(RelativeIndex n, int p) {
    const double r = descartes_ray(n, p).ray.refraction.to(unit::rad), u = kPi - 2.0 * r;
    double sum = 2.0 * (p - 1) * (std::tan(r) * std::cos(p * u) + 2.0 * std::sin(p * u));
    for (int j = 1; j < p; ++j) {
        const int k = 2 * j - p;
        sum += -2.0 * std::tan(r) * std::cos(k * u) + 4.0 * k * std::sin(k * u);
    }
    return sum;
}

BowShifts first_order_bow_shifts(RelativeIndex n, double axis_ratio, const BowPlace& place) {
    BowShifts shifts{};
    const double h = place.sun_altitude.to(unit::rad), e = oblateness(axis_ratio);
    const double visible = std::pow(std::sin(h), 2) + std::pow(std::cos(h) * cos(place.clock), 2);
    if (visible == 0.0) return shifts;
    const double alpha = std::asin(std::clamp(std::sin(h) / std::sqrt(visible), -1.0, 1.0));
    // Seen from the top of the bow, the other half of the drop is lit from below.
    const double side = cos(place.clock) >= 0.0 ? 1.0 : -1.0;
    for (int p = 2; p <= kHighestOrder; ++p) {
        const DescartesRay bow = descartes_ray(n, p);
        const double rho = bow.radius().to(unit::rad);
        shifts[std::size_t(p)] = -bow.bright_side * e * oblateness_amplitude(n, p) * visible *
                                 std::cos(rho - side * 2.0 * alpha) * unit::rad;
    }
    return shifts;
}

BowShifts bow_shifts(RelativeIndex n, const Spheroid& shape, const BowPlace& place) {
    BowShifts shifts{};
    if (shape.axis_ratio == 1.0) return shifts;
    const SpheroidRays drop(shape, n);
    const SunFrame frame = sun_frame(place.sun_altitude);
    std::optional<BowShifts> first_order;
    for (int p = 2; p <= kHighestOrder; ++p) {
        const DescartesRay bow = descartes_ray(n, p);
        Meridian meridian(drop, frame, bow, place.clock);
        if (const auto angle = extreme_angle(meridian, bow)) {
            shifts[std::size_t(p)] = *angle * unit::rad - bow.scattering_angle;
        } else {
            if (!first_order) first_order = first_order_bow_shifts(n, shape.axis_ratio, place);
            shifts[std::size_t(p)] = (*first_order)[std::size_t(p)];
        }
    }
    return shifts;
}

std::vector<WeightedShape> raindrop_shapes(Length radius, const ShapeSpread& spread) {
    if (!(spread.oscillation >= 0.0 && spread.oscillation <= 1.0))
        throw InputError(
            fmt::format("oscillation {:.6g} of raindrops; expected 0 to 1", spread.oscillation));
    if (!(spread.tilt >= Angle{} && spread.tilt <= 30.0 * unit::deg))
        throw InputError(fmt::format("tilt {:.6g}° of raindrops; expected 0° to 30°",
                                     spread.tilt.to(unit::deg)));
    // Nodes 0 and ±√3 of the normal distribution, weights 2/3 and 1/6.
    struct Node {
        double place, share;
    };
    const auto nodes = [](bool spread_out) {
        const double far = std::sqrt(3.0);
        return spread_out ? std::vector<Node>{{-far, 1.0 / 6.0}, {0.0, 2.0 / 3.0}, {far, 1.0 / 6.0}}
                          : std::vector<Node>{{0.0, 1.0}};
    };
    const double e = oblateness(raindrop_axis_ratio(radius));
    std::vector<WeightedShape> shapes;
    for (const Node& swing : nodes(spread.oscillation > 0.0 && e > 0.0))
        for (const Node& to_sun : nodes(spread.tilt > Angle{} && e > 0.0))
            for (const Node& to_right : nodes(spread.tilt > Angle{} && e > 0.0)) {
                const double now = e * (1.0 + spread.oscillation * swing.place);
                shapes.push_back({{(1.0 - now) / (1.0 + now), spread.tilt * to_sun.place,
                                   spread.tilt * to_right.place},
                                  swing.share * to_sun.share * to_right.share});
            }
    return shapes;
}

}  // namespace dewbow
