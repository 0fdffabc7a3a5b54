// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a rough boundary between dielectrics sends on once, and what is owed for light that its
// microfacets send on more than once.
//
// Of light that comes at cos θ = μ from the side of index 1, the boundary to the index n reflects
// and transmits E(μ, n); from the other side, E(μ, 1/n). What is lost, L = 1 − E, is given back by
//     f_ms(o → i) = q L(μ_o, n) L(μ_i, n) / (π L_avg(n))                       reflected,
//                   (1 − q) L(μ_o, n) L(μ_i, 1/n) / (π L_avg(1/n))             transmitted,
// L_avg = 2 ∫ L μ dμ, which gives L(μ_o, n) in all. Radiance / n² is reciprocal if
//     (1 − q(n)) L_avg(n) = n² (1 − q(1/n)) L_avg(1/n).
// With T(n) = 1 − F_avg(n), what a smooth boundary transmits of even light, T(n) = n² T(1/n), so
// that 1 − q(n) = T(n) min(1, L_avg(1/n) / L_avg(n)) is such a q, and is that of a smooth boundary
// as far as reciprocity allows.          [after Kulla & Conty 2017, who choose q in another way]
// Against walks among the microfacets q is within 0.02 at alpha = 0.25 and within 0.17 at alpha = 1
// (tests/statistical/microfacet_walk_test.cpp).
//
// Like all models of one boundary with Smith's shadowing, this one does not become invisible as n
// comes near 1: what is shadowed is scattered and not let through straight.

#include "dewbow/render/surface/table_axis.h"

namespace dewbow {

/// Largest error of L against an integral of its own, from index 1/2.5 to 2.5, and of what a clear
/// boundary sends on in all, which would be 1 (dielectric_energy_test.cpp).
inline constexpr double kDielectricEnergyError = 1e-2;

/// At one roughness and index; tables are computed when the first is made (0.2 s).
class DielectricEnergy {
public:
    /// @param n  of the far side against the near one; beyond 1/4 to 4, as at that end.
    DielectricEnergy(double alpha, double n);

    /// L of light from the near side, and from the far side.
    double lost_near(double cosine) const { return lost(cosine, near_); }
    double lost_far(double cosine) const { return lost(cosine, far_); }
    /// q of light from the near side.
    double reflected_share() const { return reflected_share_; }
    /// f_ms × cos θ_i but for its factor q or 1 − q.
    double compensation(double lost_o, double lost_i, double cos_i, bool reflects) const;

private:
    double lost(double cosine, TablePlace index) const;

    LogAxis cosines_;
    TablePlace row_, near_, far_;
    double average_near_, average_far_;
    double reflected_share_;
};

}  // namespace dewbow
