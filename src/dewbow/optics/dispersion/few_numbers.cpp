// SPDX-License-Identifier: Apache-2.0

// What other programs know a glass by: an index, and at most one number for its dispersion.

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion/forms.h"
#include "dewbow/optics/dispersion/formula.h"
#include "dewbow/optics/fraunhofer.h"

namespace dewbow::dispersion {
namespace {

struct Constant {
    double n = 1.0;
    template <class V>
    V index(V) const {
        return V{} + n;
    }
    bool is_constant() const { return true; }
};

/// n = A + B / λ².
struct TwoTerms {
    double A = 1.0, B = 0.0;
    template <class V>
    V index(V lambda_um) const {
        return A + B / (lambda_um * lambda_um);
    }
    bool is_constant() const { return false; }
};

/// n = ior · dispersion^−((λ − 555 nm) / 350 nm): `dispersion` is n at 380 nm over n at 730 nm.
///                       [POV-Ray 3.8, source/core/colour/spectral.h,
///                       SpectralBand::GetDispersionIOR]
struct PovRay {
    double ior = 1.0, log_dispersion = 0.0;
    template <class V>
    V index(V lambda_um) const {
        return ior * each_lane(lambda_um, [this](double l) {
                   return std::exp(log_dispersion * (0.555 - l) / 0.350);
               });
    }
    bool is_constant() const { return log_dispersion == 0.0; }
};

void check_number(const DispersionData& data, const char* what, double value, double least,
                  double most) {
    if (value >= least && value <= most) return;
    throw InputError(
        fmt::format("{}: {} is {}; expected {} to {}", data.form, what, value, least, most));
}

/// The three lines, of the kind of wavelength that the formula is given, as 1/λ² in µm⁻².
struct Lines {
    double F, d, C;
    explicit Lines(IndexReference reference) {
        const bool in_air = reference == IndexReference::air;
        const auto w = [&](double air_nm, Wavelength vacuum) {
            const double lambda_um = 1e-3 * (in_air ? air_nm : vacuum.to(unit::nm));
            return 1.0 / (lambda_um * lambda_um);
        };
        F = w(kAirF_nm, kLineF);
        d = w(kAird_nm, kLined);
        C = w(kAirC_nm, kLineC);
    }
};

}  // namespace

DispersionPtr make_constant(const DispersionData& data) {
    return checked(data, Constant{data.coefficients[0]});
}

/// n = A + B / λ² through n_d with the Abbe number V_d: from V_d = (n_d − 1) / (n_F − n_C),
///     B = (n_d − 1) / (V_d (1/λ_F² − 1/λ_C²)),   A = n_d − B / λ_d². [KHR_materials_dispersion]
/// The extension prints it as n_d + (n_d − 1) / V_d · (523655 / λ² − 1.5168), with these lines, and
/// holds it at 1 where an extreme V_d brings it below in the red; ours comes near 1 smoothly.
DispersionPtr make_abbe(const DispersionData& data) {
    const double n_d = data.coefficients[0], V_d = data.coefficients[1];
    check_number(data, "n_d", n_d, kLeastIndex, kMostIndex);
    if (!(V_d > 0.0))
        throw InputError(fmt::format("abbe: V_d is {}; expected a positive number", V_d),
                         "for no dispersion use the form constant");
    const Lines lines(data.reference);
    TwoTerms formula;
    formula.B = (n_d - 1.0) / (V_d * (lines.F - lines.C));
    formula.A = n_d - formula.B * lines.d;
    // What two numbers state is known between the lines alone.
    const DataRange known = data.range.value_or(DataRange{kAird_nm, kAird_nm});
    return std::make_shared<const FormulaDispersion<TwoTerms>>(
        formula, Continuation([&](double l) { return formula.index(1e-3 * l); }, known));
}

DispersionPtr make_pov_ray(const DispersionData& data) {
    constexpr double kMostDispersion = 4.0;
    const double ior = data.coefficients[0], dispersion = data.coefficients[1];
    check_number(data, "the ior", ior, kLeastIndex, kMostIndex);
    check_number(data, "the dispersion", dispersion, 1.0, kMostDispersion);
    constexpr DataRange kItsSpectrum{380.0, 730.0};
    return checked(data.form, PovRay{ior, std::log(dispersion)}, data.range.value_or(kItsSpectrum));
}

}  // namespace dewbow::dispersion
