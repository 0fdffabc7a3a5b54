// SPDX-License-Identifier: Apache-2.0

// make_reflectance, make_emission and make_absorption of rgb.h: smooth spectra for RGB numbers.
//
// A reflectance is S(λ) = σ(c₀ t² + c₁ t + c₂), σ(x) = 1/2 + x / (2 √(1 + x²)), with t running from
// −1 to 1 over the visible range.  [Jakob & Hanika 2019, "A Low-Dimensional Function Space for
// Efficient Spectral Upsampling", eq. 3–4]  S lies in (0, 1) whatever the coefficients, so energy
// is conserved. The three coefficients are the solution of three equations, L*a*b* of S under D65 =
// L*a*b* of the colour, by damped Gauss–Newton steps (Levenberg–Marquardt) with the exact Jacobian.

#include <algorithm>
#include <cmath>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/lab.h"
#include "dewbow/spectrum/lanewise.h"
#include "dewbow/spectrum/matrix3.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

double sigmoid(double x) {
    const double s = 0.5 + 0.5 * x / std::sqrt(1.0 + x * x);
    return std::min(1.0, std::max(0.0, s));
}
/// The x with sigmoid(x) = `s`, 0 < s < 1.
double inverse_sigmoid(double s) { return (s - 0.5) / std::sqrt(s * (1.0 - s)); }

/// −1 to 1 over the visible range.
double normalised_wavelength(double lambda_nm) {
    constexpr double kCentre_nm = 0.5 * (kLambdaMin_nm + kLambdaMax_nm);
    constexpr double kHalfRange_nm = 0.5 * (kLambdaMax_nm - kLambdaMin_nm);
    return (lambda_nm - kCentre_nm) * (1.0 / kHalfRange_nm);
}

class SigmoidSpectrum final : public Lanewise<SigmoidSpectrum> {
public:
    explicit SigmoidSpectrum(const Triple& c) : c_(c) {}
    double value_at(double lambda_nm) const { return sigmoid(exponent(lambda_nm)); }

    double max_value() const override {
        double largest = std::max(quadratic(-1.0), quadratic(1.0));
        const double vertex = -0.5 * c_[1] / c_[0];
        if (std::abs(vertex) < 1.0) largest = std::max(largest, quadratic(vertex));
        return sigmoid(largest);
    }

private:
    double quadratic(double t) const { return (c_[0] * t + c_[1]) * t + c_[2]; }
    double exponent(double lambda_nm) const { return quadratic(normalised_wavelength(lambda_nm)); }

    Triple c_;
};

/// What a reflectance, given at nodes every 5 nm and linear between them, does to white D65 light:
/// (X/X_n, Y/Y_n, Z/Z_n) = Σ_j weight[c][j] S(t_j). The weights are integrals of D65 times a curve
/// of the observer times the node's hat function, so that the tables' fine structure is not lost.
struct NodeWeights {
    static constexpr int kNodes = 95;
    static constexpr double kSpacing_nm = 5.0;
    std::array<double, kNodes> t{};
    std::array<std::array<double, kNodes>, 3> weight{};
};

NodeWeights compute_node_weights() {
    const SpectrumPtr d65 = find_illuminant("D65");
    NodeWeights nodes;
    for (int j = 0; j < NodeWeights::kNodes; ++j) {
        nodes.t[j] = normalised_wavelength(kLambdaMin_nm + j * NodeWeights::kSpacing_nm);
    }
    constexpr double kStep_nm = 0.5;
    Triple total{};
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; lambda_nm += kStep_nm) {
        const double place = (lambda_nm - kLambdaMin_nm) / NodeWeights::kSpacing_nm;
        const int j = std::min(int(place), NodeWeights::kNodes - 2);
        const auto bar = cie_xyz_bar(lambda_nm);
        for (std::size_t c = 0; c < 3; ++c) {
            const double density = (*d65)(lambda_nm * unit::nm) * bar[c];
            nodes.weight[c][j] += density * (j + 1 - place);
            nodes.weight[c][j + 1] += density * (place - j);
            total[c] += density;
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        for (double& weight : nodes.weight[c]) weight /= total[c];
    }
    return nodes;
}

