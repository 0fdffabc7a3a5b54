// SPDX-License-Identifier: Apache-2.0

// What pictures do to surfaces, through the path tracer, against closed forms.

#include <gtest/gtest.h>

#include "scene_kit.h"
#include "statistics.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr double kRounding = 1e-7;
/// Two-sided 1e-8 for one z.
constexpr double kSigmas = 5.73;

using Rgba = std::array<std::uint8_t, 4>;

/// Four texels, linear: the upper row first. Nearest, so that each fills a quarter of a rectangle.
std::shared_ptr<Texture> quarters(Rgba a, Rgba b, Rgba c, Rgba d) {
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 2;
    for (const Rgba& texel : {a, b, c, d})
        image->texels8.insert(image->texels8.end(), texel.begin(), texel.end());
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    texture->coding = TextureCoding::linear;
    texture->interpolates = false;
    return texture;
}
Rgba grey(int value) {
    const auto v = std::uint8_t(value);
    return {v, v, v, 255};
}
TexturePtr four_greys() { return quarters(grey(51), grey(102), grey(153), grey(204)); }

/// Centres of the four quarters of a rectangle of 2 m in z = 0, as the picture shows them.
const std::array<Vec3, 4> kQuarters{Vec3{-0.5, 0.5, 0}, Vec3{0.5, 0.5, 0}, Vec3{-0.5, -0.5, 0},
                                    Vec3{0.5, -0.5, 0}};

std::shared_ptr<Mesh> square_mesh() {
    auto result = std::make_shared<Mesh>(
        *mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}));
    result->texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    return result;
}

MeanSums radiance(const Scene& scene, const Ray& ray, std::size_t samples, int packet = 8) {
    const PreparedScene prepared(scene);
    MeanSums sums;
    for (std::size_t i = 0; i < samples; ++i) {
        const SampleKey key = independent_key(11, i);
        const PixelSample sample = trace_sample(prepared, ray, {}, packet_of(key, packet), key);
        double mean = 0.0;
        for (int k = 0; k < packet; ++k) mean += sample.radiance[std::size_t(k)] / packet;
        sums.add(mean);
    }
    return sums;
}
/// Straight down onto `point` of z = 0, from half a metre.
Ray down(Vec3 point) { return {point + Vec3{0, 0, 0.5}, {0, 0, -1}, {}}; }

Material textured(TexturePtr texture) {
    ColourInput colour;
    colour.texture = std::move(texture);
    return {"textured", Diffuse{colour}};
}

/// Parallel light of irradiance π that falls straight on a surface of reflectance ρ gives it
/// radiance ρ.
TEST(TexturedSurface, ShowsThePicture) {
    const Rectangle rectangle{2.0 * m, 2.0 * m};
    for (const Geometry& geometry :
         {Geometry(rectangle), Geometry(std::shared_ptr<const Mesh>(square_mesh()))}) {
        Scene scene = empty_scene();
        scene.lights.push_back(DistantLight{{{0, 0, -1}}, 0.0 * deg, make_constant(kPi)});
        add(scene, geometry, textured(four_greys()));
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(radiance(scene, down(kQuarters[i]), 20).mean(), 0.2 * double(i + 1),
                        kRounding)
                << i;
    }
}

TEST(TexturedSurface, TintsWhatGoesThrough) {
    Scene scene = furnace_scene();
    ColourInput tint;
    tint.texture = four_greys();
    // A pane of index 1 reflects nothing.
    add(scene, Rectangle{2.0 * m, 2.0 * m}, {"pane", ThinDielectric{vacuum(), tint}});
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(radiance(scene, down(kQuarters[i]), 20).mean(), 0.2 * double(i + 1), kRounding);
}

/// A body whose lanes part before they meet its tinted far side.
TEST(TexturedSurface, TintsOpenedLanesEachWhereItIs) {
    Scene scene = furnace_scene();
    ColourInput tint;
    tint.texture = quarters(grey(128), grey(128), grey(128), grey(128));
    const Material plain_tint{"plain",
                              Dielectric{glass("schott/SF66"), 0.0, make_constant(128.0 / 255.0)}};
    Material by_picture = plain_tint;
    std::get<Dielectric>(by_picture.surface).tint = tint;
    const Vec3 direction = normalised({0.3, -0.2, -1.0});
    const Ray ray{{0.1, 0.1, 2.0}, direction, {}};
    Scene other = scene;
    add(scene, Box{1.0 * m, 1.0 * m, 1.0 * m}, plain_tint);
    add(other, Box{1.0 * m, 1.0 * m, 1.0 * m}, by_picture);
    EXPECT_NEAR(radiance(scene, ray, 500).mean(), radiance(other, ray, 500).mean(), kRounding);
}

