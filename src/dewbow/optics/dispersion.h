// SPDX-License-Identifier: Apache-2.0
#pragma once

// How the index of refraction depends on wavelength: one interface, and one row of
// dispersion_forms() for each formula.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

class Dispersion {
public:
    virtual ~Dispersion() = default;
    /// Index against vacuum. Outside the range for which the data are valid the formula is
    /// continued; a value below 1 that a formula gives there is held at 1.
    AbsoluteIndex operator()(Wavelength lambda) const { return {eval(lambda.to(unit::nm))}; }
    /// The same for many wavelengths, bit for bit: the form that render loops use. `n_out` has the
    /// size of `lambda_nm` and does not overlap it.
    virtual void eval_lanes(std::span<const double> lambda_nm, std::span<double> n_out) const;
    /// True if the index is the same at every wavelength.
    virtual bool is_constant() const { return false; }

protected:
    virtual double eval(double lambda_nm) const = 0;
};
using DispersionPtr = std::shared_ptr<const Dispersion>;

/// Whether tabulated coefficients give the index against vacuum or against air at 20 °C, 101325 Pa,
/// as glass makers measure it.
enum class IndexReference { vacuum, air };

/// A formula with its coefficients, as catalogues and scene files give it.
struct DispersionData {
    std::string form;                  ///< a name of dispersion_forms()
    std::vector<double> coefficients;  ///< in the form's order; wavelengths in micrometres
    IndexReference reference = IndexReference::air;
};

struct DispersionForm {
    std::string name;
    std::string formula;  ///< as text, with the coefficients' order
    std::string source;
    int least_coefficients = 0, most_coefficients = 0;
    DispersionPtr (*make)(const std::vector<double>& coefficients);
};
/// constant (n) · sellmeier (B1, C1, B2, C2, …; C in µm²) · cauchy (A, B, C… in µm²ᵏ) · abbe (n_d,
/// V_d: glTF's) · table (λ1, n1, λ2, n2, …) · schott · extended_3 · herzberger · conrady ·
/// handbook_1 (these five as in AGF glass files) · gas (as in refractiveindex.info's formula 6).
const std::vector<DispersionForm>& dispersion_forms();

/// Builds the dispersion; an index against air is multiplied by that of air at each wavelength (a
/// form without dispersion by that at the d line, so that it stays constant). Throws InputError
/// (unknown form with the nearest name, wrong number of coefficients, not finite, an index below 1
/// or above 10 anywhere in 360–830 nm).
DispersionPtr make_dispersion(const DispersionData& data);

/// Dry air at 20 °C, 101325 Pa, 450 ppm CO2: what IndexReference::air means. [Ciddor 1996]
/// Error against NIST's table of Ciddor's equation: 1e-9.
DispersionPtr air();
DispersionPtr vacuum();

/// Fraunhofer lines in nm that the Abbe numbers are made of. These are the numbers that glass
/// makers state, wavelengths in air, and their formulas take such wavelengths; we give both our
/// vacuum wavelengths as they are. The difference of 0.028 % changes an index by less than 1.5e-4
/// in the catalogue (N-BK7 1.5e-5; rutile 6e-4): see WavelengthsInAirCostLittle.
inline constexpr Wavelength kLineF = 486.1327 * unit::nm;
inline constexpr Wavelength kLined = 587.5618 * unit::nm;
inline constexpr Wavelength kLineC = 656.2725 * unit::nm;

/// (n_d − 1) / (n_F − n_C) of `dispersion` against `medium`; infinite without dispersion.
double abbe_number(const Dispersion& dispersion, const Dispersion& medium);

}  // namespace dewbow
