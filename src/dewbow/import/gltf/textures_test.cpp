// SPDX-License-Identifier: Apache-2.0

// What glTF's textures become, and what materials make of them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dewbow/image/png.h"
#include "dewbow/import/gltf/test_document.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/display.h"

namespace dewbow {
namespace {

using namespace gltf_test;

constexpr double kRounding = 1e-12;
/// make_emission has its luminance to three digits.
constexpr double kLuminanceError = 1e-3;

/// Two by two: black, red above; green, (51, 102, 153) below.
const std::string kPicture = encode_png({2, 2, {0, 0, 0, 255, 0, 0, 0, 255, 0, 51, 102, 153}}, {});

/// A document whose texture 0 is that picture.
Parts with_picture(const std::string& material, const std::string& texture = R"("source": 0)",
                   const std::string& sampler = "") {
    Parts parts;
    parts.materials = R"([{"name": "m", )" + material + "}]";
    parts.rest = R"(, "textures": [{)" + texture + R"(}], "samplers": [{)" + sampler +
                 R"(}], "images": [{"uri": ")" + data_uri(kPicture) + R"("}])";
    return parts;
}

const Material& material_of(const ParsedScene& parsed, std::size_t shape = 0) {
    return parsed.scene.materials[std::size_t(parsed.scene.shapes.at(shape).material)];
}

template <class Surface>
const Surface& surface_of(const ParsedScene& parsed) {
    return std::get<Surface>(material_of(parsed).surface);
}

const char* const kBaseColour = R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})";

TEST(GltfTextures, BaseColourIsSrgbTimesItsFactor) {
    const ParsedScene parsed = parse(with_picture(
        R"("pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 1, 1], "baseColorTexture": {"index": 0}})"));
    const ColourInput& colour = surface_of<MetallicRoughness>(parsed).base_colour;
    ASSERT_TRUE(colour.texture);
    EXPECT_EQ(colour.factor.v, (std::array<double, 3>{0.5, 0.25, 1.0}));
    EXPECT_FALSE(colour.vertex_colour);
    EXPECT_EQ(colour.texture->coding, TextureCoding::srgb);
    EXPECT_EQ(colour.texture->texcoord_set, 0);
    const auto texel = colour.texture->eval({0.75, 0.75});
    EXPECT_NEAR(texel[0], srgb_decode(0.2), kRounding);
    EXPECT_NEAR(texel[2], srgb_decode(0.6), kRounding);
    EXPECT_TRUE(parsed.diagnostics.empty());
    EXPECT_FALSE(material_of(parsed).coverage);
}

TEST(GltfTextures, MetalnessIsBlueAndRoughnessGreen) {
    const ParsedScene parsed = parse(with_picture(
        R"("pbrMetallicRoughness": {"metallicFactor": 0.5, "metallicRoughnessTexture": {"index": 0}})"));
    const auto& surface = surface_of<MetallicRoughness>(parsed);
    EXPECT_EQ(surface.metalness.value, 0.5);
    EXPECT_EQ(surface.metalness.channel, 2);
    EXPECT_EQ(surface.roughness.value, 1.0);
    EXPECT_EQ(surface.roughness.channel, 1);
    EXPECT_EQ(surface.roughness.texture->coding, TextureCoding::linear);
    EXPECT_NEAR(surface.roughness.texture->eval({0.75, 0.75})[1], 0.4, kRounding);
}

