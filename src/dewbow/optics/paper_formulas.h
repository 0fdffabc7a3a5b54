// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's formulas of few constants for the index, as printed and as right, fitted to a glass.

#include <span>
#include <string>
#include <vector>

#include "dewbow/optics/equivalents.h"

namespace dewbow {

/// An index against air at a wavelength in air.
struct IndexSample {
    double air_nm = 0.0, n = 1.0;
};

struct FittedFormula {
    std::vector<double> constants;  ///< in the formula's order; λ in µm, unless it says nm
    IndexInAir index;
};

struct PaperFormula {
    std::string name;  ///< "Hartmann"
    bool printed = true, right = true;
    std::string text;       ///< "n = 1 + b/(c − λ)"
    std::string constants;  ///< their names: "b, c"
    /// By least squares in n (Sellmeier's in n²/2n, the same to first order), from samples by
    /// rising λ over a part of 300–900 nm, more than there are constants. What no linear fit finds,
    /// c of Sellmeier and Hartmann, by search.
    FittedFormula (*fit)(std::span<const IndexSample> samples);
};

/// Sellmeier, Cauchy, Hartmann, Conrady and Herzberger of §3.2, each as printed and as right, and
/// the straight line over f that eq. 9 wants.                                     [Musgrave 1989]
///
/// * Sellmeier is printed with c² − λ² below, and b "characteristic of the material": with no
///   b > 0 does the index fall with λ. Right is λ² − c². One band, alone and with the tail − d λ²
///   of another far in the infrared.
/// * Hartmann is printed without n0, and has then to come down to 1 far in the infrared: c is some
///   µm below 0. Right is n0 + b/(λ − c)^1.2.                                      [Hartmann 1898]
/// * Conrady is printed with λ² in place of λ^3.5.                                 [Conrady 1929]
/// * "Hertzberger" is Herzberger, whose 0.028 is in µm²: the unit is missing. With λ in nm it does
///   nothing, and the formula is a series in λ².                                 [Herzberger 1959]
/// * Cauchy is right as printed.
const std::vector<PaperFormula>& paper_formulas();

/// Where formulas are fitted and compared.
struct SpectralBand {
    double from_nm = 0.0, to_nm = 0.0;
};
/// What the paper simulates, and what its constants of water are of (§4.3.2).
inline constexpr SpectralBand kPaperSpectrum{380.0, 800.0}, kPaperWaterData{405.0, 670.0};

/// At every nanometre of `band`.
std::vector<IndexSample> index_samples(const IndexInAir& n, SpectralBand band);

struct IndexError {
    double worst = 0.0, rms = 0.0;
};
/// Of the formula from the samples.
IndexError index_error(const FittedFormula& fit, std::span<const IndexSample> samples);

}  // namespace dewbow
