// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface_inputs.h"

#include <gtest/gtest.h>

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;

/// Two triangles of a unit square; the second set of coordinates is twice the first.
Mesh square() {
    Mesh mesh;
    mesh.vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.texcoords[1] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0}, {1, 1, 1, 0.5}};
    return mesh;
}

TEST(SurfaceCoordinates, AreLinearOnATriangle) {
    const SurfaceCoordinates at = coordinates_on(square(), 0, 0.25, 0.5);
    EXPECT_NEAR(at.uv[0].u, 0.75, kRounding);
    EXPECT_NEAR(at.uv[0].v, 0.5, kRounding);
    EXPECT_NEAR(at.uv[1].u, 1.5, kRounding);
    EXPECT_NEAR(at.uv[1].v, 1.0, kRounding);
    EXPECT_NEAR(at.colour[0], 0.25, kRounding);
    EXPECT_NEAR(at.colour[1], 0.25, kRounding);
    EXPECT_NEAR(at.colour[2], 0.5, kRounding);
    EXPECT_NEAR(at.alpha, 0.5, kRounding);
}

TEST(SurfaceCoordinates, OneSetStandsForBoth) {
    Mesh mesh = square();
    mesh.texcoords[0].clear();
    EXPECT_NEAR(coordinates_on(mesh, 1, 0.0, 1.0).uv[0].v, 2.0, kRounding);
    mesh.texcoords[1].clear();
    EXPECT_EQ(coordinates_on(mesh, 1, 0.0, 1.0).uv[0].v, 0.0);
}

TexturePtr one_texel(std::uint8_t r, std::uint8_t g, std::uint8_t b, std::uint8_t a) {
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 1;
    image->texels8 = {r, g, b, a};
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    texture->coding = TextureCoding::linear;
    return texture;
}

TEST(SurfaceInputs, ANumberIsItsFactorTimesOneChannel) {
    const SurfaceCoordinates at;
    RgbReflectanceLanes rgb;
    const SurfaceInputs inputs(at, rgb);
    NumberInput number = 0.5;
    EXPECT_EQ(inputs.number(number), 0.5);
    number.texture = one_texel(0, 51, 255, 102);
    for (const auto& [channel, value] : {std::pair{0, 0.0}, {1, 0.1}, {2, 0.5}, {3, 0.2}}) {
        number.channel = channel;
        EXPECT_NEAR(inputs.number(number), value, kRounding);
    }
}

TEST(SurfaceInputs, AColourIsFactorTimesTexelTimesVertexColour) {
    SurfaceCoordinates at;
    at.colour = {{0.5, 0.5, 0.5}};
    WavelengthPacket packet;
    packet.count = 1;
    packet.lambda_nm[0] = 550.0;
    RgbReflectanceLanes rgb;
    rgb.begin(packet);
    const LaneSet lanes = LaneSet::all(packet);
    const SurfaceInputs inputs(at, rgb);
    LaneValues value;

    inputs.colour(ColourInput{}, lanes, value);
    EXPECT_EQ(value[0], 1.0);
    inputs.colour(ColourInput{make_constant(0.3)}, lanes, value);
    EXPECT_EQ(value[0], 0.3);
    ColourInput colour;
    colour.texture = one_texel(102, 102, 102, 255);
    colour.factor = {{0.5, 0.5, 0.5}};
    inputs.colour(colour, lanes, value);
    EXPECT_NEAR(value[0], 0.2, kRounding);
    colour.vertex_colour = true;
    inputs.colour(colour, lanes, value);
    EXPECT_NEAR(value[0], 0.1, kRounding);
}

}  // namespace
}  // namespace dewbow
