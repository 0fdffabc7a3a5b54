// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/haze/distance_density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dewbow/math/quadrature.h"

namespace dewbow {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
const std::vector<double> kExtinctions{0.1, 0.5, 0.1, 2.0, 0.0};

/// Steps of the number that samples are made of.
constexpr int kSteps = 4000;
/// Of a mixture each term takes steps of its own, and cuts at most two of them at each end of a
/// bin: the share of a bin is off by no more than this for every term.
constexpr double kShareOfATerm = 2.0 / kSteps;

struct Case {
    const char* name;
    DistanceDensity density;
    int terms;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    const auto add = [&](const char* name, int terms, auto&& fill) {
        all.push_back({name, DistanceDensity(kExtinctions), terms});
        fill(all.back().density);
    };
    add("beside a lamp", 1, [](DistanceDensity& d) {
        d.add_equiangular({1.0, 9.0}, 4.0, 0.5, 1.0);
    });
    add("before a lamp", 1, [](DistanceDensity& d) {
        d.add_equiangular({0.0, 3.0}, 7.0, 2.0, 1.0);
    });
    add("past a lamp, for ever", 1, [](DistanceDensity& d) {
        d.add_equiangular({2.0, kForever}, 3.0, 1.0, 1.0);
    });
    add("evenly lit", 3, [](DistanceDensity& d) { d.add_attenuated({0.5, 8.0}, 1.0); });
    add("evenly lit for ever", 3, [](DistanceDensity& d) {
        d.add_attenuated({0.0, kForever}, 1.0);
    });
    add("all of it", 8, [](DistanceDensity& d) {
        d.add_attenuated({0.0, 10.0}, 0.3);
        d.add_equiangular({0.0, 10.0}, 2.0, 0.1, 0.05);
        d.add_equiangular({4.0, 6.0}, 2.0, 0.5, 2.0);
        d.add_attenuated({7.0, 7.5}, 20.0);
        d.finish({0.0, 10.0}, 0.1);
    });
    return all;
}

// The sampled share of each bin is the integral of the density over it.
TEST(DistanceDensity, SamplesAreAsItSays) {
    const QuadratureRule rule = gauss_legendre(400);
    constexpr double kBin = 0.5;
    for (const Case& c : cases()) {
        std::array<int, 40> counts{};
        for (int i = 0; i < kSteps; ++i) {
            const double t = c.density.sample((i + 0.5) / kSteps);
            if (t < kBin * counts.size()) ++counts[std::size_t(t / kBin)];
        }
        for (std::size_t bin = 0; bin < counts.size(); ++bin) {
            const double share = integrate(rule, kBin * double(bin), kBin * double(bin + 1),
                                           [&](double t) { return c.density.pdf(t); });
            EXPECT_NEAR(counts[bin] / double(kSteps), share, kShareOfATerm * c.terms)
                << c.name << ", from " << kBin * double(bin) << " m";
        }
    }
}

// ∫ pdf over [0, ∞): to 10 m in pieces between which the densities jump, then by t = 10 / x.
TEST(DistanceDensity, IntegratesToOne) {
    constexpr double kQuadrature = 1e-9;
    const QuadratureRule rule = gauss_legendre(200);
    for (const Case& c : cases()) {
        const auto pdf = [&](double t) { return c.density.pdf(t); };
        double sum =
            integrate(rule, 0.0, 1.0, [&](double x) { return 10.0 / (x * x) * pdf(10.0 / x); });
        for (int piece = 0; piece < 20; ++piece)
            sum += integrate(rule, 0.5 * piece, 0.5 * (piece + 1), pdf);
        EXPECT_NEAR(sum, 1.0, kQuadrature) << c.name;
    }
}

// The defensive share, whatever else there is; and where there is no room for more.
TEST(DistanceDensity, StarvesNoDistance) {
    constexpr double kShare = 0.1, kLength = 10.0, kSigma = 0.2;
    for (const int lamps : {1, 3, 100}) {
        DistanceDensity density(std::vector<double>{kSigma});
        for (int i = 0; i < lamps; ++i) density.add_equiangular({1.0, 1.1}, 1.0, 0.01, 100.0);
        density.finish({0.0, kLength}, kShare);
        for (const double t : {0.0, 0.9, 5.0, 10.0}) {
            const double even = kSigma * std::exp(-kSigma * t) / -std::expm1(-kSigma * kLength);
            EXPECT_NEAR(density.pdf(t), kShare * even, 1e-12) << lamps << " lamps at " << t;
        }
    }
}

TEST(DistanceDensity, IsEmptyWhereNothingScatters) {
    DistanceDensity density(std::vector<double>{0.0, 0.0});
    density.finish({0.0, kForever}, 0.1);
    EXPECT_TRUE(density.empty());
}

// A ray straight into a lamp.
TEST(DistanceDensity, IsFiniteAtALamp) {
    DistanceDensity density(std::vector<double>{0.1});
    density.add_equiangular({0.0, 5.0}, 5.0, 0.0, 1.0);
    density.finish({0.0, 5.0}, 0.1);
    for (const double u : {0.0, 0.3, 0.999999}) {
        const double t = density.sample(u);
        EXPECT_GE(t, 0.0);
        EXPECT_LE(t, 5.0);
        EXPECT_TRUE(std::isfinite(density.pdf(t)) && density.pdf(t) > 0.0) << u;
    }
}

}  // namespace
}  // namespace dewbow
