// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/albedo.h"

#include <gtest/gtest.h>

#include "dewbow/optics/metal.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// Spectra are made for colours to a few thousandths; the sums over nanometres are finer.
constexpr double kColourError = 5e-3;

Colour<LinearSrgb> albedo_of(Material material) {
    Scene scene = make_empty_scene();
    scene.add(std::move(material));
    return rgb_from_xyz<LinearSrgb>(albedo_of_materials(scene).at(0));
}

void expect_rgb(Colour<LinearSrgb> found, std::array<double, 3> expected, double error) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], error) << c;
}

TEST(Albedo, WhiteIsWhiteAndColoursAreTheirs) {
    expect_rgb(albedo_of({"white", Diffuse{make_constant(1.0)}}), {1, 1, 1}, kColourError);
    expect_rgb(albedo_of({"", MetallicRoughness{make_reflectance({{0.8, 0.3, 0.1}})}}),
               {0.8, 0.3, 0.1}, kColourError);
    expect_rgb(albedo_of({"black", Black{}}), {0, 0, 0}, 0.0);
}

/// Gold reflects most of the red and half of the blue.
TEST(Albedo, OfAMetalIsItsReflectance) {
    const Metal& gold = find_metal("gold");
    const Colour<LinearSrgb> found = albedo_of({"gold", Conductor{gold.n, gold.k}});
    EXPECT_GT(found[0], 0.9);
    EXPECT_GT(found[0], found[1]);
    EXPECT_GT(found[1], found[2] + 0.2);
}

TEST(Albedo, OfATextureIsThatOfThePlace) {
    ColourInput colour;
    colour.vertex_colour = true;
    colour.factor = {{1.0, 0.5, 1.0}};
    SurfaceCoordinates at;
    at.colour = {{0.25, 0.5, 1.0}};
    constexpr double kRounding = 1e-6;  // of the matrices
    expect_rgb(rgb_from_xyz<LinearSrgb>(albedo_at({"", Diffuse{colour}}, {}, at)),
               {0.25, 0.25, 1.0}, kRounding);
}

}  // namespace
}  // namespace dewbow
