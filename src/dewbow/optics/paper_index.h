// SPDX-License-Identifier: Apache-2.0
#pragma once

// The paper's linear index: a straight line over its spectral coordinate f, from the index at the
// far red and the dispersive power. [Musgrave 1989, eq. 2 and 9]

#include <string>
#include <vector>

#include "dewbow/optics/dispersion.h"
#include "dewbow/spectrum/linear_model.h"

namespace dewbow {

/// How eq. 9, c_s = (w(η − 1) − η)/0.76, is read, with η(f) = c_s f as printed.
enum class IndexReading {
    printed,  ///< as it stands. It gives negative indices: a number for tables, never a medium
    intended,  ///< η + w(η − 1)/0.76 · f: what its derivation gives before the print lost "+ η"
    exact,     ///< η + k f with the k whose line has the dispersive power w, by eq. 2
};
/// Their words, in this order.
const std::vector<std::string>& index_reading_names();

/// The share of the spectrum between the C and F lines, as the paper has it. From 380 to 800 nm it
/// is 0.386 in frequency and 0.405 in wavelength.
inline constexpr double kPaperShare = 0.76;

/// η(f) = at_red + slope f, against air.
struct LinearIndex {
    double at_red = 1.0, slope = 0.0;
    double at(double f) const { return at_red + slope * f; }
};

/// The line of `eta_red`, the index at 800 nm, and w. Exact: k = w(η − 1)/(κ − w f_D) with κ =
/// f_F − f_C, from η_F − η_C = kκ and η_D = η + k f_D. Throws InputError at that reading's pole, w
/// = κ/f_D (1.19 in frequency), and beyond.
LinearIndex linear_index(double eta_red, double w, IndexReading reading,
                         SpectralSpacing spacing = SpectralSpacing::frequency);

/// The medium whose index against air, at the vacuum wavelength of f, is that line: index and
/// colour of a sample share one f. The paper's spectrum ends at 380 and 800 nm; beyond them the
/// line goes on, with the care of every formula (optics/dispersion/continuation.h). With `eta_red`
/// 1 it is air, with w = 0 a constant. Throws InputError for the printed reading, at the pole, and
/// for an index below 1 or above 10 anywhere in 360–830 nm.
DispersionPtr paper_index(double eta_red, double w, IndexReading reading,
                          SpectralSpacing spacing = SpectralSpacing::frequency);

/// False of what the paper has no line for: indices without dispersion, and gases, whose n_D is
/// within 1e-3 of air's.
bool disperses_in_air(const DispersionPtr& dispersion);

/// The line of a real medium: of its index against air at 800 nm, and its w. What does not
/// disperse in air stays as it is, and so does what is the paper's index already.
DispersionPtr paper_index_of(const DispersionPtr& real, IndexReading reading,
                             SpectralSpacing spacing = SpectralSpacing::frequency);

}  // namespace dewbow
