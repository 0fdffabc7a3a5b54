// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers by which other programs and trades say how strongly a glass of a given n_d disperses,
// and what each stands for in the others.

#include <functional>
#include <string>
#include <vector>

#include "dewbow/optics/glass.h"

namespace dewbow {

/// The index against air at a wavelength in air, in nm.
using IndexInAir = std::function<double(double lambda_air_nm)>;

/// The two terms n = A + B/λ² (λ in µm, in air) that pass through n_d at the d line: what glTF and
/// OpenPBR make of a glass.
IndexInAir two_terms(double n_d, double b_um2);

/// That of data against air, or of data against vacuum divided by the index of air.
IndexInAir index_in_air(const DispersionPtr& dispersion);

struct DispersionUnit {
    std::string name;     ///< as an option spells it: "abbe"
    std::string meaning;  ///< with who uses it
    double (*measure)(const IndexInAir& n);
    /// B of the two terms through n_d that measure `value`. A value that no glass has gives a B
    /// that is not finite or not positive.
    double (*b_um2)(double n_d, double value);
};
/// abbe V_d · gltf 20/V_d · w the paper's dispersive power · pov_ray n_v/n_r · cauchy_b in µm² ·
/// spread n_F − n_C · fire n_G − n_B.
const std::vector<DispersionUnit>& dispersion_units();

/// (n_F − n_C) / (n_D − 1).                                              [Musgrave 1989, eq. 2]
double dispersive_power(const IndexInAir& n);
/// (n_x − n_y) / (n_F − n_C), P_x,y.
double partial_dispersion(const IndexInAir& n, double x_air_nm, double y_air_nm);

/// Largest |n − of_glass| from 400 to 700 nm, at every nanometre.
double worst_difference(const IndexInAir& n, const IndexInAir& of_glass);

}  // namespace dewbow
