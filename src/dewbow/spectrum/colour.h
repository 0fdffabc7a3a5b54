// SPDX-License-Identifier: Apache-2.0
#pragma once

// Colours that carry their space.

#include <array>
#include <cstddef>

namespace dewbow {

struct Xyz {};  ///< CIE 1931 2°; Y of a spectral radiance is luminance / 683 lm W⁻¹ unless said
struct LinearSrgb {};  ///< Rec.709 primaries, D65, linear
struct LinearRec2020 {};
struct LinearDisplayP3 {};
struct AcesCg {};   ///< AP1 primaries, ACES white, linear
struct Monitor {};  ///< of the monitor that a SpectralModel is made for, linear

template <class Space>
struct Colour {
    std::array<double, 3> v{};

    constexpr double operator[](std::size_t i) const { return v[i]; }
    constexpr double& operator[](std::size_t i) { return v[i]; }
    friend constexpr Colour operator+(Colour a, Colour b) {
        return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
    }
    friend constexpr Colour operator-(Colour a, Colour b) {
        return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
    }
    friend constexpr Colour operator*(Colour a, double s) {
        return {{a[0] * s, a[1] * s, a[2] * s}};
    }
    friend constexpr Colour operator*(double s, Colour a) { return a * s; }
    constexpr bool operator==(const Colour&) const = default;
};

}  // namespace dewbow
