// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/dispersion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using Coefficients = std::vector<double>;

// ---- one formula, many wavelengths ----
//
// A formula is a struct with
//     template <class V> V index(V lambda_um) const;
// that is written once for V = double and for V = Pair, two lanes in one register. (Loops over
// short arrays do not do it: g++ 12 unrolls them and then vectorises the sum over the terms, which
// was half as fast as scalar code.) A lane has the same operations in both, so that one alone has
// the same bits as among many.

using Pair = double __attribute__((vector_size(16)));

double each_lane(double v, auto function) { return function(v); }
Pair each_lane(Pair v, auto function) { return Pair{function(v[0]), function(v[1])}; }

template <class V>
V square_root(V v) {
    return each_lane(v, [](double x) { return std::sqrt(x); });
}

/// At least 1; a NaN (the root of a negative n²) becomes 1 as well.
template <class V>
V held(V n) {
    return n > 1.0 ? n : V{} + 1.0;
}

/// n_out[i] = function(lambda_nm[i]), two at a time.
void for_lanes(std::span<const double> lambda_nm, std::span<double> n_out, auto function) {
    DEWBOW_CHECK(n_out.size() == lambda_nm.size(), "one index for each wavelength");
    const std::size_t count = lambda_nm.size();
    std::size_t i = 0;
    for (; i + 2 <= count; i += 2) {
        const Pair n = function(Pair{lambda_nm[i], lambda_nm[i + 1]});
        n_out[i] = n[0];
        n_out[i + 1] = n[1];
    }
    if (i < count) n_out[i] = function(lambda_nm[i]);
}

template <class Formula>
class FormulaDispersion final : public Dispersion {
public:
    explicit FormulaDispersion(const Formula& formula) : formula_(formula) {}

    /// What the formula gives, below 1 or not a number though it be.
    template <class V>
    V unheld(V lambda_nm) const {
        return formula_.index(1e-3 * lambda_nm);
    }

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const override {
        for_lanes(lambda_nm, n_out, [this](auto lambda) { return held(unheld(lambda)); });
    }
    bool is_constant() const override { return formula_.is_constant(); }

protected:
    double eval(double lambda_nm) const override { return held(unheld(lambda_nm)); }

private:
    Formula formula_;
};

// ---- checks ----

constexpr double kCheckedFrom_nm = 360.0, kCheckedTo_nm = 830.0;
constexpr double kLeastIndex = 1.0, kMostIndex = 10.0;

/// The dispersion of `formula`, which must lie within 1 to 10 at every whole nanometre that is
/// seen.
template <class Formula>
DispersionPtr checked(const char* form, const Formula& formula) {
    auto dispersion = std::make_shared<const FormulaDispersion<Formula>>(formula);
    for (double lambda_nm = kCheckedFrom_nm; lambda_nm <= kCheckedTo_nm; lambda_nm += 1.0) {
        const double n = dispersion->unheld(lambda_nm);
        if (n >= kLeastIndex && n <= kMostIndex) continue;
        throw InputError(
            fmt::format("{}: the index of refraction at {} nm is {:.6g}; expected {} to {}", form,
                        lambda_nm, n, kLeastIndex, kMostIndex));
    }
    return dispersion;
}

// ---- the formulas; x = λ², λ in µm ----

struct Constant {
    double n = 1.0;
    template <class V>
    V index(V) const {
        return V{} + n;
    }
    bool is_constant() const { return true; }
};

DispersionPtr make_constant(const Coefficients& c) { return checked("constant", Constant{c[0]}); }

constexpr int kMostTerms = 8;  // halite has seven, the most of any material that is in common use

/// n² = 1 + Σ B x / (x − C).                                                        [Sellmeier
/// 1871] A term with C = 0 is the constant that some tables begin with.
struct Sellmeier {
    std::array<double, kMostTerms> B{}, C{};
    int terms = 0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        V n2 = V{} + 1.0;
        for (int t = 0; t < terms; ++t) n2 += B[t] * x / (x - C[t]);
        return square_root(n2);
    }
    bool is_constant() const { return false; }
};