TEST(GltfTextures, SamplersWrapAndFilter) {
    const auto texture_of = [](const char* sampler) {
        const auto parsed =
            parse(with_picture(kBaseColour, R"("source": 0, "sampler": 0)", sampler));
        return *surface_of<MetallicRoughness>(parsed).base_colour.texture;
    };
    const Texture plain = texture_of("");
    EXPECT_EQ(plain.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(plain.wrap_v, TextureWrap::repeat);
    EXPECT_TRUE(plain.interpolates);
    const Texture other = texture_of(R"("wrapS": 33071, "wrapT": 33648, "magFilter": 9728)");
    EXPECT_EQ(other.wrap_u, TextureWrap::clamp);
    EXPECT_EQ(other.wrap_v, TextureWrap::mirror);
    EXPECT_FALSE(other.interpolates);
}

/// The specification's own example: the lower left quadrant, turned clockwise by 90 deg.
TEST(GltfTextures, TransformsAreScaledThenTurnedThenMoved) {
    const ParsedScene parsed = parse(with_picture(
        R"("pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 0, "extensions":
           {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1.57079632679489662, "scale": [0.5, 0.5], "texCoord": 1}}}})"));
    const Texture& texture = *surface_of<MetallicRoughness>(parsed).base_colour.texture;
    EXPECT_EQ(texture.texcoord_set, 1);
    const auto image_of = [&](double u, double v) {
        const auto& t = texture.transform;
        return std::array{t[0][0] * u + t[0][1] * v + t[0][2], t[1][0] * u + t[1][1] * v + t[1][2]};
    };
    // Corners of the surface in clockwise order from the upper left, and the picture's.
    const double corners[][4] = {{0, 0, 0, 1}, {1, 0, 0, 0.5}, {1, 1, 0.5, 0.5}, {0, 1, 0.5, 1}};
    for (const auto& [u, v, x, y] : corners) {
        EXPECT_NEAR(image_of(u, v)[0], x, kRounding) << u << " " << v;
        EXPECT_NEAR(image_of(u, v)[1], y, kRounding) << u << " " << v;
    }
}

TEST(GltfTextures, EmissionIsInNits) {
    const ParsedScene parsed = parse(with_picture(
        R"("emissiveFactor": [1, 0.5, 0], "emissiveTexture": {"index": 0}, "extensions":
           {"KHR_materials_emissive_strength": {"emissiveStrength": 40}})"));
    const Material& material = material_of(parsed);
    EXPECT_EQ(material.emission, nullptr);
    ASSERT_TRUE(material.emission_texture);
    EXPECT_TRUE(material.two_sided_emission);
    // (1, 1, 1) of an emission texture has 683.002 lm/W times 106.857 nm. [CIE 1931, 360-830 nm]
    const auto factor = material.emission_texture->factor.v;
    EXPECT_NEAR(factor[0] * 683.002 * 106.857, 40.0, 40.0 * 1e-5);
    EXPECT_NEAR(factor[1], 0.5 * factor[0], kRounding);
    EXPECT_EQ(factor[2], 0.0);
}

TEST(GltfTextures, ABlackFactorNeedsNoTexture) {
    const ParsedScene parsed = parse(with_picture(R"("emissiveTexture": {"index": 0})"));
    EXPECT_FALSE(material_of(parsed).gives_light());
}

TEST(GltfTextures, NormalMapsHaveAScale) {
    const ParsedScene parsed =
        parse(with_picture(R"("normalTexture": {"index": 0, "scale": -0.5})"));
    const auto& map = material_of(parsed).normal_map;
    ASSERT_TRUE(map);
    EXPECT_EQ(map->scale, -0.5);
    EXPECT_EQ(map->texture->coding, TextureCoding::linear);
}

TEST(GltfTextures, AlphaCoversInPart) {
    const auto coverage_of = [](const char* members) {
        return material_of(parse(with_picture(
                               std::string(members) +
                               R"(, "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.75],
                                  "baseColorTexture": {"index": 0}})")))
            .coverage;
    };
    const auto blend = coverage_of(R"("alphaMode": "BLEND")");
    ASSERT_TRUE(blend);
    EXPECT_EQ(blend->alpha.value, 0.75);
    EXPECT_EQ(blend->alpha.channel, 3);
    EXPECT_TRUE(blend->alpha.texture);
    EXPECT_FALSE(blend->cutoff);
    EXPECT_EQ(coverage_of(R"("alphaMode": "MASK")")->cutoff, 0.5);
    EXPECT_EQ(coverage_of(R"("alphaMode": "MASK", "alphaCutoff": 0.1)")->cutoff, 0.1);
    EXPECT_FALSE(coverage_of(R"("alphaMode": "OPAQUE")"));
}

TEST(GltfTextures, TransmissionIsTheShareOfGlass) {
    const ParsedScene parsed = parse(with_picture(
        R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}},
           "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75, "transmissionTexture": {"index": 0}}})"));
    const auto& mix = surface_of<Mix>(parsed);
    EXPECT_EQ(mix.second_share.value, 0.75);
    EXPECT_EQ(mix.second_share.channel, 0);
    ASSERT_TRUE(mix.second_share.texture);
    EXPECT_EQ(mix.second_share.texture->coding, TextureCoding::linear);
    const auto& glass =
        std::get<ThinDielectric>(parsed.scene.materials[std::size_t(mix.second)].surface);
    EXPECT_EQ(glass.roughness, 0.5);
    EXPECT_TRUE(glass.tint.texture);
}

