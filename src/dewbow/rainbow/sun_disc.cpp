// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/sun_disc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/base/simd.h"
#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRounding = 1e-15;

void check(const SunDisc& disc) {
    if (!(disc.radius >= Angle{} && disc.radius <= 10.0 * unit::deg))
        throw InputError(fmt::format("a disc of radius {:.6g}°; expected 0° (a point) to 10°",
                                     disc.radius.to(unit::deg)));
    if (!(disc.limb_darkening >= 0.0 && disc.limb_darkening <= 1.0))
        throw InputError(
            fmt::format("limb darkening {:.6g}; expected 0 to 1", disc.limb_darkening));
}

double sin2_half(double radians) {
    const double s = std::sin(0.5 * radians);
    return s * s;
}

/// ∫ I da and ∫ I cos 2a da over the part of a circle that lies in the disc, for I(centre) = 1.
struct Arc {
    double i = 0.0, q = 0.0;
};

/// The disc as seen from angle θ: what circles of radius t around the direction of view have of it.
class Arcs {
public:
    Arcs(double theta, const SunDisc& disc)
        : theta_(theta),
          sin_theta_(std::sin(theta)),
          sin2_(sin2_half(disc.radius.to(unit::rad))),
          u_(disc.limb_darkening) {}

    Arc operator()(double t) const {
        // μ² sin²(R/2) = A − B sin²(a/2)
        const double a = sin2_ - sin2_half(t - theta_), b = std::sin(t) * sin_theta_;
        if (a <= 0.0) return {};
        const double alpha = a < b ? 2.0 * std::asin(std::sqrt(a / b)) : kPi;
        Arc arc{2.0 * alpha, std::sin(2.0 * alpha)};
        if (u_ == 0.0) return arc;
        const Arc mu = a < b ? mu_within(a, b) : mu_around(a, b);
        return {(1.0 - u_) * arc.i + u_ * mu.i, (1.0 - u_) * arc.q + u_ * mu.q};
    }

private:
    /// ∫ μ da where the circle leaves the disc: sin(a/2) = √(A/B) sin ψ.
    Arc mu_within(double a, double b) const {
        // The integrand is nearly cos² until the circle lies in the disc with its greater part.
        static const QuadratureRule few = gauss_legendre(8), many = gauss_legendre(24);
        const QuadratureRule& rule = a < 0.5 * b ? few : many;
        const double m = a / b, scale = 4.0 * a / std::sqrt(b * sin2_);
        Arc sum;
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double psi = 0.25 * kPi * (1.0 + rule.nodes[k]);
            const double s = std::sin(psi), c = std::cos(psi), sin2_half_a = m * s * s;
            const double value =
                rule.weights[k] * 0.25 * kPi * scale * c * c / std::sqrt(1.0 - sin2_half_a);
            const double cos_a = 1.0 - 2.0 * sin2_half_a;
            sum.i += value;
            sum.q += value * (2.0 * cos_a * cos_a - 1.0);
        }
        return sum;
    }
    /// ∫ μ da over a whole circle.
    Arc mu_around(double a, double b) const {
        constexpr int kSteps = 64;
        Arc sum;
        for (int k = 0; k < kSteps; ++k) {
            const double azimuth = 2.0 * kPi * k / kSteps;
            const double mu = std::sqrt(std::max(0.0, a - b * sin2_half(azimuth)) / sin2_);
            sum.i += mu * 2.0 * kPi / kSteps;
            sum.q += mu * 2.0 * kPi / kSteps * std::cos(2.0 * azimuth);
        }
        return sum;
    }

    double theta_, sin_theta_, sin2_, u_;
};

/// The share of the light of a disc on a plane whose coordinate is below s (in radii).
double projected_share(double s, double u) {
    s = std::clamp(s, -1.0, 1.0);
    const double even = 0.5 + (s * std::sqrt(1.0 - s * s) + std::asin(s)) / kPi;
    const double domed = 0.5 + 0.75 * (s - s * s * s / 3.0);
    // The two parts of the law hold 1 − u and 2u/3 of the light.
    return ((1.0 - u) * even + 2.0 / 3.0 * u * domed) / (1.0 - u / 3.0);
}

double legendre(int l, double x) {
    double before = 1.0, now = x;
    if (l == 0) return before;
    for (int k = 2; k <= l; ++k)
        before = std::exchange(now, ((2.0 * k - 1.0) * x * now - (k - 1.0) * before) / k);
    return now;
}

