// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mie/angular_sum.h"

#include <algorithm>

namespace dewbow {
namespace {

/// The half sum of S_1 ± S_2 at one angle, and their half difference.
Amplitudes amplitudes_of(const BlockSums& sums, std::size_t angle) {
    return {{0.5 * (sums.plus[0][angle] + sums.minus[0][angle]),
             0.5 * (sums.plus[1][angle] + sums.minus[1][angle])},
            {0.5 * (sums.plus[0][angle] - sums.minus[0][angle]),
             0.5 * (sums.plus[1][angle] - sums.minus[1][angle])}};
}

}  // namespace

void AngularSum::Factors::assign(const PartialWaves& waves) {
    plus.resize(2 * waves.a.size());
    minus.resize(2 * waves.a.size());
    for (std::size_t i = 0; i < waves.a.size(); ++i) {
        const double n = double(i) + 1.0, c = (2.0 * n + 1.0) / (n * (n + 1.0));
        const std::complex<double> a = waves.a[i], b = waves.b[i];
        plus[2 * i] = c * (a.real() + b.real());
        plus[2 * i + 1] = c * (a.imag() + b.imag());
        minus[2 * i] = c * (a.real() - b.real());
        minus[2 * i + 1] = c * (a.imag() - b.imag());
    }
}

AngularSum::AngularSum(std::span<const Angle> theta)
    : angles_(theta.size()), folded_(fold_angles(theta)) {}

void AngularSum::sum(std::span<const PartialWaves> spheres, std::span<Amplitudes> out) {
    buffers_.resize(std::max(buffers_.size(), spheres.size()));
    factors_.clear();
    for (std::size_t s = 0; s < spheres.size(); ++s) {
        buffers_[s].assign(spheres[s]);
        factors_.push_back(buffers_[s]);
    }
    std::span<const FoldedAngle> rest = folded_;
    while (!rest.empty()) {
        const auto block = rest.first(std::min(rest.size(), std::size_t(kBlockAngles)));
        sum(block);
        write(block, out);
        rest = rest.subspan(block.size());
    }
}

void AngularSum::sum(std::span<const FoldedAngle> block) {
    double epsilon[kBlockAngles];
    bool is_forward = false, is_backward = false;
    for (std::size_t i = 0; i < block.size(); ++i) {
        epsilon[i] = block[i].off_axis();
        is_forward |= block[i].forward >= 0;
        is_backward |= block[i].backward >= 0;
    }
    forward_.resize(is_forward ? factors_.size() : 0);
    backward_.resize(is_backward ? factors_.size() : 0);
    sum_block(factors_, {epsilon, block.size()}, forward_, backward_);
}

void AngularSum::write(std::span<const FoldedAngle> block, std::span<Amplitudes> out) const {
    for (std::size_t s = 0; s < factors_.size(); ++s) {
        const auto row = out.subspan(s * angles_, angles_);
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (block[i].forward >= 0)
                row[std::size_t(block[i].forward)] = amplitudes_of(forward_[s], i);
            if (block[i].backward >= 0)
                row[std::size_t(block[i].backward)] = amplitudes_of(backward_[s], i);
        }
    }
}

void angular_sum(std::span<const PartialWaves> spheres, std::span<const Angle> theta,
                 std::span<Amplitudes> out) {
    AngularSum(theta).sum(spheres, out);
}

}  // namespace dewbow