const NodeWeights& node_weights() {
    static const NodeWeights kNodes = compute_node_weights();
    return kNodes;
}

/// (X/X_n, Y/Y_n, Z/Z_n) of the reflectance with some coefficients, and its derivative by each of
/// them.
struct RelativeColour {
    Triple value{};
    Matrix3 by_coefficient;  ///< [channel][coefficient]
};

RelativeColour relative_colour(const Triple& c) {
    const NodeWeights& nodes = node_weights();
    RelativeColour result;
    for (int j = 0; j < NodeWeights::kNodes; ++j) {
        const double t = nodes.t[j];
        const double x = (c[0] * t + c[1]) * t + c[2];
        const double r = 1.0 / std::sqrt(1.0 + x * x);
        const double s = 0.5 + 0.5 * x * r;
        const double slope = 0.5 * r * r * r;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double weight = nodes.weight[channel][j];
            const double weighted_slope = weight * slope;
            result.value[channel] += weight * s;
            result.by_coefficient[channel][0] += weighted_slope * t * t;
            result.by_coefficient[channel][1] += weighted_slope * t;
            result.by_coefficient[channel][2] += weighted_slope;
        }
    }
    return result;
}

/// d(L*, a*, b*) by d(X/X_n, Y/Y_n, Z/Z_n).
Matrix3 lab_derivative(const Triple& relative) {
    const double dx = lab_curve_slope(relative[0]);
    const double dy = lab_curve_slope(relative[1]);
    const double dz = lab_curve_slope(relative[2]);
    return {{Triple{0.0, 116.0 * dy, 0.0}, Triple{500.0 * dx, -500.0 * dy, 0.0},
             Triple{0.0, 200.0 * dy, -200.0 * dz}}};
}

/// Coefficients on their way to the solution.
struct Fit {
    Triple c{};
    Triple residual{};  ///< L*a*b* of the reflectance less that of the colour
    Matrix3 jacobian;
    double error() const { return std::sqrt(dot(residual, residual)); }
};

Fit fit_at(const Triple& c, const Colour<CieLab>& target) {
    const RelativeColour colour = relative_colour(c);
    const Colour<CieLab> residual = lab_from_relative(colour.value) - target;
    return {c, residual.v, lab_derivative(colour.value) * colour.by_coefficient};
}

/// Where the step of damping `damping` leads: (JᵀJ + damping · diag JᵀJ) step = −Jᵀ residual.
Triple damped_step(const Fit& fit, double damping) {
    const Matrix3 transposed_jacobian = transposed(fit.jacobian);
    Matrix3 normal = transposed_jacobian * fit.jacobian;
    for (std::size_t i = 0; i < 3; ++i) normal[i][i] *= 1.0 + damping;
    const Triple step = inverse(normal) * (transposed_jacobian * fit.residual);
    return {fit.c[0] - step[0], fit.c[1] - step[1], fit.c[2] - step[2]};
}

/// L*a*b* error at which a fit is good: a thousandth of what anybody can see.
constexpr double kGoodFit = 1e-3;
/// Most steps of a fit, about 1 us each. Of 1e5 sRGB colours, corners, edges and very dark ones
/// (down to 1e-7 of white) among them, half took 5 or less; the 1 % that took all were left with an
/// error of at most 0.06.
constexpr int kMostSteps = 40;

bool is_finite(const Triple& c) {
    return std::isfinite(c[0]) && std::isfinite(c[1]) && std::isfinite(c[2]);
}

/// Coefficients near `start` whose reflectance has L*a*b* `target`, or comes nearest.
Fit solve(const Triple& start, const Colour<CieLab>& target, double good_fit) {
    Fit best = fit_at(start, target);
    double damping = 1e-3;
    for (int step = 0; step < kMostSteps && best.error() > good_fit; ++step) {
        const Triple c = damped_step(best, damping);
        const Fit next = is_finite(c) ? fit_at(c, target) : best;
        if (next.error() < best.error()) {
            best = next;
            damping *= 0.1;
        } else {
            damping = std::max(10.0 * damping, 1e-6);
        }
    }
    return best;
}

