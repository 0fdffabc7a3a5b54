// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/self_test/comparison.h"

#include <algorithm>
#include <cmath>

#include "dewbow/rainbow/mie/angular_sum.h"

namespace dewbow::self_test {

void Comparison::compare(std::string quantity, double computed, double expected, double allowed) {
    rows_.push_back({source_, std::move(quantity), expected, computed,
                     std::abs(computed - expected) / std::abs(expected), allowed});
}

void Comparison::compare(std::string quantity, std::complex<double> computed,
                         std::complex<double> expected, double allowed) {
    rows_.push_back({source_, std::move(quantity), std::abs(expected), std::abs(computed),
                     std::abs(computed - expected) / std::abs(expected), allowed});
}

void Comparison::bound(std::string quantity, double computed, double allowed) {
    rows_.push_back({source_, std::move(quantity), 0.0, computed, std::abs(computed), allowed});
}

void Comparison::add_worst(const Rows& all) {
    // NaN is worse than any number.
    const auto better = [](const SelfTestRow& a, const SelfTestRow& b) {
        return std::isnan(b.error) ? !std::isnan(a.error) : a.error < b.error;
    };
    const auto worst = std::max_element(all.begin(), all.end(), better);
    rows_.push_back(*worst);
}

Amplitudes amplitudes_at(const PartialWaves& waves, Angle theta) {
    Amplitudes s;
    angular_sum({&waves, 1}, {&theta, 1}, {&s, 1});
    return s;
}

}  // namespace dewbow::self_test
