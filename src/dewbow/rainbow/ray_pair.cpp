// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/ray_pair.h"

#include <cmath>
#include <numbers>

#include "dewbow/math/root_finding.h"
#include "dewbow/rainbow/drop_ray.h"

namespace dewbow {
namespace {

using Complex = std::complex<double>;
constexpr double kPi = std::numbers::pi;

/// The Taylor series of a function of b to the second power.
struct Jet {
    Complex c0, c1, c2;

    friend Jet operator+(const Jet& a, const Jet& b) {
        return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2};
    }
    friend Jet operator-(const Jet& a, const Jet& b) {
        return {a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2};
    }
    friend Jet operator*(const Jet& a, const Jet& b) {
        return {a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0};
    }
    friend Jet operator*(double s, const Jet& a) { return {s * a.c0, s * a.c1, s * a.c2}; }
    friend Jet operator+(double s, const Jet& a) { return {s + a.c0, a.c1, a.c2}; }
    friend Jet operator/(const Jet& a, const Jet& b) {
        const Complex q0 = a.c0 / b.c0, q1 = (a.c1 - q0 * b.c1) / b.c0;
        return {q0, q1, (a.c2 - q0 * b.c2 - q1 * b.c1) / b.c0};
    }
};
Jet sqrt(const Jet& a) {
    const Complex root = std::sqrt(a.c0), slope = 0.5 * a.c1 / root;
    return {root, slope, 0.5 * (a.c2 - slope * slope) / root};
}
Jet power(const Jet& a, int exponent) {
    Jet product{1.0, 0.0, 0.0};
    for (int k = 0; k < exponent; ++k) product = product * a;
    return product;
}
/// √(1 - b²/n²) with the value `c` that continues it to where one wants it.
Jet cosine(const Complex& b, const Complex& c, double n) {
    const Complex slope = -b / (n * n * c);
    return {c, slope, -0.5 * (1.0 / (n * n) + slope * slope) / c};
}

/// What a ray makes of light in each polarisation, without √(2/(π sin θ)) and the phase.
struct RayWeight {
    Jet leading, over_b, correction;
};

/// g, g / b and g c for the angles whose cosines are C outside and c inside. `outer` and `inner`
/// are 1 and n for perpendicular light, n and 1 for parallel.
///
/// c = φ + κ ((p - 1)/r - (p + 1)): φ is what the second terms of the Hankel functions' phases add,
/// κ what those of their logarithmic derivatives do to the reflection, r -> (r + iκ/x)/(1 + iκ/x).
RayWeight ray_weight(const Jet& b, const Jet& C, const Jet& c, double n, int p, double outer,
                     double inner) {
    const Jet sum = outer * C + inner * c, r = (outer * C - inner * c) / sum;
    const Jet tan2_i = (b * b) / (C * C), tan2_r = (1.0 / (n * n)) * ((b * b) / (c * c));
    const Jet kappa = (0.5 * outer * tan2_i - (0.5 * inner / n) * tan2_r) / sum;
    const Jet phi =
        (1.0 / 12.0) * ((3.0 + 5.0 * tan2_i) / C) - (p / (12.0 * n)) * ((3.0 + 5.0 * tan2_r) / c);
    const Jet without_r = (1.0 + -1.0 * (r * r)) * power(-1.0 * r, p - 2) * sqrt(b);
    const Jet g = -1.0 * (without_r * r);
    const Jet correction = g * (phi - double(p + 1) * kappa) - double(p - 1) * (without_r * kappa);
    return {g, g / b, correction};
}

/// A function and its first two derivatives by t, times db/dt.
struct InT {
    Complex value, first, second;
};

/// One ray: where it is and how b runs with t there.
struct Saddle {
    Complex incidence, b, C, c, path;
    Complex t, b1, b2, b3;  ///< t and the derivatives of b by t

