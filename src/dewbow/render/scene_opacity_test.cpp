// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/scene_opacity.h"

#include <gtest/gtest.h>

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;

/// Two texels side by side: alpha 51/255 = 0.2 on the left, 204/255 = 0.8 on the right.
TexturePtr two_alphas() {
    auto image = std::make_shared<TextureImage>();
    image->width = 2, image->height = 1;
    image->texels8 = {255, 255, 255, 51, 255, 255, 255, 204};
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    texture->interpolates = false;
    return texture;
}

Scene scene_with(Geometry geometry, std::optional<Coverage> coverage) {
    Scene scene = make_empty_scene();
    Material material{"veil", Diffuse{make_constant(0.5)}};
    material.coverage = coverage;
    scene.shapes.push_back({"shape", std::move(geometry), {}, scene.add(material)});
    return scene;
}

Coverage by_texture() {
    Coverage coverage;
    coverage.alpha.texture = two_alphas();
    coverage.alpha.channel = 3;
    return coverage;
}

TEST(SceneOpacity, AsksOnlyWhereSomethingIsMissing) {
    const Rectangle sheet{1.0 * unit::m, 1.0 * unit::m};
    EXPECT_FALSE(SceneOpacity(scene_with(sheet, std::nullopt)).tests(0));
    EXPECT_FALSE(SceneOpacity(scene_with(sheet, Coverage{})).tests(0));
    Coverage half;
    half.alpha = 0.5;
    EXPECT_TRUE(SceneOpacity(scene_with(sheet, half)).tests(0));
    half.cutoff = 0.5;  // there where alpha >= cutoff: everywhere
    EXPECT_FALSE(SceneOpacity(scene_with(sheet, half)).tests(0));
    EXPECT_TRUE(SceneOpacity(scene_with(sheet, by_texture())).tests(0));
}

TEST(SceneOpacity, OfAShapeGoesByItsOwnCoordinates) {
    const Scene scene = scene_with(Rectangle{1.0 * unit::m, 1.0 * unit::m}, by_texture());
    const SceneOpacity opacity(scene);
    EXPECT_NEAR(opacity.at(0, 0, 0.1, 0.9), 0.2, kRounding);
    EXPECT_NEAR(opacity.at(0, 0, 0.9, 0.9), 0.8, kRounding);
}

TEST(SceneOpacity, OfAMeshGoesByItsTextureCoordinates) {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
    mesh->triangles = {{0, 1, 2}};
    mesh->texcoords[0] = {{0, 0}, {1, 0}, {0, 1}};
    mesh->colours = {{1, 1, 1, 0.5f}, {1, 1, 1, 0.5f}, {1, 1, 1, 0.5f}};
    Coverage coverage = by_texture();
    const Scene scene = scene_with(std::shared_ptr<const Mesh>(mesh), coverage);
    EXPECT_NEAR(SceneOpacity(scene).at(0, 0, 0.1, 0.2), 0.2, kRounding);
    EXPECT_NEAR(SceneOpacity(scene).at(0, 0, 0.8, 0.1), 0.8, kRounding);

    coverage.vertex_alpha = true;
    const Scene with_vertices = scene_with(std::shared_ptr<const Mesh>(mesh), coverage);
    EXPECT_NEAR(SceneOpacity(with_vertices).at(0, 0, 0.8, 0.1), 0.4, kRounding);

    coverage.cutoff = 0.3;
    const Scene cut = scene_with(std::shared_ptr<const Mesh>(mesh), coverage);
    EXPECT_EQ(SceneOpacity(cut).at(0, 0, 0.1, 0.2), 0.0);
    EXPECT_EQ(SceneOpacity(cut).at(0, 0, 0.8, 0.1), 1.0);
}

}  // namespace
}  // namespace dewbow