/// Of a rule for pieces from 0 to 1.
struct PieceNode {
    double place, weight;
};
std::vector<PieceNode> make_piece_rule(int n, bool with_roots) {
    const QuadratureRule gauss = gauss_legendre(n);
    std::vector<PieceNode> nodes;
    for (std::size_t k = 0; k < gauss.nodes.size(); ++k) {
        const double s = 0.5 * (1.0 + gauss.nodes[k]), w = 0.5 * gauss.weights[k];
        // 3s² − 2s³ has no slope at 0 and 1, and so makes square roots there smooth.
        if (with_roots)
            nodes.push_back({s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) * w});
        else
            nodes.push_back({s, w});
    }
    return nodes;
}
const std::vector<PieceNode>& piece_rule(bool with_roots) {
    static const std::vector<PieceNode> rooted = make_piece_rule(8, true),
                                        smooth = make_piece_rule(4, false);
    return with_roots ? rooted : smooth;
}

/// Each polarisation keeps `same` of itself and takes `other` of the other.
DEWBOW_SIMD
void add_scaled(double same, double other, std::span<const Intensities> in,
                std::span<Intensities> sum) {
    for (std::size_t c = 0; c < in.size(); ++c) {
        sum[c].perpendicular += same * in[c].perpendicular + other * in[c].parallel;
        sum[c].parallel += other * in[c].perpendicular + same * in[c].parallel;
    }
}

}  // namespace

double disc_profile(const SunDisc& disc, Angle from_centre) {
    check(disc);
    const double sin2 = sin2_half(disc.radius.to(unit::rad));
    const double mu2 = 1.0 - sin2_half(from_centre.to(unit::rad)) / sin2;
    if (!(mu2 >= 0.0)) return 0.0;
    const double u = disc.limb_darkening;
    return (1.0 - u * (1.0 - std::sqrt(mu2))) / (4.0 * kPi * sin2 * (1.0 - u / 3.0));
}

double legendre_factor(const SunDisc& disc, int l) {
    check(disc);
    const double radius = disc.radius.to(unit::rad), u = disc.limb_darkening;
    if (radius == 0.0 || l == 0) return 1.0;
    // ∫ P_l I dω over the disc with sin²(ρ/2) = sin²(R/2) (1 − μ²): dω = 8π sin²(R/2) μ dμ.
    static const QuadratureRule rule = gauss_legendre(200);
    const double sin2 = sin2_half(radius);
    const double integral = integrate(rule, 0.0, 1.0, [&](double mu) {
        return mu * (1.0 - u * (1.0 - mu)) * legendre(l, 1.0 - 2.0 * sin2 * (1.0 - mu * mu));
    });
    return 2.0 * integral / (1.0 - u / 3.0);
}

std::vector<double> projection_kernel(const SunDisc& disc, Angle bin) {
    check(disc);
    if (!(bin > Angle{}))
        throw InputError(fmt::format("bins of {:.6g}°; expected more than 0°", bin.to(unit::deg)));
    if (disc.radius == Angle{}) return {1.0};
    const double width = bin / disc.radius;
    const int reach = static_cast<int>(std::ceil(1.0 / width - 0.5));
    std::vector<double> taps;
    for (int k = -reach; k <= reach; ++k)
        taps.push_back(projected_share((k + 0.5) * width, disc.limb_darkening) -
                       projected_share((k - 0.5) * width, disc.limb_darkening));
    return taps;
}

std::array<double, 5> published_sun_kernel() {
    std::array<double, 5> taps;
    double sum = 0.0;
    for (int k = -2; k <= 2; ++k) sum += taps[k + 2] = std::sqrt(0.25 * 0.25 - 0.01 * k * k);
    for (double& tap : taps) tap /= sum;
    return taps;
}

SunSmoother::SunSmoother(std::span<const Angle> angles, const SunDisc& disc)
    : SunSmoother(angles, disc, [&] {
          std::vector<std::size_t> all(angles.size());
          std::iota(all.begin(), all.end(), std::size_t{0});
          return all;
      }()) {}