    InT in_t(const Jet& g) const {
        const Complex g1 = g.c1 * b1, g2 = 2.0 * g.c2 * b1 * b1 + g.c1 * b2;
        return {g.c0 * b1, g1 * b1 + g.c0 * b2, g2 * b1 + 2.0 * g1 * b2 + g.c0 * b3};
    }
};

/// The ray of deviation D by Newton's method, from a start near enough.
Complex solve_incidence(const BowGeometry& bow, Complex deviation, Complex start) {
    constexpr double kLongestStep = 0.1, kEnough = 1e-15;
    constexpr int kMostSteps = 80;
    Complex i = start;
    for (int k = 0; k < kMostSteps; ++k) {
        const Complex s = std::sin(i), r = std::asin(s / bow.n);
        const Complex excess = (bow.p - 1) * kPi + 2.0 * i - 2.0 * double(bow.p) * r - deviation;
        const Complex slope = 2.0 - 2.0 * bow.p * std::cos(i) / (bow.n * std::cos(r));
        Complex step = excess / slope;
        const double length = std::abs(step);
        if (length > kLongestStep) step *= kLongestStep / length;
        i -= step;
        if (length < kEnough) break;
    }
    return i;
}

Saddle saddle_at(const BowGeometry& bow, Complex incidence) {
    Saddle ray;
    ray.incidence = incidence;
    ray.b = std::sin(incidence), ray.C = std::cos(incidence);
    ray.c = std::sqrt(1.0 - ray.b * ray.b / (bow.n * bow.n));
    ray.path = 2.0 * (bow.p * bow.n * ray.c - ray.C);
    return ray;
}

/// How b runs with t at the saddle t, from Φ(b(t)) = η - t³/3 + ζt differentiated two to four
/// times.
void join_to(Saddle& ray, const BowGeometry& bow, Complex t) {
    const Complex C = ray.C, N = bow.n * ray.c, b = ray.b, b_2 = b * b;
    const double p = bow.p;
    // dD/db and its derivatives: 2/C - 2p/N, with C² = 1 - b², N² = n² - b².
    const Complex C3 = C * C * C, N3 = N * N * N;
    const Complex d1 = 2.0 / C - 2.0 * p / N, d2 = 2.0 * b / C3 - 2.0 * p * b / N3,
                  d3 = 2.0 * (1.0 + 2.0 * b_2) / (C3 * C * C) -
                       2.0 * p * (bow.n * bow.n + 2.0 * b_2) / (N3 * N * N);
    ray.t = t;
    ray.b1 = std::sqrt(2.0 * t / d1);
    if (ray.b1.real() < 0.0) ray.b1 = -ray.b1;
    const Complex b1 = ray.b1;
    ray.b2 = (2.0 - d2 * b1 * b1 * b1) / (3.0 * d1 * b1);
    ray.b3 = -(d3 * b1 * b1 * b1 * b1 + 6.0 * d2 * b1 * b1 * ray.b2 + 3.0 * d1 * ray.b2 * ray.b2) /
             (4.0 * d1 * b1);
}

/// Bleistein's first two terms of G(t) = P + Q t + (t² - ζ) H(t): those of G, and those of H',
/// from what G is at t = -a and t = a.
struct Expansion {
    Complex P, Q, P_of_H, Q_of_H;

    Expansion(const InT& minus, const InT& plus, Complex a) {
        P = 0.5 * (plus.value + minus.value);
        Q = 0.5 * (plus.value - minus.value) / a;
        const Complex H_plus = 0.25 * (plus.second - (plus.first - Q) / a) / a;
        const Complex H_minus = -0.25 * (minus.second + (minus.first - Q) / a) / a;
        P_of_H = 0.5 * (H_plus + H_minus);
        Q_of_H = 0.5 * (H_plus - H_minus) / a;
    }
};

PairAmplitude<Complex> pair_amplitude(const BowGeometry& bow, const Saddle& minus,
                                      const Saddle& plus, double outer, double inner) {
    const auto weight = [&](const Saddle& ray) {
        return ray_weight({ray.b, 1.0, 0.0}, cosine(ray.b, ray.C, 1.0), cosine(ray.b, ray.c, bow.n),
                          bow.n, bow.p, outer, inner);
    };
    const RayWeight w = weight(minus), v = weight(plus);
    const auto expand = [&](const Jet& f, const Jet& g) {
        return Expansion(minus.in_t(f), plus.in_t(g), plus.t);
    };
    const Expansion leading = expand(w.leading, v.leading), over_b = expand(w.over_b, v.over_b),
                    correction = expand(w.correction, v.correction);
    // Integration by parts: ∫ (t² - ζ) H e^{-ix(t³/3 - ζt)} dt = -(i/x) ∫ H' e^{…} dt.
    return {leading.P,
            leading.Q,
            over_b.P,
            over_b.Q,
            correction.P - leading.P_of_H,
            correction.Q - leading.Q_of_H};
}

}  // namespace

BowGeometry bow_geometry(RelativeIndex n, int p) {
    const DescartesRay ray = descartes_ray(n, p);
    BowGeometry bow{.n = n.value, .p = p};
    bow.least = ray.deviation.to(unit::rad);
    bow.incidence = ray.ray.incidence.to(unit::rad);
    bow.curvature = ray.airy_constant;
    bow.most = (p - 1) * kPi;
    bow.span = p * kPi - 2.0 * p * std::asin(1.0 / n.value) - bow.least;
    return bow;
}

