// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dewbow {
namespace {

/// Of the sum of the terms' moduli, over about 100 orders.
constexpr double kRounding = 1e-14;

/// Factors that belong to no sphere.
std::vector<double> some_factors(int orders, int seed) {
    std::vector<double> factors;
    for (int i = 0; i < 2 * orders; ++i) factors.push_back(std::sin(1.7 * i * i + seed));
    return factors;
}

/// Σ_n factor × (π_n ± τ_n), and of moduli, by Legendre's recurrence in long double.
struct Sum {
    long double value = 0.0L, moduli = 0.0L;
};
Sum direct_sum(const std::vector<double>& factors, std::size_t part, double epsilon, int sign) {
    const long double mu = 1.0L - epsilon;
    long double before = 0.0L, pi = 1.0L;
    Sum sum;
    for (std::size_t n = 1; 2 * n <= factors.size(); ++n) {
        const long double tau = n * mu * pi - (n + 1) * before;
        const long double term = factors[2 * n - 2 + part] * (pi + sign * tau);
        sum.value += term;
        sum.moduli += std::abs(term);
        const long double next = ((2 * n + 1) * mu * pi - (n + 1) * before) / n;
        before = pi;
        pi = next;
    }
    return sum;
}

TEST(SumBlock, AllInstructionSetsAgreeWithTheDirectSum) {
    // Fewer angles than a block has, from the axis to 90°; spheres of several lengths, some no
    // multiple of what stays in registers, one empty.
    std::vector<double> epsilon{0.0, 1e-18, 1e-9, 1e-4};
    for (int i = 1; i <= 40; ++i) epsilon.push_back(i / 40.0);
    const int lengths[] = {100, 1, 32, 33, 0, 97};
    std::vector<std::vector<double>> plus, minus;
    std::vector<WaveFactors> spheres;
    for (int orders : lengths) {
        plus.push_back(some_factors(orders, 1));
        minus.push_back(some_factors(orders, 2));
    }
    for (std::size_t s = 0; s < plus.size(); ++s) spheres.push_back({plus[s], minus[s]});
    for (const SumBlockVariant& variant : sum_block_variants()) {
        if (!variant.is_supported()) continue;
        std::vector<BlockSums> sums(spheres.size());
        variant.sum_block(spheres, epsilon, sums);
        for (std::size_t s = 0; s < spheres.size(); ++s)
            for (std::size_t i = 0; i < epsilon.size(); ++i)
                for (std::size_t part : {0, 1}) {
                    const Sum p = direct_sum(plus[s], part, epsilon[i], 1);
                    const Sum m = direct_sum(minus[s], part, epsilon[i], -1);
                    ASSERT_NEAR(sums[s].plus[part][i], double(p.value), kRounding * p.moduli)
                        << variant.name << ", sphere " << s << ", angle " << i;
                    ASSERT_NEAR(sums[s].minus[part][i], double(m.value), kRounding * p.moduli)
                        << variant.name << ", sphere " << s << ", angle " << i;
                }
    }
}

TEST(SumBlock, ChoosesTheFirstThatTheProcessorHas) {
    const std::vector<double> epsilon{0.3}, factors = some_factors(50, 3);
    const WaveFactors sphere{factors, factors};
    BlockSums chosen, expected;
    sum_block({&sphere, 1}, epsilon, {&chosen, 1});
    for (const SumBlockVariant& variant : sum_block_variants())
        if (variant.is_supported()) {
            variant.sum_block({&sphere, 1}, epsilon, {&expected, 1});
            break;
        }
    EXPECT_EQ(chosen.plus[0][0], expected.plus[0][0]);
    EXPECT_EQ(chosen.minus[1][0], expected.minus[1][0]);
    EXPECT_TRUE(sum_block_variants().back().is_supported());
}

}  // namespace
}  // namespace dewbow