TEST(GltfTextures, AMetalThatATextureSharesOutIsAMixOfItsOwn) {
    const ParsedScene parsed = parse(with_picture(
        R"("pbrMetallicRoughness": {"metallicRoughnessTexture": {"index": 0}},
           "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.75}})"));
    const auto& materials = parsed.scene.materials;
    const auto& outer = surface_of<Mix>(parsed);
    EXPECT_EQ(outer.second_share.channel, 2);
    EXPECT_EQ(
        std::get<MetallicRoughness>(materials[std::size_t(outer.second)].surface).metalness.value,
        1.0);
    const auto& inner = std::get<Mix>(materials[std::size_t(outer.first)].surface);
    EXPECT_EQ(inner.second_share, 0.75);
    EXPECT_EQ(
        std::get<MetallicRoughness>(materials[std::size_t(inner.first)].surface).metalness.value,
        0.0);
    EXPECT_EQ(material_of(parsed).name, "m");
}

TEST(GltfTextures, LayersHaveTheirChannels) {
    const ParsedScene parsed = parse(with_picture(R"("extensions": {
        "KHR_materials_specular": {"specularFactor": 0.5, "specularTexture": {"index": 0},
            "specularColorFactor": [0.1, 0.2, 0.3], "specularColorTexture": {"index": 0}},
        "KHR_materials_clearcoat": {"clearcoatFactor": 0.6, "clearcoatTexture": {"index": 0},
            "clearcoatRoughnessFactor": 0.7, "clearcoatRoughnessTexture": {"index": 0},
            "clearcoatNormalTexture": {"index": 0}},
        "KHR_materials_sheen": {"sheenColorFactor": [0.4, 0.5, 0.6], "sheenColorTexture": {"index": 0},
            "sheenRoughnessFactor": 0.8, "sheenRoughnessTexture": {"index": 0}}})"));
    const auto& s = surface_of<MetallicRoughness>(parsed);
    struct Row {
        NumberInput input;
        double value;
        int channel;
    };
    for (const Row& row : {Row{s.specular, 0.5, 3}, Row{s.clearcoat, 0.6, 0},
                           Row{s.clearcoat_roughness, 0.7, 1}, Row{s.sheen_roughness, 0.8, 3}}) {
        EXPECT_EQ(row.input.value, row.value);
        EXPECT_EQ(row.input.channel, row.channel);
        EXPECT_TRUE(row.input.texture);
    }
    EXPECT_EQ(s.specular_colour.factor.v, (std::array<double, 3>{0.1, 0.2, 0.3}));
    EXPECT_EQ(s.sheen_colour.factor.v, (std::array<double, 3>{0.4, 0.5, 0.6}));
    EXPECT_EQ(s.specular_colour.texture->coding, TextureCoding::srgb);
    EXPECT_EQ(s.sheen_colour.texture->coding, TextureCoding::srgb);
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "the clearcoat normal texture of material \"m\" is not used");
}

