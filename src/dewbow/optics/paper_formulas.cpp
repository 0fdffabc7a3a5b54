// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/paper_formulas.h"

#include <algorithm>
#include <cmath>

#include "dewbow/math/least_squares.h"
#include "dewbow/optics/paper_index.h"

namespace dewbow {
namespace {

/// Of λ in µm, in air.
using Term = std::function<double(double l)>;
using Basis = std::vector<Term>;
using Samples = std::span<const IndexSample>;

double um(const IndexSample& sample) { return 1e-3 * sample.air_nm; }
double middle_of(Samples samples) { return 0.5 * (um(samples.front()) + um(samples.back())); }

IndexInAir index_of(auto formula) {
    return [formula](double air_nm) { return formula(1e-3 * air_nm); };
}

double value_of(const Basis& basis, const std::vector<double>& c, double l) {
    double sum = 0.0;
    for (std::size_t k = 0; k < basis.size(); ++k) sum += c[k] * basis[k](l);
    return sum;
}

/// The coefficients of `basis` for `of(sample)`, each sample weighing `weight(sample)`.
std::vector<double> fit_basis(const Basis& basis, Samples samples, auto of, auto weight) {
    std::vector<double> a, b;
    for (const Term& term : basis)
        for (const IndexSample& s : samples) a.push_back(weight(s) * term(um(s)));
    for (const IndexSample& s : samples) b.push_back(weight(s) * of(s));
    return least_squares(a, b);
}

/// What is left: Σ (n_fit − n)².
double squares(const FittedFormula& fit, Samples samples) {
    double sum = 0.0;
    for (const IndexSample& s : samples) {
        const double error = fit.index(s.air_nm) - s.n;
        sum += error * error;
    }
    return sum;
}

// ---- sums of terms: n = Σ c t(λ) ----

FittedFormula fit_sum(const Basis& basis, Samples samples) {
    FittedFormula fit;
    fit.constants = fit_basis(
        basis, samples, [](const IndexSample& s) { return s.n; },
        [](const IndexSample&) { return 1.0; });
    fit.index = index_of([basis, c = fit.constants](double l) { return value_of(basis, c, l); });
    return fit;
}

double one(double) { return 1.0; }
double square(double l) { return l * l; }
double inverse(double l) { return 1.0 / l; }
double inverse_square(double l) { return 1.0 / (l * l); }
double inverse_fourth(double l) { return 1.0 / (l * l * l * l); }
double conradys_power(double l) { return std::pow(l, -3.5); }
double herzberger_in_um(double l) { return 1.0 / (l * l - 0.028); }
double herzberger_in_nm(double l) { return 1.0 / (1e6 * l * l - 0.028); }
double square_in_nm(double l) { return 1e6 * l * l; }
double coordinate(double l) {
    return paper_coordinate(vacuum_wavelength(1e3 * l), SpectralSpacing::frequency);
}

FittedFormula fit_cauchy_2(Samples samples) { return fit_sum({one, inverse_square}, samples); }
FittedFormula fit_cauchy_3(Samples samples) {
    return fit_sum({one, inverse_square, inverse_fourth}, samples);
}
FittedFormula fit_conrady_printed(Samples samples) {
    return fit_sum({one, inverse, inverse_square}, samples);
}
FittedFormula fit_conrady(Samples samples) {
    return fit_sum({one, inverse, conradys_power}, samples);
}
FittedFormula fit_herzberger(Samples samples) {
    const auto L = herzberger_in_um;
    return fit_sum({one, square, L, [L](double l) { return L(l) * L(l); }}, samples);
}
FittedFormula fit_herzberger_printed(Samples samples) {
    const auto L = herzberger_in_nm;
    return fit_sum({one, square_in_nm, L, [L](double l) { return L(l) * L(l); }}, samples);
}
FittedFormula fit_line(Samples samples) { return fit_sum({one, coordinate}, samples); }

// ---- Hartmann: n = n0 + B u^−p with u = 1 + t (λ − λ_m), t = 1/(λ_m − c) ----

constexpr double kHartmannPower = 1.2;
/// How near c comes to the shortest wavelength, as a share of its distance from the middle.
constexpr double kNearestPole = 1e-3;

FittedFormula hartmann_printed_with(double t, Samples samples) {
    const double middle = middle_of(samples);
    const auto term = [=](double l) { return 1.0 / (1.0 + t * (l - middle)); };
    const double B = fit_basis(
        {term}, samples, [](const IndexSample& s) { return s.n - 1.0; },
        [](const IndexSample&) { return 1.0; })[0];
    return {{-B / t, middle - 1.0 / t}, index_of([=](double l) { return 1.0 + B * term(l); })};
}

FittedFormula hartmann_with(double t, Samples samples) {
    const double middle = middle_of(samples);
    const auto term = [=](double l) { return std::pow(1.0 + t * (l - middle), -kHartmannPower); };
    FittedFormula fit = fit_sum({one, term}, samples);
    fit.constants = {fit.constants[0], fit.constants[1] * std::pow(t, -kHartmannPower),
                     middle - 1.0 / t};
    return fit;
}

FittedFormula search_hartmann(FittedFormula (*with)(double, Samples), Samples samples) {
    const double most = (1.0 - kNearestPole) / (middle_of(samples) - um(samples.front()));
    return with(find_minimum([&](double t) { return squares(with(t, samples), samples); },
                             1e-6 * most, most),
                samples);
}
FittedFormula fit_hartmann_printed(Samples samples) {
    return search_hartmann(hartmann_printed_with, samples);
}
FittedFormula fit_hartmann(Samples samples) { return search_hartmann(hartmann_with, samples); }

// ---- Sellmeier: n² = 1 + b λ²/(λ² − C), C = c² ----

/// n² = 1 + Σ c t(λ).
FittedFormula fit_square(const Basis& basis, Samples samples) {
    FittedFormula fit;
    fit.constants = fit_basis(
        basis, samples, [](const IndexSample& s) { return s.n * s.n - 1.0; },
        [](const IndexSample& s) { return 0.5 / s.n; });
    fit.index = index_of([basis, c = fit.constants](double l) {
        return std::sqrt(std::max(0.0, 1.0 + value_of(basis, c, l)));
    });
    return fit;
}

/// With a band at c² = C, and perhaps others.
FittedFormula sellmeier_with(double C, Basis others, Samples samples) {
    others.insert(others.begin(), [C](double l) { return l * l / (l * l - C); });
    FittedFormula fit = fit_square(others, samples);
    fit.constants.insert(fit.constants.begin() + 1, std::sqrt(C));
    return fit;
}

/// How near a band comes to the ends of the samples, as a share of λ².
constexpr double kNearestBand = 0.99;

FittedFormula search_sellmeier(const Basis& others, Samples samples) {
    const auto left = [&](double C) {
        return squares(sellmeier_with(C, others, samples), samples);
    };
    const double C = find_minimum(left, 0.0, kNearestBand * square(um(samples.front())));
    return sellmeier_with(C, others, samples);
}
FittedFormula fit_sellmeier(Samples samples) { return search_sellmeier({}, samples); }
FittedFormula fit_sellmeier_infrared(Samples samples) {
    return search_sellmeier({[](double l) { return -l * l; }}, samples);
}

/// As printed, c² − λ² below and b > 0: only bands beyond the red make n² > 1.
FittedFormula fit_sellmeier_printed(Samples samples) {
    const double most = kNearestBand / square(um(samples.back()));
    const auto with = [&](double u) { return sellmeier_with(1.0 / u, {}, samples); };
    const auto left = [&](double u) { return squares(with(u), samples); };
    FittedFormula fit = with(find_minimum(left, 1e-6 * most, most));
    fit.constants[0] = -fit.constants[0];
    return fit;
}

}  // namespace

const std::vector<PaperFormula>& paper_formulas() {
    static const std::vector<PaperFormula> formulas{
        {"Sellmeier", true, false, "n² = 1 + b λ²/(c² − λ²), b > 0", "b, c", fit_sellmeier_printed},
        {"Sellmeier", false, true, "n² = 1 + b λ²/(λ² − c²)", "b, c", fit_sellmeier},
        {"Sellmeier", false, true, "n² = 1 + b λ²/(λ² − c²) − d λ²", "b, c, d",
         fit_sellmeier_infrared},
        {"Cauchy", true, true, "n = a + b/λ²", "a, b", fit_cauchy_2},
        {"Cauchy", true, true, "n = a + b/λ² + c/λ⁴", "a, b, c", fit_cauchy_3},
        {"Hartmann", true, false, "n = 1 + b/(c − λ)", "b, c", fit_hartmann_printed},
        {"Hartmann", false, true, "n = n0 + b/(λ − c)^1.2", "n0, b, c", fit_hartmann},
        {"Conrady", true, false, "n = a + b/λ + c/λ²", "a, b, c", fit_conrady_printed},
        {"Conrady", false, true, "n = a + b/λ + c/λ^3.5", "a, b, c", fit_conrady},
        {"Herzberger", true, false, "n = a + bλ² + cL + dL², L = 1/(λ² − 0.028), λ in nm",
         "a, b, c, d", fit_herzberger_printed},
        {"Herzberger", false, true, "n = a + bλ² + cL + dL², L = 1/(λ² − 0.028), λ in µm",
         "a, b, c, d", fit_herzberger},
        {"a straight line", true, true, "n = a + b f", "a, b", fit_line},
    };
    return formulas;
}

std::vector<IndexSample> index_samples(const IndexInAir& n, SpectralBand band) {
    std::vector<IndexSample> samples;
    for (double nm = band.from_nm; nm <= band.to_nm; nm += 1.0) samples.push_back({nm, n(nm)});
    return samples;
}

IndexError index_error(const FittedFormula& fit, std::span<const IndexSample> samples) {
    IndexError error;
    for (const IndexSample& s : samples)
        error.worst = std::max(error.worst, std::abs(fit.index(s.air_nm) - s.n));
    error.rms = std::sqrt(squares(fit, samples) / double(samples.size()));
    return error;
}

}  // namespace dewbow
