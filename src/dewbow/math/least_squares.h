// SPDX-License-Identifier: Apache-2.0
#pragma once

// Fits: linear ones at once, and of one more constant by search.

#include <cmath>
#include <span>
#include <vector>

namespace dewbow {

/// The x that makes |A x − b| least, by Householder's reflections.
///                                                           [Golub & Van Loan 1996, §5.3.2]
/// @param a  A by columns, [column][row], with at least as many rows as columns.
/// @param b  a number for each row.
/// @return  a number for each column; 0 for a column that depends on those before it to within
///          1e-14 of its length.
/// Error: 1e-16 times the condition number of A (its square where the residual is large).
std::vector<double> least_squares(std::span<const double> a, std::span<const double> b);

/// Where `f`, with one minimum between a and b, is least, to within `share` of b − a; by the golden
/// section, 1.44 log2(1/share) calls.                                                [Kiefer 1953]
template <class Function>
double find_minimum(const Function& f, double a, double b, double share = 1e-9) {
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0), width = share * (b - a);
    double left = b - golden * (b - a), right = a + golden * (b - a);
    double f_left = f(left), f_right = f(right);
    while (b - a > width) {
        if (f_left < f_right) {
            b = right, right = left, f_right = f_left;
            left = b - golden * (b - a), f_left = f(left);
        } else {
            a = left, left = right, f_left = f_right;
            right = a + golden * (b - a), f_right = f(right);
        }
    }
    return 0.5 * (a + b);
}

}  // namespace dewbow
