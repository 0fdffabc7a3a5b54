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

/// Σ_n factor × (π_n + sign τ_n) at cosine mu, and of moduli, by Legendre's recurrence in long
/// double.
struct DirectSum {
    long double value = 0.0L, moduli = 0.0L;
    DirectSum(const std::vector<double>& factors, std::size_t part, long double mu, int sign) {
        long double before = 0.0L, pi = 1.0L;
        for (std::size_t n = 1; 2 * n <= factors.size(); ++n) {
            const long double tau = n * mu * pi - (n + 1) * before;
            const double factor = factors[2 * n - 2 + part];
            value += factor * (pi + sign * tau);
            moduli += std::abs(factor) * (std::abs(pi) + std::abs(tau));
            const long double next = ((2 * n + 1) * mu * pi - (n + 1) * before) / n;
            before = pi;
            pi = next;
        }
    }
};

struct Spheres {
    std::vector<std::vector<double>> plus, minus;
    std::vector<WaveFactors> factors;
};

void expect_direct_sums(const Spheres& spheres, const std::vector<double>& epsilon,
                        const std::vector<BlockSums>& sums, int direction,
                        std::string_view variant) {
    for (std::size_t s = 0; s < sums.size(); ++s)
        for (std::size_t i = 0; i < epsilon.size(); ++i)
            for (std::size_t part : {0, 1}) {
                const long double mu = direction * (1.0L - epsilon[i]);
                const DirectSum p(spheres.plus[s], part, mu, 1), m(spheres.minus[s], part, mu, -1);
                ASSERT_NEAR(sums[s].plus[part][i], double(p.value), kRounding * p.moduli)
                    << variant << ", sphere " << s << ", angle " << i << ", " << direction;
                ASSERT_NEAR(sums[s].minus[part][i], double(m.value), kRounding * m.moduli)
                    << variant << ", sphere " << s << ", angle " << i << ", " << direction;
            }
}

TEST(SumBlock, AllInstructionSetsAgreeWithTheDirectSum) {
    // Fewer angles than a block has, from the axis to 90°; spheres of several lengths, some no
    // multiple of what stays in registers, one empty.
    std::vector<double> epsilon{0.0, 1e-18, 1e-9, 1e-4};
    for (int i = 1; i <= 40; ++i) epsilon.push_back(i / 40.0);
    Spheres spheres;
    for (int orders : {100, 1, 40, 41, 0, 97}) {
        spheres.plus.push_back(some_factors(orders, 1));
        spheres.minus.push_back(some_factors(orders, 2));
    }
    const std::size_t count = spheres.plus.size();
    for (std::size_t s = 0; s < count; ++s)
        spheres.factors.push_back({spheres.plus[s], spheres.minus[s]});
    for (const SumBlockVariant& variant : sum_block_variants()) {
        if (!variant.is_supported()) continue;
        for (const auto& [forwards, backwards] :
             {std::pair(count, count), {count, 0}, {0, count}}) {
            std::vector<BlockSums> forward(forwards), backward(backwards);
            variant.sum_block(spheres.factors, epsilon, forward, backward);
            expect_direct_sums(spheres, epsilon, forward, 1, variant.name);
            expect_direct_sums(spheres, epsilon, backward, -1, variant.name);
        }
    }
}

TEST(SumBlock, ChoosesTheFirstThatTheProcessorHas) {
    const std::vector<double> epsilon{0.3}, factors = some_factors(50, 3);
    const WaveFactors sphere{factors, factors};
    BlockSums chosen, expected;
    sum_block({&sphere, 1}, epsilon, {&chosen, 1}, {});
    for (const SumBlockVariant& variant : sum_block_variants())
        if (variant.is_supported()) {
            variant.sum_block({&sphere, 1}, epsilon, {&expected, 1}, {});
            break;
        }
    EXPECT_EQ(chosen.plus[0][0], expected.plus[0][0]);
    EXPECT_EQ(chosen.minus[1][0], expected.minus[1][0]);
    EXPECT_TRUE(sum_block_variants().back().is_supported());
}

}  // namespace
}  // namespace dewbow
