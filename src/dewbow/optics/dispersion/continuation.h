// SPDX-License-Identifier: Apache-2.0
#pragma once

// How a dispersion formula goes on where it cannot be trusted.

#include <functional>

#include "dewbow/optics/dispersion.h"

namespace dewbow::dispersion {

/// A formula is trusted where its data are, and beyond them for as long as it behaves as a
/// transparent medium does: walking outwards, n − 1 keeps half of what it is at the edge, and the
/// slope of n in w = 1/λ² its sign and, within a factor of 2.5, its size, which it does not where a
/// resonance is near. From there on n follows its last tangent in w, where an index is nearly a
/// straight line (Cauchy's first two terms); where the tangent falls, n − 1 decays exponentially
/// with the same slope instead, so that n stays above 1:
///
///     n(w) = n_t + s (w − w_t)                              where s (w − w_t) >= 0
///     n(w) = 1 + (n_t − 1) exp(s (w − w_t) / (n_t − 1))     where it is negative
///
/// n and dn/dλ are continuous, and n is monotone on each side.
class Continuation {
public:
    /// @param index  the formula, of nm.   @param data  where its data are.
    Continuation(const std::function<double(double)>& index, DataRange data);

    bool is_trusted(double lambda_nm) const {
        return lambda_nm >= shortest_.lambda_nm && lambda_nm <= longest_.lambda_nm;
    }
    /// The index where the formula is not trusted.
    double at(double lambda_nm) const;

private:
    struct End {
        double lambda_nm = 0.0;
        double w = 0.0, n = 1.0, slope = 0.0;  ///< w in µm⁻², slope = dn/dw
    };
    static End trusted_end(const std::function<double(double)>& index, double edge_nm,
                           double step_factor, double limit_nm);

    End shortest_, longest_;
};

}  // namespace dewbow::dispersion