double clamped_to_unit(double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; }

/// A colour darker than this in each channel is taken for a grey of its luminance: a millionth of
/// white.
constexpr double kDarkest = 1e-6;

double luminance(Colour<LinearSrgb> rgb) { return xyz_from_rgb(rgb)[1]; }
double largest(Colour<LinearSrgb> rgb) { return std::max({rgb[0], rgb[1], rgb[2]}); }
bool is_grey(Colour<LinearSrgb> rgb) { return rgb[0] == rgb[1] && rgb[1] == rgb[2]; }

Triple sigmoid_coefficients(Colour<LinearSrgb> rgb) {
    // Relative to the white of the colour space, whose rounded chromaticity is not quite that of
    // the table: so saturated colours join the exact greys without a seam.
    const Colour<LinearSrgb> white{{1.0, 1.0, 1.0}};
    const Colour<CieLab> target = lab_from_xyz(xyz_from_rgb(rgb), xyz_from_rgb(white));
    const Triple start{0.0, 0.0, inverse_sigmoid(std::min(luminance(rgb), 0.999))};
    return solve(start, target, kGoodFit * std::min(1.0, target[0])).c;
}

constexpr int kTableIntervals = 470;  ///< of 1 nm

/// A table every 1 nm of `f(lambda_nm, reflectance)`.
template <class Function>
SpectrumPtr make_table_from(const Spectrum& reflectance, Function f) {
    std::vector<double> lambda_nm, value;
    for (int i = 0; i <= kTableIntervals; ++i) {
        lambda_nm.push_back(kLambdaMin_nm + i);
        value.push_back(f(lambda_nm.back(), reflectance(lambda_nm.back() * unit::nm)));
    }
    return make_tabulated(std::move(lambda_nm), std::move(value), OutsideTable::hold);
}

/// What absorbs more is taken to absorb this much: 13.8 e-foldings.
constexpr double kLeastTransmittance = 1e-6;

}  // namespace

SpectrumPtr make_reflectance(Colour<LinearSrgb> rgb) {
    for (double& channel : rgb.v) channel = clamped_to_unit(channel);
    if (is_grey(rgb)) return make_constant(rgb[0]);
    if (largest(rgb) < kDarkest) return make_constant(luminance(rgb));
    return std::make_shared<SigmoidSpectrum>(sigmoid_coefficients(rgb));
}

SpectrumPtr make_emission(Colour<LinearSrgb> rgb) {
    for (double& channel : rgb.v) {
        DEWBOW_CHECK(std::isfinite(channel), "the colour of a light is finite");
        channel = std::max(channel, 0.0);
    }
    if (largest(rgb) == 0.0) return make_constant(0.0);
    const SpectrumPtr d65 = find_illuminant("D65");
    if (is_grey(rgb)) return make_scaled(d65, rgb[0]);
    // Half as bright as a reflectance could be: the spectrum is smoother, and pure primaries are
    // exact.
    const SpectrumPtr reflectance = make_reflectance(rgb * (0.5 / largest(rgb)));
    const SpectrumPtr relative = make_table_from(*reflectance, [&](double lambda_nm, double value) {
        return value * (*d65)(lambda_nm * unit::nm);
    });
    return make_scaled(relative,
                       luminance(rgb) * cie_y_integral() / xyz_from_spectrum(*relative)[1]);
}

SpectrumPtr make_absorption(Colour<LinearSrgb> transmittance, Length depth) {
    const double depth_m = depth.to(unit::m);
    if (!(depth_m > 0.0)) throw InputError("the depth of an absorption colour must be positive");
    const auto absorption = [depth_m](double t) {
        return -std::log(std::clamp(t, kLeastTransmittance, 1.0)) / depth_m + 0.0;
    };
    const SpectrumPtr reflectance = make_reflectance(transmittance);
    if (reflectance->is_constant()) return make_constant(absorption(reflectance->max_value()));
    return make_table_from(*reflectance, [&](double, double value) { return absorption(value); });
}

}  // namespace dewbow