TEST(GltfTextures, LayersThatDoNothingAreEmpty) {
    const ParsedScene parsed = parse(with_picture(R"("extensions": {"KHR_materials_specular": {},
        "KHR_materials_clearcoat": {}, "KHR_materials_sheen": {}})"));
    const auto& s = surface_of<MetallicRoughness>(parsed);
    EXPECT_EQ(s.specular, 1.0);
    EXPECT_FALSE(s.specular_colour);
    EXPECT_EQ(s.clearcoat, 0.0);
    EXPECT_FALSE(s.sheen_colour);
}

TEST(GltfTextures, UnlitShowsItsBaseColour) {
    const ParsedScene textured = parse(with_picture(
        R"("extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})"));
    EXPECT_TRUE(std::holds_alternative<Black>(material_of(textured).surface));
    EXPECT_TRUE(material_of(textured).emission_texture);
    const ParsedScene plain = parse(with_picture(
        R"("extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1]})"));
    // Half as bright as the film's white of 1 cd/m².
    EXPECT_NEAR(kLuminousEfficacy * xyz_from_spectrum(*material_of(plain).emission)[1], 0.5,
                kLuminanceError);
}

TEST(GltfTextures, ColoursOfVerticesMultiplyTheBaseColourWhereThereAreSome) {
    Buffer buffer;
    const int colours = buffer.add(bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 1}), "5126", 3, "VEC3");
    Parts parts = buffer.parts(R"("POSITION": 0, "COLOR_0": )" + std::to_string(colours));
    parts.primitive += R"(, {"attributes": {"POSITION": 0}, "material": 0})";
    parts.materials = R"([{"name": "m", "alphaMode": "BLEND"}])";
    const ParsedScene parsed = parse(parts);
    const Material &with = material_of(parsed, 0), &without = material_of(parsed, 1);
    EXPECT_TRUE(std::get<MetallicRoughness>(with.surface).base_colour.vertex_colour);
    EXPECT_TRUE(with.coverage->vertex_alpha);
    EXPECT_FALSE(std::get<MetallicRoughness>(without.surface).base_colour.vertex_colour);
    EXPECT_FALSE(without.coverage->vertex_alpha);
}

// ---- where pictures are ------------------------------------------------------------------------

TEST(GltfPictures, ATexturesPictureIsReadOnce) {
    const ParsedScene parsed = parse(with_picture(
        R"("normalTexture": {"index": 0}, "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})"));
    EXPECT_EQ(surface_of<MetallicRoughness>(parsed).base_colour.texture->image,
              material_of(parsed).normal_map->texture->image);
}

TEST(GltfPictures, ComeFromBufferViews) {
    Buffer buffer;
    const int view = buffer.view(kPicture);
    Parts parts = buffer.parts(R"("POSITION": 0)");
    parts.materials = R"([{"normalTexture": {"index": 0}}])";
    parts.rest =
        R"(, "textures": [{"source": 0}], "images": [{"mimeType": "image/png", "bufferView": )" +
        std::to_string(view) + "}]";
    EXPECT_EQ(material_of(parse(parts)).normal_map->texture->image->width, 2);
}

TEST(GltfPictures, ComeFromFilesBesideTheScene) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "dewbow_gltf_pictures";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "my picture.png", std::ios::binary) << kPicture;
    Parts parts = with_picture(R"("normalTexture": {"index": 0})");
    parts.rest = R"(, "textures": [{"source": 0}], "images": [{"uri": "my%20picture.png"}])";
    const ParsedScene parsed = parse_gltf(folder / "scene.gltf", text_of(parts));
    EXPECT_EQ(material_of(parsed).normal_map->texture->image->name, "my%20picture.png");
    std::filesystem::remove_all(folder);
}

TEST(GltfPictures, ThoseThatAreNotReadHaveAFallback) {
    const ParsedScene parsed =
        parse(with_picture(R"("normalTexture": {"index": 0})",
                           R"("source": 0, "extensions": {"KHR_texture_basisu": {"source": 7}})"));
    EXPECT_TRUE(material_of(parsed).normal_map);
    EXPECT_TRUE(parsed.diagnostics.empty());
}