TEST(TexturedSurface, MixesByThePicture) {
    Scene scene = furnace_scene();
    scene.render.max_depth = 1;
    Mix mix;
    mix.first = scene.add(diffuse(0.0));
    mix.second = scene.add(diffuse(1.0));
    mix.second_share = 1.0;
    mix.second_share.texture = four_greys();
    add(scene, Rectangle{2.0 * m, 2.0 * m}, {"mix", mix});
    for (std::size_t i = 0; i < 4; ++i) {
        const MeanSums found = radiance(scene, down(kQuarters[i]), 20000);
        EXPECT_NEAR(found.mean(), 0.2 * double(i + 1), kSigmas * found.standard_error());
        EXPECT_LT(found.standard_error(), 0.005);
    }
}

TEST(TexturedSurface, CoverageLetsTheRestThrough) {
    Scene scene = furnace_scene(3.0);
    Material veil = lamp(0.0);
    veil.coverage = Coverage{};
    veil.coverage->alpha.texture = four_greys();
    add(scene, Rectangle{2.0 * m, 2.0 * m}, veil);
    for (std::size_t i = 0; i < 4; ++i) {
        // Slightly different rays: each has its own answer.
        MeanSums sums;
        const PreparedScene prepared(scene);
        for (std::size_t n = 0; n < 20000; ++n) {
            const SampleKey key = independent_key(12, n);
            const auto aside = test_numbers(key, 0);
            const Ray ray =
                down(kQuarters[i] + Vec3{0.4 * (aside[0] - 0.5), 0.4 * (aside[1] - 0.5), 0});
            sums.add(trace_sample(prepared, ray, {}, packet_of(key, 1), key).radiance[0]);
        }
        EXPECT_NEAR(sums.mean(), 3.0 * (1.0 - 0.2 * double(i + 1)),
                    kSigmas * sums.standard_error());
    }
}

/// Parallel light straight down; a texel that tilts the normal by 30 deg to the right or up.
TEST(TexturedSurface, ANormalMapTurnsTheSurface) {
    const auto code = [](double x) { return std::uint8_t(std::lround(127.5 * (x + 1.0))); };
    const double s = std::sin(30.0 * kPi / 180.0), c = std::cos(30.0 * kPi / 180.0);
    const Rgba right{code(s), code(0), code(c), 255}, up{code(0), code(s), code(c), 255};
    const Rgba none{code(0), code(0), code(1), 255};
    /// 8 bits hold a component to 1/255; the cosine changes by less than that.
    constexpr double kEightBits = 0.006;
    const Rectangle rectangle{2.0 * m, 2.0 * m};
    for (const Geometry& geometry :
         {Geometry(rectangle), Geometry(std::shared_ptr<const Mesh>(square_mesh()))}) {
        Scene scene = empty_scene();
        Material material = diffuse(0.5);
        material.normal_map = NormalMap{quarters(right, up, none, none), 1.0};
        add(scene, geometry, material);
        // From the right at 40 deg: the tilt of the left upper quarter faces it better.
        const double angle = 40.0 * kPi / 180.0;
        scene.lights.push_back(
            DistantLight{{{-std::sin(angle), 0, -std::cos(angle)}}, 0.0 * deg, make_constant(1.0)});
        const double plain = 0.5 / kPi * std::cos(angle);
        EXPECT_NEAR(radiance(scene, down(kQuarters[0]), 4).mean(),
                    0.5 / kPi * std::cos(angle - 30.0 * kPi / 180.0), kEightBits);
        EXPECT_NEAR(radiance(scene, down(kQuarters[1]), 4).mean(), plain * c, kEightBits);
        EXPECT_NEAR(radiance(scene, down(kQuarters[2]), 4).mean(), plain, kEightBits);
        // Nothing of the tilt is left at scale 0.
        scene.materials.back().normal_map->scale = 0.0;
        EXPECT_NEAR(radiance(scene, down(kQuarters[0]), 4).mean(), plain, kRounding);
    }
}

}  // namespace
}  // namespace dewbow
