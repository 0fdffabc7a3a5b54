// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the checks of the self test are written with, and their list.

#include <complex>
#include <string>
#include <vector>

#include "dewbow/rainbow/mie/partial_waves.h"
#include "dewbow/rainbow/self_test.h"

namespace dewbow::self_test {

using Rows = std::vector<SelfTestRow>;
inline constexpr double kWater = 1.333;

/// Adds rows of one source.
class Comparison {
public:
    Comparison(Rows& rows, std::string source) : rows_(rows), source_(std::move(source)) {}

    void compare(std::string quantity, double computed, double expected, double allowed);
    /// Shows moduli; the error is that of the complex numbers.
    void compare(std::string quantity, std::complex<double> computed, std::complex<double> expected,
                 double allowed);
    /// Something that should be 0.
    void bound(std::string quantity, double computed, double allowed);

    /// Of all that `compare_all` compares, the row with the largest error.
    template <class Function>
    void worst_of(const Function& compare_all) {
        Rows all;
        Comparison inner(all, source_);
        compare_all(inner);
        add_worst(all);
    }

private:
    void add_worst(const Rows& all);

    Rows& rows_;
    std::string source_;
};

Amplitudes amplitudes_at(const PartialWaves& waves, Angle theta);

void check_miev0(Rows& rows);
void check_bohren_huffman(Rows& rows);
void check_50_digits(Rows& rows);
void check_conservation(Rows& rows);
void check_debye(Rows& rows);
void check_uniform_airy(Rows& rows);
void check_descartes_rays(Rows& rows);

}  // namespace dewbow::self_test