TEST(GltfPictures, ThoseThatAreNotReadAreNamed) {
    struct Row {
        const char *texture, *text;
    };
    const Row rows[] = {
        {R"("extensions": {"EXT_texture_webp": {"source": 0}})",
         "the normal texture of material \"m\" is not used: a WebP picture is not read"},
        {"", "the normal texture of material \"m\" is not used: it has no picture"},
    };
    for (const Row& row : rows) {
        const ParsedScene parsed =
            parse(with_picture(R"("normalTexture": {"index": 0})", row.texture));
        EXPECT_FALSE(material_of(parsed).normal_map);
        ASSERT_EQ(parsed.diagnostics.size(), 1u);
        EXPECT_EQ(parsed.diagnostics[0].text, row.text);
    }
    Parts webp = with_picture(R"("normalTexture": {"index": 0})");
    webp.rest = R"(, "textures": [{"source": 0}], "images": [{"uri": ")" +
                data_uri(std::string("RIFF\x10\0\0\0WEBPVP8 ", 16)) + R"("}])";
    ASSERT_EQ(parse(webp).diagnostics.size(), 1u);
    EXPECT_EQ(parse(webp).diagnostics[0].text, rows[0].text);
}

TEST(GltfPictures, CoordinatesBeyondTheSecondSetAreNoted) {
    const ParsedScene parsed =
        parse(with_picture(R"("normalTexture": {"index": 0, "texCoord": 2})"));
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "the normal texture of material \"m\" is not used: it is laid on by TEXCOORD_2");
}

struct Wrong {
    const char *material, *textures, *images, *phrase;
};

TEST(GltfPictures, WrongOnesAreErrorsWithTheirPlace) {
    const std::string truncated = data_uri(kPicture.substr(0, kPicture.size() / 2));
    const std::string damaged = R"([{"uri": ")" + truncated + R"("}])";
    const Wrong rows[] = {
        {R"("normalTexture": {"index": 1})", R"([{"source": 0}])", "[]",
         "/materials/0/normalTexture/index: is 1"},
        {R"("normalTexture": {})", R"([{"source": 0}])", "[]",
         "/materials/0/normalTexture: needs \"index\""},
        {R"("normalTexture": {"index": 0})", R"([{"source": 3}])", R"([{"uri": "a.png"}])",
         "/textures/0/source: is 3"},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", R"([{"uri": "gone.png"}])",
         "/images/0/uri: "},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", R"([{"uri": "../a.png"}])",
         "/images/0/uri: "},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", R"([{"bufferView": 99}])",
         "/images/0/bufferView: is 99"},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", R"([{"name": "x"}])",
         "/images/0: needs \"bufferView\""},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", R"([{"bufferView": 0}])",
         "is neither a PNG nor a JPEG picture"},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0}])", damaged.c_str(),
         "this PNG file cannot be read"},
        {R"("normalTexture": {"index": 0, "extensions": {"KHR_texture_transform": {"offset": [0]}}})",
         R"([{"source": 0}])", "[]", "KHR_texture_transform/offset: is an array of 1"},
        {R"("normalTexture": {"index": 0})", R"([{"source": 0, "sampler": 5}])", "[]",
         "/textures/0/sampler: "},
        {R"("alphaMode": "CUT")", "[]", "[]",
         "/materials/0/alphaMode: \"CUT\" is no mode of alpha"},
    };
    for (const Wrong& row : rows) {
        Parts parts;
        parts.materials = "[{" + std::string(row.material) + "}]";
        parts.rest =
            R"(, "textures": )" + std::string(row.textures) + R"(, "images": )" + row.images;
        const std::string message = error_of(parts);
        EXPECT_NE(message.find(row.phrase), std::string::npos) << row.phrase << "\nis not in\n"
                                                               << message;
    }
}

}  // namespace
}  // namespace dewbow