/// A resonance among the wavelengths that are seen could lie between two that are checked.
void refuse_visible_resonance(double C) {
    const double lambda_nm = C > 0.0 ? 1e3 * std::sqrt(C) : 0.0;
    if (lambda_nm < kCheckedFrom_nm || lambda_nm > kCheckedTo_nm) return;
    throw InputError(
        fmt::format("sellmeier: C = {} µm² puts a resonance at {:.1f} nm; expected none in "
                    "{} to {} nm",
                    C, lambda_nm, kCheckedFrom_nm, kCheckedTo_nm));
}

DispersionPtr make_sellmeier(const Coefficients& c) {
    if (c.size() % 2 != 0)
        throw InputError(fmt::format("sellmeier: {} coefficients; expected pairs B, C", c.size()));
    Sellmeier formula;
    for (std::size_t i = 0; i < c.size(); i += 2) {
        if (c[i] != 0.0) refuse_visible_resonance(c[i + 1]);
        formula.B[formula.terms] = c[i];
        formula.C[formula.terms++] = c[i + 1];
    }
    return checked("sellmeier", formula);
}

constexpr int kMostCauchy = 6;

/// n = A + B / x + C / x² + …                                                          [Cauchy
/// 1836]
struct Cauchy {
    std::array<double, kMostCauchy> c{};

    template <class V>
    V index(V lambda_um) const {
        const V inverse_x = 1.0 / (lambda_um * lambda_um);
        V n = V{} + c[kMostCauchy - 1];
        for (int t = kMostCauchy - 2; t >= 0; --t) n = n * inverse_x + c[t];
        return n;
    }
    bool is_constant() const {
        return std::all_of(c.begin() + 1, c.end(), [](double v) { return v == 0.0; });
    }
};

DispersionPtr make_cauchy(const Coefficients& c) {
    Cauchy formula;
    std::copy(c.begin(), c.end(), formula.c.begin());
    return checked("cauchy", formula);
}

double inverse_square_um(Wavelength lambda) {
    const double lambda_um = 1e-3 * lambda.to(unit::nm);
    return 1.0 / (lambda_um * lambda_um);
}

/// n = A + B / x through n_d with the Abbe number V_d: from V_d = (n_d − 1) / (n_F − n_C),
///     B = (n_d − 1) / (V_d (1/x_F − 1/x_C)),   A = n_d − B / x_d. [KHR_materials_dispersion]
/// The extension prints it as n_d + (n_d − 1) / V_d · (523655 / λ² − 1.5168), with these lines.
DispersionPtr make_abbe(const Coefficients& c) {
    const double n_d = c[0], V_d = c[1];
    if (!(n_d >= kLeastIndex && n_d <= kMostIndex))
        throw InputError(
            fmt::format("abbe: n_d is {}; expected {} to {}", n_d, kLeastIndex, kMostIndex));
    if (!(V_d > 0.0))
        throw InputError(fmt::format("abbe: V_d is {}; expected a positive number", V_d),
                         "for no dispersion use the form constant");
    Cauchy formula;
    formula.c[1] = (n_d - 1.0) / (V_d * (inverse_square_um(kLineF) - inverse_square_um(kLineC)));
    formula.c[0] = n_d - formula.c[1] * inverse_square_um(kLined);
    // An extreme V_d falls below 1 in the red; the extension holds it there, and so does eval.
    return std::make_shared<const FormulaDispersion<Cauchy>>(formula);
}

constexpr int kMostPowers = 9;

/// n² = Σ c x^power, power = −(kMostPowers − 3) … 2, by Horner's rule on both sides.
struct PowerSeries {
    std::array<double, 3> rising{};                 ///< of 1, x, x²
    std::array<double, kMostPowers - 3> falling{};  ///< of 1/x, 1/x², …

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um, inverse_x = 1.0 / x;
        V sum{};
        for (int t = static_cast<int>(falling.size()) - 1; t >= 0; --t)
            sum = (sum + falling[t]) * inverse_x;
        return square_root(sum + (rising[0] + x * (rising[1] + x * rising[2])));
    }
    bool is_constant() const { return false; }
};

