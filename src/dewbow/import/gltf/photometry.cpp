// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/photometry.h"

#include <algorithm>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::gltf {

SpectrumPtr photometric_spectrum(Vec3 rgb, double size) {
    const double largest = std::max({rgb.x, rgb.y, rgb.z});
    if (largest <= 0.0 || size <= 0.0) return nullptr;
    // make_emission's (1, 1, 1) is as bright as the constant spectrum 1.
    const Vec3 hue = rgb / largest;
    return make_scaled(make_emission({{hue.x, hue.y, hue.z}}), largest * size * one_nit());
}

double one_nit() { return 1.0 / (kLuminousEfficacy * cie_y_integral()); }

}  // namespace dewbow::gltf
