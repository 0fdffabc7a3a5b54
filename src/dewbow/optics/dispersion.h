// SPDX-License-Identifier: Apache-2.0
#pragma once

// How the index of refraction depends on wavelength: one interface, and one row of
// dispersion_forms() for each formula.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/optics/fraunhofer.h"
#include "dewbow/optics/refraction.h"

namespace dewbow {

class Dispersion {
public:
    virtual ~Dispersion() = default;
    /// Index against vacuum. Where a formula's data end and it goes wrong (a resonance, a value
    /// below 1), it goes on smoothly and monotonely instead: see optics/dispersion/continuation.h.
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

/// What tabulated coefficients are about. `air`: both the index and the wavelengths that go into
/// the formula are those in air at 20 °C, 101325 Pa, as glass makers measure. `vacuum`: neither.
enum class IndexReference { vacuum, air };

/// Wavelengths that data are of, of the kind that the reference says.
struct DataRange {
    double min_nm = 0.0, max_nm = 0.0;
};

/// A formula with its coefficients, as catalogues and scene files give it.
struct DispersionData {
    std::string form;                  ///< a name of dispersion_forms()
    std::vector<double> coefficients;  ///< in the form's order; wavelengths in micrometres
    IndexReference reference = IndexReference::air;
    std::optional<DataRange> range = std::nullopt;  ///< nothing: all that is seen, 360–830 nm
};

struct DispersionForm {
    std::string name;
    std::string formula;  ///< as text, with the coefficients' order
    std::string source;
    std::size_t least_coefficients = 0, most_coefficients = 0;
    DispersionPtr (*make)(const DispersionData& data);
};
/// Formulas by the names of the field (constant, sellmeier, cauchy, hartmann, conrady, herzberger,
/// schott, …), those of two numbers (abbe, pov_ray), table, gas, water, sea_water; and those of
/// glass files by number, with coefficients as the files have them: agf_1 … agf_13, rii_1 … rii_9.
const std::vector<DispersionForm>& dispersion_forms();

/// Builds the dispersion. With IndexReference::air the formula is evaluated at the wavelength in
/// air, and its value is multiplied by the index of air (a form without dispersion by that at the d
/// line, so that it stays constant). Throws InputError (unknown form with the nearest name, wrong
/// number of coefficients, not finite, a range that is none, an index below 1 or above 10 anywhere
/// in 360–830 nm).
DispersionPtr make_dispersion(const DispersionData& data);

/// Dry air at 20 °C, 101325 Pa, 450 ppm CO2: what IndexReference::air means. [Ciddor 1996]
/// Error against NIST's table of Ciddor's equation: 1e-9.
DispersionPtr air();
DispersionPtr vacuum();
/// What the index of such data is against.
DispersionPtr medium_of(IndexReference reference);

/// (n_d − 1) / (n_F − n_C) of `dispersion` against `medium`; infinite without dispersion.
double abbe_number(const Dispersion& dispersion, const Dispersion& medium);

}  // namespace dewbow