/// n² = a0 + a1 x + a2/x + a3/x² + a4/x³ + a5/x⁴ …       [Schott 1966; AGF formulas 1 and 10]
DispersionPtr make_schott(const Coefficients& c) {
    PowerSeries formula;
    std::copy(c.begin(), c.begin() + 2, formula.rising.begin());
    std::copy(c.begin() + 2, c.end(), formula.falling.begin());
    return checked("schott", formula);
}

/// n² = a0 + a1 x + a2 x² + a3/x + a4/x² + … + a8/x⁶.                            [AGF formula 13]
DispersionPtr make_extended_3(const Coefficients& c) {
    PowerSeries formula;
    std::copy(c.begin(), c.begin() + 3, formula.rising.begin());
    std::copy(c.begin() + 3, c.end(), formula.falling.begin());
    return checked("extended_3", formula);
}

/// n = A + B L + C L² + D x + E x² + F x³, L = 1 / (x − 0.028 µm²).     [Herzberger 1959; AGF
/// formula 3]
struct Herzberger {
    std::array<double, 6> c{};

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um, L = 1.0 / (x - 0.028);
        return c[0] + L * (c[1] + L * c[2]) + x * (c[3] + x * (c[4] + x * c[5]));
    }
    bool is_constant() const { return false; }
};

DispersionPtr make_herzberger(const Coefficients& c) {
    Herzberger formula;
    std::copy(c.begin(), c.end(), formula.c.begin());
    return checked("herzberger", formula);
}

/// n = n0 + A / λ + B / λ^3.5.                                          [Conrady 1929; AGF formula
/// 5]
struct Conrady {
    double n0 = 0.0, A = 0.0, B = 0.0;

    template <class V>
    V index(V l) const {
        return n0 + A / l + B / (l * l * l * square_root(l));
    }
    bool is_constant() const { return false; }
};

DispersionPtr make_conrady(const Coefficients& c) {
    return checked("conrady", Conrady{c[0], c[1], c[2]});
}

/// n² = A + B / (x − C) − D x.                              [Handbook of Optics 1; AGF formula 7]
struct Handbook1 {
    double A = 0.0, B = 0.0, C = 0.0, D = 0.0;

    template <class V>
    V index(V lambda_um) const {
        const V x = lambda_um * lambda_um;
        return square_root(A + B / (x - C) - D * x);
    }
    bool is_constant() const { return false; }
};

DispersionPtr make_handbook_1(const Coefficients& c) {
    return checked("handbook_1", Handbook1{c[0], c[1], c[2], c[3]});
}

constexpr int kMostGasTerms = 5;

/// n − 1 = Σ B / (C − 1/x).                       [Ciddor 1996, eq. 1; refractiveindex.info formula
/// 6]
struct Gas {
    std::array<double, kMostGasTerms> B{}, C{};
    int terms = 0;

    template <class V>
    V index(V lambda_um) const {
        const V inverse_x = 1.0 / (lambda_um * lambda_um);
        V sum{};
        for (int t = 0; t < terms; ++t) sum += B[t] / (C[t] - inverse_x);
        return 1.0 + sum;
    }
    bool is_constant() const { return false; }
};

DispersionPtr make_gas(const Coefficients& c) {
    if (c.size() % 2 != 0)
        throw InputError(fmt::format("gas: {} coefficients; expected pairs B, C", c.size()));
    Gas formula;
    for (std::size_t i = 0; i < c.size(); i += 2) {
        formula.B[formula.terms] = c[i];
        formula.C[formula.terms++] = c[i + 1];
    }
    return checked("gas", formula);
}

// ---- tables ----

/// Monotone cubic Hermite interpolation of n in w = 1/λ², where an index is nearly a straight line
/// (Cauchy's first two terms), so that a table needs few rows: see kTableError in the test.
///
/// Slopes are those of the quartic through five neighbours, limited to three times the smaller
/// secant beside them and to 0 at an extremum: nothing overshoots.   [Fritsch & Carlson 1980; Hyman
/// 1983]
///
/// Beyond its ends the table goes on along its last tangent.
struct Table {
    std::vector<double> w, n_at, slope;  ///< w falls as λ grows; kept with w rising

