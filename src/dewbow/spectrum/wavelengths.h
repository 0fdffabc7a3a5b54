// SPDX-License-Identifier: Apache-2.0
#pragma once

// The wavelengths that one path carries: a packet of lanes, stratified, jittered together and
// rotated from sample to sample, so that its sum stays near white in each packet and is white on
// average.

#include <array>
#include <cstddef>
#include <span>

namespace dewbow {

/// Most lanes that a packet has.
inline constexpr int kMaxLanes = 16;

/// How the wavelengths of packets are spread over 360–830 nm.
enum class WavelengthSampling {
    visual,   ///< by what the eye sees of it: density proportional to a mix of the three CIE curves
    uniform,  ///< evenly
};

/// `count` wavelengths and their densities.
struct WavelengthPacket {
    int count = 0;
    alignas(64) std::array<double, kMaxLanes> lambda_nm{};
    /// Probability density of each lane's wavelength, per nm.
    alignas(64) std::array<double, kMaxLanes> pdf_per_nm{};

    std::span<const double> lambdas() const { return {lambda_nm.data(), std::size_t(count)}; }
};

/// Lane k takes the quantile frac(u + k / count): u in [0, 1), count 1, 4, 8 or 16.
WavelengthPacket sample_wavelengths(WavelengthSampling sampling, int count, double u);

/// Density (per nm) with which `sampling` picks `lambda_nm`; zero outside 360–830 nm.
double wavelength_pdf(WavelengthSampling sampling, double lambda_nm);

}  // namespace dewbow
