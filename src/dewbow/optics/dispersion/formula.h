// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a formula to a Dispersion: one formula, many wavelengths.
//
// A formula is a struct with
//     template <class V> V index(V lambda_um) const;
//     bool is_constant() const;
// that is written once for V = double and for V = Pair, two lanes in one register. (Loops over
// short arrays do not do it: g++ 12 unrolls them and then vectorises the sum over the terms, which
// was half as fast as scalar code.) A lane has the same operations in both, so that one alone has
// the same bits as among many.

#include <cmath>

#include "dewbow/base/check.h"
#include "dewbow/optics/dispersion/continuation.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow::dispersion {

using Coefficients = std::vector<double>;
using Pair = double __attribute__((vector_size(16)));

double each_lane(double v, auto function) { return function(v); }
Pair each_lane(Pair v, auto function) { return Pair{function(v[0]), function(v[1])}; }

template <class V>
V square_root(V v) {
    return each_lane(v, [](double x) { return std::sqrt(x); });
}

template <class V>
V power(V v, double exponent) {
    return each_lane(v, [exponent](double x) { return std::pow(x, exponent); });
}

template <class Formula>
class FormulaDispersion final : public Dispersion {
public:
    FormulaDispersion(const Formula& formula, const Continuation& continuation)
        : formula_(formula), continuation_(continuation) {}

    void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const override {
        DEWBOW_CHECK(n_out.size() == lambda_nm.size(), "one index for each wavelength");
        std::size_t i = 0;
        for (; i + 2 <= lambda_nm.size(); i += 2) eval_two(&lambda_nm[i], &n_out[i]);
        if (i < lambda_nm.size()) n_out[i] = FormulaDispersion::eval(lambda_nm[i]);
    }
    bool is_constant() const override { return formula_.is_constant(); }

protected:
    double eval(double lambda_nm) const override {
        if (!continuation_.is_trusted(lambda_nm)) return continuation_.at(lambda_nm);
        return formula_.index(1e-3 * lambda_nm);
    }

private:
    void eval_two(const double* lambda_nm, double* n_out) const {
        if (continuation_.is_trusted(lambda_nm[0]) && continuation_.is_trusted(lambda_nm[1])) {
            const Pair n = formula_.index(1e-3 * Pair{lambda_nm[0], lambda_nm[1]});
            n_out[0] = n[0];
            n_out[1] = n[1];
        } else {
            n_out[0] = FormulaDispersion::eval(lambda_nm[0]);
            n_out[1] = FormulaDispersion::eval(lambda_nm[1]);
        }
    }

    Formula formula_;
    Continuation continuation_;
};

inline constexpr double kLeastIndex = 1.0, kMostIndex = 10.0;

/// The range that `data` state, or all that is seen. Throws InputError if it is none.
DataRange range_of(const DispersionData& data);

/// Coefficients 0 … count − 1; those that are missing at the end are 0.
Coefficients padded(const Coefficients& coefficients, std::size_t count);

[[noreturn]] void refuse_index(const std::string& form, double lambda_nm, double n);

/// Throws InputError if `index(nm)` is not within 1 to 10 at each whole nanometre that is seen and
/// lies in `range`.
template <class Index>
void check_index(const std::string& form, DataRange range, const Index& index) {
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; lambda_nm += 1.0) {
        if (lambda_nm < range.min_nm || lambda_nm > range.max_nm) continue;
        const double n = index(lambda_nm);
        if (n >= kLeastIndex && n <= kMostIndex) continue;
        refuse_index(form, lambda_nm, n);
    }
}

/// `range` without the ends at which the formula gives no index of a transparent medium, for the
/// continuation to start from.
template <class Index>
DataRange sound_range(DataRange range, const Index& index) {
    const auto is_sound = [&](double lambda_nm) {
        const double n = index(lambda_nm);
        return n >= kLeastIndex && n <= kMostIndex;
    };
    if (!is_sound(range.min_nm) && range.max_nm > kLambdaMin_nm && range.min_nm < kLambdaMin_nm)
        range.min_nm = kLambdaMin_nm;
    if (!is_sound(range.max_nm) && range.min_nm < kLambdaMax_nm && range.max_nm > kLambdaMax_nm)
        range.max_nm = kLambdaMax_nm;
    return range;
}

/// The dispersion of `formula`, whose data are of `range`. Throws InputError as make_dispersion.
template <class Formula>
DispersionPtr checked(const std::string& form, const Formula& formula, DataRange range) {
    const auto index = [&](double lambda_nm) { return formula.index(1e-3 * lambda_nm); };
    check_index(form, range, index);
    auto dispersion = std::make_shared<const FormulaDispersion<Formula>>(
        formula, Continuation(index, sound_range(range, index)));
    check_index(form, {kLambdaMin_nm, kLambdaMax_nm},
                [&](double lambda_nm) { return (*dispersion)(lambda_nm * unit::nm).value; });
    return dispersion;
}

template <class Formula>
DispersionPtr checked(const DispersionData& data, const Formula& formula) {
    return checked(data.form, formula, range_of(data));
}

}  // namespace dewbow::dispersion
