// SPDX-License-Identifier: Apache-2.0

// An index that is known at some wavelengths.

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"

namespace dewbow::dispersion {
namespace {

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

void check_wavelengths(const DispersionData& data) {
    const Coefficients& c = data.coefficients;
    if (c.size() % 2 != 0)
        throw InputError(fmt::format("{}: {} numbers; expected pairs of wavelength and index",
                                     data.form, c.size()));
    for (std::size_t i = 0; i < c.size(); i += 2) {
        if (!(c[i] > 0.0))
            throw InputError(
                fmt::format("{}: wavelength {} µm; expected a positive number", data.form, c[i]));
        if (i > 0 && !(c[i - 2] < c[i]))
            throw InputError(
                fmt::format("{}: {} µm stands before {} µm; expected rising wavelengths", data.form,
                            c[i - 2], c[i]));
    }
}

}  // namespace

DispersionPtr make_table(const DispersionData& data) {
    check_wavelengths(data);
    const Coefficients& c = data.coefficients;
    Table table;
    for (std::size_t i = c.size(); i > 0; i -= 2) {  // from the longest wavelength: w rises
        table.w.push_back(1.0 / (c[i - 2] * c[i - 2]));
        table.n_at.push_back(c[i - 1]);
    }
    table.slope = monotone_slopes(table.w, table.n_at);
    return checked(data.form, table, {1e3 * c.front(), 1e3 * c[c.size() - 2]});
}

}  // namespace dewbow::dispersion
