// SPDX-License-Identifier: Apache-2.0

// Materials of scene files whose inputs are pictures, and metals.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "dewbow/image/png.h"
#include "dewbow/import/toml/scene_toml.h"
#include "dewbow/optics/metal.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

/// Of a handful of multiplications in double.
constexpr double kRounding = 1e-12;

class TexturesTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_textures_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_ / "pictures");
        std::ofstream(folder_ / "pictures/wood.png", std::ios::binary)
            << encode_png({2, 1, {255, 0, 0, 0, 0, 255}}, {});
        std::ofstream(folder_ / "text.png") << "hello";
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The material with these lines.
    Material material(const std::string& lines) const {
        return parse_scene_toml(folder_ / "scene.toml", "[materials.a]\n" + lines)
            .scene.materials.at(0);
    }
    template <class Surface>
    Surface surface(const std::string& lines) const {
        return std::get<Surface>(material(lines).surface);
    }
    ColourInput reflectance(const std::string& value) const {
        return surface<Diffuse>("type = \"diffuse\"\nreflectance = " + value).reflectance;
    }
    std::string error(const std::string& lines) const {
        try {
            material(lines);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::filesystem::path folder_;
};

TEST_F(TexturesTest, ANameAloneIsAPicture) {
    const ColourInput colour = reflectance("\"pictures/wood.png\"");
    ASSERT_TRUE(colour.texture);
    EXPECT_EQ(colour.texture->coding, TextureCoding::srgb);
    EXPECT_TRUE(colour.texture->interpolates);
    EXPECT_EQ(colour.texture->wrap_u, TextureWrap::repeat);
    EXPECT_EQ(colour.factor[0], 1.0);
    const auto rough = surface<Dielectric>(
        "type = \"glass\"\nglass = \"N-BK7\"\nroughness = \"pictures/wood.png\"\n");
    ASSERT_TRUE(rough.roughness.texture);
    EXPECT_EQ(rough.roughness.texture->coding, TextureCoding::linear);
    EXPECT_EQ(rough.roughness.channel, 0);
}

TEST_F(TexturesTest, AllOptions) {
    const ColourInput colour = reflectance(
        "{ texture = \"pictures/wood.png\", factor = [0.5, 1, 0.25], wrap = [\"mirror\", "
        "\"clamp\"], filter = \"nearest\", coding = \"linear\", uv_scale = [2, 3], uv_offset = "
        "[0.25, 0.5], uv_rotate_deg = 90, uv_set = 1 }");
    EXPECT_EQ(colour.factor[2], 0.25);
    EXPECT_EQ(colour.texture->wrap_u, TextureWrap::mirror);
    EXPECT_EQ(colour.texture->wrap_v, TextureWrap::clamp);
    EXPECT_FALSE(colour.texture->interpolates);
    EXPECT_EQ(colour.texture->coding, TextureCoding::linear);
    EXPECT_EQ(colour.texture->texcoord_set, 1);
    // (u, v) = (0.1, 0.2) is scaled to (0.2, 0.6); KHR_texture_transform's matrix for 90 deg,
    // (cos, sin; -sin, cos), turns that to (0.6, -0.2); then it is moved.
    const auto& t = colour.texture->transform;
    EXPECT_NEAR(t[0][0] * 0.1 + t[0][1] * 0.2 + t[0][2], 0.85, kRounding);
    EXPECT_NEAR(t[1][0] * 0.1 + t[1][1] * 0.2 + t[1][2], 0.3, kRounding);
    EXPECT_EQ(reflectance("{ texture = \"pictures/wood.png\", factor = 0.5, uv_scale = 2 }")
                  .texture->transform[1][1],
              2.0);
}

TEST_F(TexturesTest, PicturesAreReadOnce) {
    const auto s = surface<MetallicRoughness>(
        "type = \"metallic-roughness\"\nbase_colour = \"pictures/wood.png\"\nmetalness = { texture "
        "= \"pictures/wood.png\", channel = \"b\", factor = 0.5 }\n");
    EXPECT_EQ(s.base_colour.texture->image, s.metalness.texture->image);
    EXPECT_EQ(s.metalness.channel, 2);
    EXPECT_EQ(s.metalness.value, 0.5);
}

TEST_F(TexturesTest, VertexColours) {
    const ColourInput colour = reflectance("{ vertex_colour = true, factor = 0.5 }");
    EXPECT_TRUE(colour.vertex_colour);
    EXPECT_FALSE(colour.texture);
    EXPECT_EQ(colour.factor[1], 0.5);
    EXPECT_TRUE(reflectance("{ vertex_colour = true, texture = \"pictures/wood.png\" }").texture);
}

TEST_F(TexturesTest, CoverageAndNormals) {
    const std::string grey = "type = \"diffuse\"\nreflectance = 0.5\n";
    EXPECT_FALSE(material(grey).coverage);
    const Material cut = material(grey + "alpha = \"pictures/wood.png\"\nalpha_cutoff = 0.25\n");
    ASSERT_TRUE(cut.coverage);
    EXPECT_EQ(cut.coverage->alpha.channel, 0);  // it has no alpha of its own
    EXPECT_EQ(cut.coverage->cutoff, 0.25);
    EXPECT_EQ(material(grey + "alpha = 0.3\n").coverage->alpha.value, 0.3);
    EXPECT_TRUE(material(grey + "vertex_alpha = true\n").coverage->vertex_alpha);
    EXPECT_EQ(material(grey + "normal_map = \"pictures/wood.png\"\n").normal_map->scale, 1.0);
    const Material bumpy =
        material(grey + "normal_map = { texture = \"pictures/wood.png\", scale = 0.5 }\n");
    EXPECT_EQ(bumpy.normal_map->scale, 0.5);
    EXPECT_EQ(bumpy.normal_map->texture->coding, TextureCoding::linear);
}

TEST_F(TexturesTest, LightFromAPicture) {
    const std::string head = "type = \"black\"\nemission = { texture = \"pictures/wood.png\", ";
    EXPECT_EQ(material(head + "scale = 5 }\n").emission_texture->factor[0], 5.0);
    EXPECT_EQ(material(head + "scale = 5, factor = [1, 0.5, 0] }\n").emission_texture->factor[1],
              2.5);
    // Its white has the luminance that is asked for: 683 lm/W times the integral of y times the
    // factor.
    const double factor = material(head + "luminance_cd_m2 = 300 }\n").emission_texture->factor[0];
    EXPECT_NEAR(factor * kLuminousEfficacy * 106.856917, 300.0, 1e-4);
}

TEST_F(TexturesTest, Metals) {
    const auto gold = surface<Conductor>("type = \"metal\"\nmetal = \"gold\"\nroughness = 0.2\n");
    EXPECT_EQ(gold.n, find_metal("gold").n);
    EXPECT_EQ(gold.roughness.value, 0.2);
    const auto own = surface<Conductor>(
        "type = \"metal\"\nn = 0.2\nk = { lambda_nm = [400, 700], values = [2, 4] }\n");
    EXPECT_NEAR((*own.k)(550 * unit::nm), 3.0, kRounding);
    EXPECT_EQ((*own.n)(550 * unit::nm), 0.2);
}

TEST_F(TexturesTest, LayersOfMetallicRoughness) {
    const auto s = surface<MetallicRoughness>(
        "type = \"metallic-roughness\"\nbase_colour = 0.5\nspecular = 0.6\nspecular_colour = "
        "0.7\nclearcoat = 0.8\nclearcoat_roughness = 0.1\nsheen_colour = 0.2\nsheen_roughness = "
        "0.9\n");
    EXPECT_EQ(s.specular.value, 0.6);
    EXPECT_TRUE(s.specular_colour);
    EXPECT_EQ(s.clearcoat.value, 0.8);
    EXPECT_EQ(s.clearcoat_roughness.value, 0.1);
    EXPECT_TRUE(s.sheen_colour);
    EXPECT_EQ(s.sheen_roughness.value, 0.9);
    const auto thin =
        surface<ThinDielectric>("type = \"thin-glass\"\nior = 1.5\nroughness = 0.3\n");
    EXPECT_EQ(thin.roughness.value, 0.3);
}

TEST_F(TexturesTest, ErrorsNameThePlaceAndTheWay) {
    const std::string diffuse = "type = \"diffuse\"\nreflectance = ";
    const std::string metal = "type = \"metal\"\n";
    const std::pair<std::string, const char*> wrong[] = {
        {diffuse + "\"gone.png\"", "scene.toml:3:15: "},
        {diffuse + "\"gone.png\"", "cannot read: No such file"},
        {diffuse + "\"text.png\"", "is neither a PNG nor a JPEG picture"},
        {diffuse + "\"../wood.png\"", "reference \"../wood.png\""},
        {diffuse + "{ texture = 3 }", "the name of a picture is the number 3; expected a string"},
        {diffuse + "{ texture = \"pictures/wood.png\", wrap = \"tile\" }", "unknown wrap \"tile\""},
        {diffuse + "{ texture = \"pictures/wood.png\", wrap = [\"clamp\"] }",
         "wrap is an array of 1; expected a word, or two"},
        {diffuse + "{ texture = \"pictures/wood.png\", filter = \"nearst\" }",
         "did you mean \"nearest\"?"},
        {diffuse + "{ texture = \"pictures/wood.png\", factor = 1.5 }",
         "factor is 1.5; it must be between 0 and 1"},
        {diffuse + "{ texture = \"pictures/wood.png\", chanel = \"r\" }",
         "unknown key \"chanel\" in the texture of reflectance"},
        {diffuse + "{ texture = \"pictures/wood.png\", uv_set = 2 }", "uv_set is 2"},
        {diffuse + "{ texture = \"pictures/wood.png\", uv_scale = [1] }",
         "uv_scale is an array of 1; expected an array of 2 numbers"},
        {diffuse + "{ vertex_colour = 1 }", "vertex_colour is the number 1; expected true"},
        {diffuse + "0.5\nalpha = 1.5", "alpha is 1.5; it must be between 0 and 1"},
        {diffuse + "0.5\nalpha_cutoff = -1", "alpha_cutoff is -1"},
        {diffuse + "0.5\nnormal_map = 3", "normal_map is the number 3; expected a table"},
        {metal, "[materials.a] needs metal"},
        {metal + "metal = \"gould\"", "gold"},
        {metal + "metal = \"gold\"\nn = 1", "has both metal and n"},
        {metal + "n = 1", "[materials.a] needs k"},
        {metal + "n = [1, 1, 1]\nk = 1", "n is no colour"},
        {"type = \"mix\"\nfirst = \"a\"\nsecond = \"a\"\nsecond_share = \"gone.png\"",
         "cannot read: No such file"},
    };
    for (const auto& [lines, phrase] : wrong)
        EXPECT_NE(error(lines).find(phrase), std::string::npos) << lines << "\n" << error(lines);
}

}  // namespace
}  // namespace dewbow