SunSmoother::SunSmoother(std::span<const Angle> angles, const SunDisc& disc,
                         std::span<const std::size_t> wanted)
    : angles_(angles.size()) {
    check(disc);
    std::vector<double> grid;
    for (const Angle angle : angles) grid.push_back(angle.to(unit::rad));
    const bool ordered =
        !grid.empty() && std::adjacent_find(grid.begin(), grid.end(), [](double a, double b) {
                             return !(a < b);
                         }) == grid.end();
    if (!ordered || !(grid.front() >= 0.0 && grid.back() <= kPi * (1.0 + kRounding)))
        throw InputError("angles for the sun's disc; expected at least one, ascending, 0° to 180°");
    for (const std::size_t i : wanted) {
        if (disc.radius == Angle{}) {
            rows_.push_back({i, weights_.size(), 1});
            weights_.push_back({1.0, 1.0});
        } else {
            add_row(grid, grid[i], disc);
        }
    }
}

void SunSmoother::add_row(std::span<const double> grid, double theta, const SunDisc& disc) {
    const double radius = disc.radius.to(unit::rad);
    const double low = std::max(0.0, theta - radius), high = std::min(kPi, theta + radius);
    const auto index_of = [&](double t) {
        const auto above = std::upper_bound(grid.begin(), grid.end(), t);
        return static_cast<std::size_t>(above - grid.begin());
    };
    const std::size_t first = index_of(low) > 0 ? index_of(low) - 1 : 0;
    const std::size_t last = std::min(index_of(high), grid.size() - 1);
    const Row row{first, weights_.size(), last - first + 1};
    weights_.resize(weights_.size() + row.count);
    Weight* const weights = weights_.data() + row.first_weight;

    // Between these points the integrand is smooth; at the ends and at the poles' shadow it goes
    // like a square root.
    std::vector<double> breaks = {low, high};
    for (const double t : {radius - theta, 2.0 * kPi - radius - theta})
        if (t > low && t < high) breaks.push_back(t);
    const std::vector<double> roots = breaks;
    for (std::size_t j = first; j <= last; ++j)
        if (grid[j] > low && grid[j] < high) breaks.push_back(grid[j]);
    std::sort(breaks.begin(), breaks.end());
    const auto is_root = [&](double t) {
        return std::find(roots.begin(), roots.end(), t) != roots.end();
    };

    const Arcs arcs(theta, disc);
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
        const double a = breaks[k], width = breaks[k + 1] - a;
        const std::size_t above = index_of(a + 0.5 * width);  // of the grid, or its size
        const bool inside = above > 0 && above < grid.size();
        const std::size_t upper = std::min(above, grid.size() - 1) - first;
        for (const PieceNode& node : piece_rule(is_root(a) || is_root(breaks[k + 1]))) {
            const double t = a + width * node.place;
            const Arc arc = arcs(t);
            const double measure = node.weight * width * std::sin(t);
            const double share =
                inside ? (t - grid[above - 1]) / (grid[above] - grid[above - 1]) : 1.0;
            weights[upper].i += share * measure * arc.i;
            weights[upper].q += share * measure * arc.q;
            if (inside) {
                weights[upper - 1].i += (1.0 - share) * measure * arc.i;
                weights[upper - 1].q += (1.0 - share) * measure * arc.q;
            }
            sum += measure * arc.i;
        }
    }
    for (std::size_t j = 0; j < row.count; ++j)
        weights[j] = {weights[j].i / sum, weights[j].q / sum};
    rows_.push_back(row);
}

void SunSmoother::apply(std::span<const Intensities> in, std::span<Intensities> out) const {
    const std::size_t columns = in.size() / angles_;
    DEWBOW_CHECK(in.size() == columns * angles_ && out.size() == columns * rows_.size(),
                 "a row of intensities for each angle");
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const Row& row = rows_[r];
        const std::span<Intensities> sum = out.subspan(r * columns, columns);
        std::fill(sum.begin(), sum.end(), Intensities{});
        for (std::size_t j = 0; j < row.count; ++j) {
            const Weight& w = weights_[row.first_weight + j];
            add_scaled(0.5 * (w.i + w.q), 0.5 * (w.i - w.q),
                       in.subspan((row.first_angle + j) * columns, columns), sum);
        }
    }
}

void SunSmoother::apply(std::span<const double> in, std::span<double> out) const {
    const std::size_t columns = in.size() / angles_;
    DEWBOW_CHECK(in.size() == columns * angles_ && out.size() == columns * rows_.size(),
                 "a row of values for each angle");
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        const Row& row = rows_[r];
        for (std::size_t c = 0; c < columns; ++c) {
            double sum = 0.0;
            for (std::size_t j = 0; j < row.count; ++j)
                sum += weights_[row.first_weight + j].i * in[(row.first_angle + j) * columns + c];
            out[r * columns + c] = sum;
        }
    }
}

}  // namespace dewbow