    double at(double w_wanted) const {
        const std::size_t last = w.size() - 1;
        if (w_wanted <= w[0]) return n_at[0] + slope[0] * (w_wanted - w[0]);
        if (w_wanted >= w[last]) return n_at[last] + slope[last] * (w_wanted - w[last]);
        const auto above = std::upper_bound(w.begin(), w.end(), w_wanted);
        const std::size_t i = static_cast<std::size_t>(above - w.begin()) - 1;
        const double h = w[i + 1] - w[i];
        const double t = (w_wanted - w[i]) / h, u = 1.0 - t;
        // n_i + (n_{i+1} − n_i) t²(3 − 2t) + h t u (m_i u − m_{i+1} t): the cubic that meets both
        // ends.
        return n_at[i] + (n_at[i + 1] - n_at[i]) * (t * t * (3.0 - 2.0 * t)) +
               h * t * u * (slope[i] * u - slope[i + 1] * t);
    }

    template <class V>
    V index(V lambda_um) const {
        return each_lane(1.0 / (lambda_um * lambda_um), [this](double w_at) { return at(w_at); });
    }
    bool is_constant() const {
        return std::all_of(n_at.begin(), n_at.end(), [&](double v) { return v == n_at[0]; });
    }
};

/// Derivative at w[i] of the polynomial through the rows first … first + count − 1, i among them,
/// by barycentric weights v: p'(w_i) = Σ_j (v_j / v_i) (n_j − n_i) / (w_i − w_j).
///                                                                    [Berrut & Trefethen 2004,
///                                                                    §9.3]
double polynomial_slope(const std::vector<double>& w, const std::vector<double>& n,
                        std::size_t first, std::size_t count, std::size_t i) {
    const auto inverse_weight = [&](std::size_t j) {
        double product = 1.0;
        for (std::size_t k = first; k < first + count; ++k)
            if (k != j) product *= w[j] - w[k];
        return product;
    };
    double slope = 0.0;
    for (std::size_t j = first; j < first + count; ++j)
        if (j != i) slope += inverse_weight(i) / inverse_weight(j) * (n[j] - n[i]) / (w[i] - w[j]);
    return slope;
}

/// `slope`, if it has the sign of the secants on both sides, and not above three times the smaller:
/// a cubic between such slopes is monotone.                                   [Fritsch & Carlson
/// 1980]
double limited_slope(double slope, double secant_before, double secant_after) {
    if (secant_before * secant_after <= 0.0 || slope * secant_before <= 0.0) return 0.0;
    const double most = 3.0 * std::min(std::abs(secant_before), std::abs(secant_after));
    return std::clamp(slope, -most, most);
}

std::vector<double> monotone_slopes(const std::vector<double>& w, const std::vector<double>& n) {
    constexpr std::size_t kThrough = 5;  // rows that a slope is taken from: fourth order
    const std::size_t rows = w.size(), through = std::min(kThrough, rows);
    const auto secant = [&](std::size_t i) { return (n[i + 1] - n[i]) / (w[i + 1] - w[i]); };
    std::vector<double> slope(rows);
    for (std::size_t i = 0; i < rows; ++i) {
        const std::size_t first = std::min(i - std::min(i, through / 2), rows - through);
        slope[i] = limited_slope(polynomial_slope(w, n, first, through, i),
                                 secant(i > 0 ? i - 1 : 0), secant(std::min(i, rows - 2)));
    }
    return slope;
}