RayPair<Complex> separate_rays(const BowGeometry& bow, Complex offset) {
    // To begin with as if D were a parabola of i.
    const double cos_i = std::cos(bow.incidence);
    const Complex apart = std::sqrt(offset / bow.curvature) / cos_i;
    const Complex D = bow.least + offset;
    Saddle minus = saddle_at(bow, solve_incidence(bow, D, bow.incidence - apart));
    Saddle plus = saddle_at(bow, solve_incidence(bow, D, bow.incidence + apart));

    // ζ³ = (¾ (Φ₊ - Φ₋))²; of its three roots the one near offset / h^{1/3}.
    const Complex turn = std::polar(1.0, 2.0 * kPi / 3.0);
    const Complex difference = 0.75 * (plus.path - minus.path), guess = offset;
    Complex zeta = std::pow(difference * difference, 1.0 / 3.0);
    Complex nearest = zeta;
    for (int k = 0; k < 2; ++k) {
        zeta *= turn;
        if (std::real(zeta * std::conj(guess)) > std::real(nearest * std::conj(guess)))
            nearest = zeta;
    }
    const Complex a = difference / nearest;
    join_to(minus, bow, -a);
    join_to(plus, bow, a);
    return {nearest, 0.5 * (plus.path + minus.path), pair_amplitude(bow, minus, plus, 1.0, bow.n),
            pair_amplitude(bow, minus, plus, bow.n, 1.0)};
}

RayPair<double> ray_pair(const BowGeometry& bow, double offset) {
    // Nearer to the bow than `apart`, differences between the rays would lose too many digits. The
    // mean of 2 kHalf points is exact but for (radius / distance of the end)^{2 kHalf} = 1e-17.
    constexpr int kHalf = 16;
    const double apart = bow.span / 8.0, radius = 2.0 * apart;
    const bool is_apart = std::abs(offset) > apart;
    const int points = is_apart ? 1 : kHalf;
    RayPair<double> mean{};
    const auto sums = mean.list();
    for (int k = 0; k < points; ++k) {
        // The other half circle has the conjugate values.
        const Complex at =
            is_apart ? Complex(offset) : offset + std::polar(radius, kPi * (k + 0.5) / kHalf);
        const RayPair<Complex> pair = separate_rays(bow, at);
        const auto values = pair.list();
        for (std::size_t f = 0; f < sums.size(); ++f) *sums[f] += values[f]->real() / points;
    }
    return mean;
}

LoneRay lone_ray(const BowGeometry& bow, double offset) {
    const RelativeIndex n{bow.n};
    const double D = bow.least + offset;
    const auto excess = [&](double i) {
        return bow.most + 2.0 * i - 2.0 * bow.p * std::asin(std::sin(i) / bow.n) - D;
    };
    const double i = find_root(excess, 0.0, bow.incidence).value_or(0.0), b = std::sin(i);
    const DropRay ray = drop_ray(b, n);
    const double slope = std::abs(deviation_slope(ray, n, bow.p));
    // Near the axis most - D is slope b; where both vanish rounding would have the say.
    constexpr double kAxial = 1e-6;
    const double focus = b < kAxial ? 1.0 / slope : b / (bow.most - D);
    const RayAmplitudes left = ray_amplitudes(ray, n, bow.p);
    const double scale = std::sqrt(focus / slope);
    return {2.0 * (bow.p * bow.n * cos(ray.refraction) - cos(ray.incidence)),
            left.perpendicular * scale, left.parallel * scale};
}

RayPair<double> lone_pair(const BowGeometry& bow, double offset, const LoneRay& ray) {
    const double along_surface = 2.0 * bow.p * std::sqrt(bow.n * bow.n - 1.0) + offset - bow.span;
    const double difference = 0.75 * (along_surface - ray.path);
    RayPair<double> pair{};
    pair.zeta = std::cbrt(difference * difference);
    pair.path = 0.5 * (along_surface + ray.path);
    // G(-a) = P - aQ = √(2a) ε √(b / |dD/db|), G(a) = P + aQ = 0.
    const double a = std::sqrt(pair.zeta), scale = std::sqrt(0.5 * a);
    pair.perpendicular.P = scale * ray.perpendicular;
    pair.perpendicular.Q = -scale / a * ray.perpendicular;
    pair.parallel.P = scale * ray.parallel;
    pair.parallel.Q = -scale / a * ray.parallel;
    return pair;
}

}  // namespace dewbow
