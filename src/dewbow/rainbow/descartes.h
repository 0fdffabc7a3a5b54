// SPDX-License-Identifier: Apache-2.0
#pragma once

// The model `descartes`: rays, as Descartes, Snell and Fresnel have them, each polarisation on its
// own, orders p = 0 … 7 summed without their phases.
//
// Of the intercepted flux, 1 in units of the drop's cross section, orders 0 to 7 carry 0.9997 in
// water. Diffraction around the drop, as much again and forward, is not counted. |S|² / x² does not
// depend on the drop's size.

#include <memory>

#include "dewbow/rainbow/models.h"

namespace dewbow {

/// Its `intensities` are means over the cells around the angles, exact to 1e-12 in flux. A drop
/// that is no sphere has each order's flux moved along θ by angle_without_shift, none of it lost.
/// `efficiencies`: extinction 1, scattering what the orders carry. Drops need a real index between
/// 1 and the lowest order from 2 on (else there is no bow), and a positive size.
/// Throws InputError for orders outside 0 to 7.
std::unique_ptr<ScatteringModel> make_descartes(const ModelOptions& options);

}  // namespace dewbow
