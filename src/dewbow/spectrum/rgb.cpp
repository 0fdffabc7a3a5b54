// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/rgb.h"

#include "dewbow/spectrum/primaries_matrix.h"

namespace dewbow {
namespace {

template <class Space>
constexpr RgbPrimaries kPrimaries{};
template <>  // IEC 61966-2-1, from ITU-R BT.709
constexpr RgbPrimaries kPrimaries<LinearSrgb>{
    "srgb", {0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};
template <>  // ITU-R BT.2020
constexpr RgbPrimaries kPrimaries<LinearRec2020>{
    "rec2020", {0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
template <>  // SMPTE EG 432-1
constexpr RgbPrimaries kPrimaries<LinearDisplayP3>{
    "display-p3", {0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
template <>  // Academy S-2014-004, AP1
constexpr RgbPrimaries kPrimaries<AcesCg>{
    "acescg", {0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

// Worked out by the compiler.
template <class Space>
constexpr Matrix3 kXyzFromRgb = matrix_of_primaries(kPrimaries<Space>);
template <class Space>
constexpr Matrix3 kRgbFromXyz = inverse(kXyzFromRgb<Space>);

/// Sharpened cone responses from XYZ.  [Lam 1985; ICC.1:2010, Annex E]
constexpr Matrix3 kBradford{{Triple{0.8951, 0.2664, -0.1614}, Triple{-0.7502, 1.7135, 0.0367},
                             Triple{0.0389, -0.0685, 1.0296}}};
constexpr Matrix3 kBradfordInverse = inverse(kBradford);

}  // namespace

template <>
const RgbPrimaries& primaries_of<LinearSrgb>() {
    return kPrimaries<LinearSrgb>;
}
template <>
const RgbPrimaries& primaries_of<LinearRec2020>() {
    return kPrimaries<LinearRec2020>;
}
template <>
const RgbPrimaries& primaries_of<LinearDisplayP3>() {
    return kPrimaries<LinearDisplayP3>;
}
template <>
const RgbPrimaries& primaries_of<AcesCg>() {
    return kPrimaries<AcesCg>;
}

template <class Space>
Colour<Xyz> xyz_from_rgb(Colour<Space> rgb) {
    return {kXyzFromRgb<Space> * rgb.v};
}

template <class Space>
Colour<Space> rgb_from_xyz(Colour<Xyz> xyz) {
    return {kRgbFromXyz<Space> * xyz.v};
}

template Colour<Xyz> xyz_from_rgb(Colour<LinearSrgb>);
template Colour<Xyz> xyz_from_rgb(Colour<LinearRec2020>);
template Colour<Xyz> xyz_from_rgb(Colour<LinearDisplayP3>);
template Colour<Xyz> xyz_from_rgb(Colour<AcesCg>);
template Colour<LinearSrgb> rgb_from_xyz(Colour<Xyz>);
template Colour<LinearRec2020> rgb_from_xyz(Colour<Xyz>);
template Colour<LinearDisplayP3> rgb_from_xyz(Colour<Xyz>);
template Colour<AcesCg> rgb_from_xyz(Colour<Xyz>);

Colour<Xyz> adapt_white(Colour<Xyz> xyz, std::array<double, 2> from_white,
                        std::array<double, 2> to_white) {
    const Triple from = kBradford * xyz_from_chromaticity(from_white);
    const Triple to = kBradford * xyz_from_chromaticity(to_white);
    const Triple cone = kBradford * xyz.v;
    const Triple adapted{cone[0] * to[0] / from[0], cone[1] * to[1] / from[1],
                         cone[2] * to[2] / from[2]};
    return {kBradfordInverse * adapted};
}

}  // namespace dewbow
