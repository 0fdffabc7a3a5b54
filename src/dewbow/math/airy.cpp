// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/airy.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "dewbow/base/simd.h"

namespace dewbow {
namespace {

/// From here outwards the asymptotic series reach 1e-17.
constexpr double kAsymptotic = 10.0;
constexpr double kInverseRootPi = std::numbers::inv_sqrtpi;

/// Solves y'' = x y from (a, y, dy) to a + d; |d| <= 1/2 and |a| <= 10.
template <class Real>
struct Solution {
    Real y, dy;

    Solution at(Real a, Real d) const {
        constexpr int kTerms = 30;             // √10^30 / (2^30 30!) = 4e-27
        Real before = 0, term = y, next = dy;  // t_{k-1}, t_k, t_{k+1} of Σ t_k d^k
        Solution sum{y, 0};
        Real power = 1;  // d^k
        for (int k = 0; k < kTerms; ++k) {
            sum.dy += (k + 1) * next * power;
            power *= d;
            sum.y += next * power;
            const Real after = (a * term + before) / ((k + 1) * (k + 2));
            before = term, term = next, next = after;
        }
        return sum;
    }
};

/// (2/3) |x|^{3/2} and what rounding took from it.
struct Phase {
    double value, rest;
};
Phase airy_phase(double x) {
    const double root = std::sqrt(x), root_rest = std::fma(-root, root, x) / (2.0 * root);
    const double product = x * root, product_rest = std::fma(x, root, -product) + x * root_rest;
    const double value = product / 1.5, rest = std::fma(-value, 1.5, product) / 1.5;
    return {value, rest + product_rest / 1.5};
}

/// Σ i^k u_k / ζ^k and Σ i^k v_k / ζ^k with i² = `square`: even and odd terms.
/// u_k = (6k−5)(6k−3)(6k−1) / (216 k (2k−1)) u_{k−1}, v_k = (6k+1)/(1−6k) u_k.     [DLMF 9.7.2]
struct Series {
    double u_even = 1.0, u_odd = 0.0, v_even = 1.0, v_odd = 0.0;

    Series(double zeta, double square) {
        constexpr double kEnough = 1e-18;
        double u = 1.0;
        for (int k = 1; std::abs(u) > kEnough && k < 2.0 * zeta; ++k) {
            u *= (6.0 * k - 5.0) * (6.0 * k - 3.0) * (6.0 * k - 1.0) /
                 (216.0 * k * (2.0 * k - 1.0) * zeta);
            if (k % 2 == 0) u *= square;
            const double v = u * (6.0 * k + 1.0) / (1.0 - 6.0 * k);
            (k % 2 == 0 ? u_even : u_odd) += u;
            (k % 2 == 0 ? v_even : v_odd) += v;
        }
    }
};

AiryPair far_above(double x) {
    const Phase zeta = airy_phase(x);
    const Series s(zeta.value, 1.0);
    const double scale = 0.5 * kInverseRootPi * std::exp(-zeta.value) * (1.0 - zeta.rest);
    const double root4 = std::sqrt(std::sqrt(x));
    return {scale / root4 * (s.u_even - s.u_odd), -scale * root4 * (s.v_even - s.v_odd)};
}

AiryPair far_below(double x) {
    const Phase zeta = airy_phase(-x);
    const Series s(zeta.value, -1.0);
    const double c0 = std::cos(zeta.value), s0 = std::sin(zeta.value);
    // Of ζ − π/4, with ζ = value + rest.
    const double ch = (c0 + s0) / std::numbers::sqrt2, sh = (s0 - c0) / std::numbers::sqrt2;
    const double cosine = ch - zeta.rest * sh, sine = sh + zeta.rest * ch;
    const double root4 = std::sqrt(std::sqrt(-x));
    return {kInverseRootPi / root4 * (cosine * s.u_even + sine * s.u_odd),
            kInverseRootPi * root4 * (sine * s.v_even - cosine * s.v_odd)};
}

/// Ai and Ai' at the halves from -10 to 10.
class Nodes {
public:
    static constexpr double kStep = 0.5;
    static constexpr int kZero = 20, kCount = 41;  // of x = 0; of nodes

    Nodes() {
        // Ai(0) = 3^{-2/3} / Γ(2/3), Ai'(0) = -3^{-1/3} / Γ(1/3).              [DLMF 9.2.3, 9.2.4]
        nodes_[kZero] = {0.355028053887817239260063186004183177L,
                         -0.258819403792806798405183560189203963L};
        for (int i = kZero; i > 0; --i) nodes_[i - 1] = nodes_[i].at(x(i), -kStep);
        // Upwards any error would grow as Bi does; downwards it dies out.
        const AiryPair last = far_above(x(kCount - 1));
        nodes_[kCount - 1] = {last.value, last.derivative};
        for (int i = kCount - 1; i > kZero + 1; --i) nodes_[i - 1] = nodes_[i].at(x(i), -kStep);
    }
    AiryPair at(double argument) const {
        const int i = static_cast<int>(std::lround(argument / kStep)) + kZero;
        const Solution<double> node{static_cast<double>(nodes_[i].y),
                                    static_cast<double>(nodes_[i].dy)};
        const Solution<double> there = node.at(x(i), argument - x(i));
        return {there.y, there.dy};
    }

private:
    static double x(int node) { return (node - kZero) * kStep; }

    std::array<Solution<long double>, kCount> nodes_;
};

/// Those of `x` that lie in the table.
DEWBOW_SIMD void interpolate_all(const double* nodes, const double* x, double* __restrict value,
                                 double* __restrict derivative, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const AiryPair pair = AiryTable::interpolate(nodes, x[i]);
        value[i] = pair.value, derivative[i] = pair.derivative;
    }
}

bool is_in_table(double x) { return x >= AiryTable::kLowest && x <= AiryTable::kHighest; }

}  // namespace

AiryPair airy(double x) {
    static const Nodes nodes;
    if (x > kAsymptotic) return far_above(x);
    if (x < -kAsymptotic) return far_below(x);
    return std::isnan(x) ? AiryPair{x, x} : nodes.at(x);
}

AiryTable::AiryTable() {
    const int count = static_cast<int>(kHighest - kLowest) * kNodesPerUnit + 1;
    nodes_.reserve(2 * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const AiryPair pair = airy(kLowest + i * (1.0 / kNodesPerUnit));
        nodes_.push_back(pair.value);
        nodes_.push_back(pair.derivative);
    }
}

const AiryTable& AiryTable::instance() {
    static const AiryTable table;
    return table;
}

void AiryTable::eval(std::span<const double> x, std::span<double> value,
                     std::span<double> derivative) const {
    for (std::size_t i = 0; i < x.size();) {
        std::size_t end = i;
        while (end < x.size() && is_in_table(x[end])) ++end;
        interpolate_all(nodes_.data(), &x[i], &value[i], &derivative[i], end - i);
        if (end < x.size()) {
            const AiryPair pair = airy(x[end]);
            value[end] = pair.value, derivative[end] = pair.derivative;
            ++end;
        }
        i = end;
    }
}

}  // namespace dewbow
