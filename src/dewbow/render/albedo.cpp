// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/albedo.h"

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// XYZ of white D65 light after `factor(lambda)`, by sums over whole nanometres.
template <class Factor>
Colour<Xyz> under_d65(Factor&& factor) {
    static const SpectrumPtr d65 = find_illuminant("D65");
    Colour<Xyz> sum{};
    double white = 0.0;
    for (double lambda_nm = kLambdaMin_nm; lambda_nm <= kLambdaMax_nm; lambda_nm += 1.0) {
        const Wavelength lambda = lambda_nm * unit::nm;
        const auto bar = cie_xyz_bar(lambda_nm);
        const double light = (*d65)(lambda);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += light * factor(lambda) * bar[c];
        white += light * bar[1];
    }
    return sum * (1.0 / white);
}

Colour<Xyz> reflectance_of(const ColourInput& input) {
    if (!input.spectrum) return xyz_from_rgb(input.factor);
    return under_d65([&](Wavelength lambda) { return (*input.spectrum)(lambda); });
}

const ColourInput* colour_of(const Material& material) {
    if (const auto* s = std::get_if<Diffuse>(&material.surface)) return &s->reflectance;
    if (const auto* s = std::get_if<Mirror>(&material.surface)) return &s->reflectance;
    if (const auto* s = std::get_if<MetallicRoughness>(&material.surface)) return &s->base_colour;
    return nullptr;
}

Colour<Xyz> albedo_of(const Material& material) {
    if (std::holds_alternative<Black>(material.surface)) return {};
    if (const ColourInput* colour = colour_of(material)) return reflectance_of(*colour);
    if (const auto* metal = std::get_if<Conductor>(&material.surface))
        return under_d65([&](Wavelength lambda) {
            const double n = (*metal->n)(lambda), k = (*metal->k)(lambda);
            return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
        });
    return xyz_from_rgb(Colour<LinearSrgb>{{1.0, 1.0, 1.0}});
}

}  // namespace

std::vector<Colour<Xyz>> albedo_of_materials(const Scene& scene) {
    std::vector<Colour<Xyz>> all;
    for (const Material& material : scene.materials) all.push_back(albedo_of(material));
    return all;
}

Colour<Xyz> albedo_at(const Material& material, Colour<Xyz> otherwise,
                      const SurfaceCoordinates& at) {
    const ColourInput* colour = colour_of(material);
    return colour && colour->varies() ? xyz_from_rgb(colour_at(*colour, at)) : otherwise;
}

}  // namespace dewbow