DispersionPtr make_table(const Coefficients& c) {
    if (c.size() % 2 != 0)
        throw InputError(
            fmt::format("table: {} numbers; expected pairs of wavelength and index", c.size()));
    Table table;
    for (std::size_t i = c.size(); i > 0; i -= 2) {  // from the longest wavelength: w rises
        const double lambda_um = c[i - 2];
        if (!(lambda_um > 0.0))
            throw InputError(
                fmt::format("table: wavelength {} µm; expected a positive number", lambda_um));
        if (i < c.size() && !(lambda_um < c[i]))
            throw InputError(fmt::format(
                "table: {} µm stands before {} µm; expected rising wavelengths", lambda_um, c[i]));
        table.w.push_back(1.0 / (lambda_um * lambda_um));
        table.n_at.push_back(c[i - 1]);
    }
    table.slope = monotone_slopes(table.w, table.n_at);
    return checked("table", table);
}

// ---- against air ----

/// An index that was measured against air, times that of air.
class AgainstAir final : public Dispersion {
public:
    explicit AgainstAir(DispersionPtr relative) : relative_(std::move(relative)), air_(air()) {}

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const override {
        relative_->eval_lanes(lambda_nm, n_out);
        constexpr std::size_t kBlock = 16;
        std::array<double, kBlock> n_air;
        for (std::size_t first = 0; first < lambda_nm.size(); first += kBlock) {
            const std::size_t count = std::min(kBlock, lambda_nm.size() - first);
            air_->eval_lanes(lambda_nm.subspan(first, count), {n_air.data(), count});
            for (std::size_t i = 0; i < count; ++i) n_out[first + i] *= n_air[i];
        }
    }

protected:
    double eval(double lambda_nm) const override {
        const Wavelength lambda = lambda_nm * unit::nm;
        return (*relative_)(lambda).value * (*air_)(lambda).value;
    }

private:
    DispersionPtr relative_, air_;
};

DispersionPtr against_air(DispersionPtr relative) {
    if (!relative->is_constant()) return std::make_shared<const AgainstAir>(std::move(relative));
    return std::make_shared<const FormulaDispersion<Constant>>(
        Constant{(*relative)(kLined).value * (*air())(kLined).value});
}

// ---- the registry ----

constexpr int kAnyNumber = std::numeric_limits<int>::max();

std::vector<DispersionForm> make_forms() {
    return {
        {"constant", "n", "", 1, 1, make_constant},
        {"sellmeier",
         "n² = 1 + B1 λ²/(λ² − C1) + B2 λ²/(λ² − C2) + …  (B1, C1, B2, C2, …; C in µm²)",
         "Sellmeier 1871; AGF formulas 2, 6 and 11", 2, 2 * kMostTerms, make_sellmeier},
        {"cauchy", "n = A + B/λ² + C/λ⁴ + …  (A, B, C, …)", "Cauchy 1836", 1, kMostCauchy,
         make_cauchy},
        {"abbe", "n = A + B/λ² with the given n_d and Abbe number V_d  (n_d, V_d)",
         "glTF KHR_materials_dispersion", 2, 2, make_abbe},
        {"table", "monotone cubic in 1/λ²  (λ1, n1, λ2, n2, …; λ in µm, rising)",
         "Fritsch & Carlson 1980", 4, kAnyNumber, make_table},
        {"schott", "n² = a0 + a1 λ² + a2/λ² + a3/λ⁴ + a4/λ⁶ + …  (a0, a1, …)",
         "Schott 1966; AGF formulas 1 and 10", 3, 8, make_schott},
        {"extended_3", "n² = a0 + a1 λ² + a2 λ⁴ + a3/λ² + a4/λ⁴ + …  (a0, a1, …)", "AGF formula 13",
         4, kMostPowers, make_extended_3},
        {"herzberger", "n = A + B L + C L² + D λ² + E λ⁴ + F λ⁶, L = 1/(λ² − 0.028)  (A, B, …)",
         "Herzberger 1959; AGF formula 3", 3, 6, make_herzberger},
        {"conrady", "n = n0 + A/λ + B/λ^3.5  (n0, A, B)", "Conrady 1929; AGF formula 5", 3, 3,
         make_conrady},
        {"handbook_1", "n² = A + B/(λ² − C) − D λ²  (A, B, C, D)",
         "Handbook of Optics; AGF formula 7", 4, 4, make_handbook_1},
        {"gas", "n = 1 + B1/(C1 − 1/λ²) + B2/(C2 − 1/λ²) + …  (B1, C1, B2, C2, …; in 1/µm²)",
         "Ciddor 1996; refractiveindex.info formula 6", 2, 2 * kMostGasTerms, make_gas},
    };
}

