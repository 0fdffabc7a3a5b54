// SPDX-License-Identifier: Apache-2.0
#pragma once

// A spectrum is a function of vacuum wavelength. What it is a function to (radiance, reflectance,
// an absorption coefficient) is said by whoever holds it.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// The visible range of this program: 360 to 830 nm, the whole table of the CIE 1931 observer.
inline constexpr double kLambdaMin_nm = 360.0;
inline constexpr double kLambdaMax_nm = 830.0;

class Spectrum {
public:
    virtual ~Spectrum() = default;

    /// Value at one wavelength.
    double operator()(Wavelength lambda) const { return eval(lambda.to(unit::nm)); }
    /// Value at each of `lambda_nm`, into `out` of the same length. The form that render loops use.
    virtual void eval_lanes(std::span<const double> lambda_nm, std::span<double> out) const;
    /// Largest value in the visible range, or a bound on it that is at most a few per cent above.
    virtual double max_value() const = 0;
    /// True if the value is the same at every wavelength.
    virtual bool is_constant() const { return false; }

protected:
    virtual double eval(double lambda_nm) const = 0;
};
using SpectrumPtr = std::shared_ptr<const Spectrum>;

SpectrumPtr make_constant(double value);

/// What a table says outside its first and last wavelength.
enum class OutsideTable { zero, hold };

/// Piecewise linear through (lambda_nm[i], values[i]); wavelengths strictly ascending, at least
/// one. Throws InputError otherwise.
SpectrumPtr make_tabulated(std::vector<double> lambda_nm, std::vector<double> values,
                           OutsideTable outside);

/// Emission lines, each a box `width` wide (default 1 nm) whose integral over wavelength is
/// `strength`.
struct Line {
    Wavelength centre;
    double strength = 0.0;
};
SpectrumPtr make_lines(std::vector<Line> lines, Wavelength width = 1.0 * unit::nm);

/// `factor * spectrum`, 0 <= factor.
SpectrumPtr make_scaled(SpectrumPtr spectrum, double factor);

}  // namespace dewbow