const DispersionForm& form_named(const std::string& name) {
    for (const DispersionForm& form : dispersion_forms())
        if (form.name == name) return form;
    std::vector<std::string> names;
    for (const DispersionForm& form : dispersion_forms()) names.push_back(form.name);
    throw InputError(fmt::format("unknown dispersion formula \"{}\"", name), hint_for(name, names));
}

std::string expected_count(const DispersionForm& form) {
    if (form.least_coefficients == form.most_coefficients)
        return fmt::format("{}", form.least_coefficients);
    if (form.most_coefficients == kAnyNumber)
        return fmt::format("at least {}", form.least_coefficients);
    return fmt::format("{} to {}", form.least_coefficients, form.most_coefficients);
}

void check_coefficients(const DispersionForm& form, const Coefficients& coefficients) {
    const std::size_t count = coefficients.size();
    if (count < static_cast<std::size_t>(form.least_coefficients) ||
        count > static_cast<std::size_t>(form.most_coefficients))
        throw InputError(
            fmt::format("{}: {} coefficients; expected {}", form.name, count, expected_count(form)),
            form.formula);
    for (const double c : coefficients)
        if (!std::isfinite(c))
            throw InputError(
                fmt::format("{}: coefficient {}; expected a finite number", form.name, c));
}

// Ciddor's dispersion of standard air (15 °C, 101325 Pa, dry, 450 ppm CO2), in µm⁻²  [Ciddor 1996,
// eq. 1]
constexpr double kCiddorB1 = 0.05792105, kCiddorC1 = 238.0185;
constexpr double kCiddorB2 = 0.00167917, kCiddorC2 = 57.362;

/// Compressibility of dry air, Z = pV/(nRT).                              [Ciddor 1996, appendix A,
/// x_w = 0]
constexpr double compressibility(double temperature_K, double pressure_Pa) {
    const double t = temperature_K - 273.15, p_T = pressure_Pa / temperature_K;
    return 1.0 - p_T * (1.58123e-6 - 2.9331e-8 * t + 1.1043e-10 * t * t) + 1.83e-11 * p_T * p_T;
}

/// Density at 20 °C over that at 15 °C, ρ ∝ p / (Z T); n − 1 goes with it.        [Ciddor 1996, eq.
/// 5]
constexpr double kDensityRatio =
    288.15 * compressibility(288.15, 101325.0) / (293.15 * compressibility(293.15, 101325.0));

}  // namespace

void Dispersion::eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const {
    DEWBOW_CHECK(n_out.size() == lambda_nm.size(), "one index for each wavelength");
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) n_out[i] = eval(lambda_nm[i]);
}

const std::vector<DispersionForm>& dispersion_forms() {
    static const std::vector<DispersionForm> forms = make_forms();
    return forms;
}

DispersionPtr make_dispersion(const DispersionData& data) {
    const DispersionForm& form = form_named(data.form);
    check_coefficients(form, data.coefficients);
    DispersionPtr dispersion = form.make(data.coefficients);
    return data.reference == IndexReference::air ? against_air(std::move(dispersion)) : dispersion;
}

DispersionPtr air() {
    static const DispersionPtr standard =
        make_gas({kDensityRatio * kCiddorB1, kCiddorC1, kDensityRatio * kCiddorB2, kCiddorC2});
    return standard;
}

DispersionPtr vacuum() {
    static const DispersionPtr nothing = make_constant({1.0});
    return nothing;
}

double abbe_number(const Dispersion& dispersion, const Dispersion& medium) {
    const auto relative = [&](Wavelength lambda) {
        return dispersion(lambda).value / medium(lambda).value;
    };
    const double spread = relative(kLineF) - relative(kLineC);
    if (spread == 0.0) return std::numeric_limits<double>::infinity();
    return (relative(kLined) - 1.0) / spread;
}

}  // namespace dewbow
