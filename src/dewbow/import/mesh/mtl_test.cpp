// SPDX-License-Identifier: Apache-2.0

// What the materials of OBJ files become.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "dewbow/image/png.h"
#include "dewbow/import/mesh/mtl_material.h"
#include "dewbow/import/mesh/obj_scene.h"

namespace dewbow {
namespace {

/// Of a smooth reflectance at one wavelength, and of a dispersion formula read twice.
constexpr double kRounding = 1e-12;

class MtlTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_mtl_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
    }
    /// A picture of 2 × 1 texels.
    void write_picture(const std::string& name, std::vector<std::uint8_t> rgb) const {
        write(name, encode_png({2, 1, std::move(rgb)}, {}));
    }

    /// The scene of a triangle in the material "a" of a library with these lines.
    ParsedScene load(const std::string& lines) const {
        write("a.mtl", "newmtl a\n" + lines);
        write("a.obj",
              "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        return load_obj_scene(folder_ / "a.obj");
    }
    Material material(const std::string& lines) const {
        const ParsedScene parsed = load(lines);
        EXPECT_TRUE(parsed.diagnostics.empty()) << parsed.diagnostics[0].text;
        return parsed.scene.materials.at(0);
    }
    template <class Surface>
    Surface surface(const std::string& lines) const {
        return std::get<Surface>(material(lines).surface);
    }
    std::string note(const std::string& lines) const {
        const ParsedScene parsed = load(lines);
        std::string text;
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            text += to_string(diagnostic.place) + ": " + diagnostic.text + "\n";
        return text;
    }
    std::string error(const std::string& lines) const {
        try {
            load(lines);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::filesystem::path folder_;
};

double at(const SpectrumPtr& spectrum, double lambda_nm) {
    return (*spectrum)(lambda_nm * unit::nm);
}
double index_at(const Dielectric& glass, double lambda_nm) {
    return (*glass.interior->index)(lambda_nm * unit::nm).value;
}

TEST_F(MtlTest, DiffuseWithoutHighlights) {
    for (const char* lines :
         {"Kd 0.25 0.25 0.25\n", "Kd 0.25\nKs 0 0 0\nillum 2\n", "Kd 0.25\nKs 1 1 1\nillum 1\n"})
        EXPECT_NEAR(at(surface<Diffuse>(lines).reflectance.spectrum, 550), 0.25, kRounding);
}

TEST_F(MtlTest, HighlightsAreMicrofacets) {
    const auto s = surface<MetallicRoughness>("Kd 0.1\nKs 0.5\nNs 30\nNi 1.7\nillum 2\n");
    EXPECT_EQ(s.metalness.value, 0.0);
    EXPECT_EQ(s.ior, 1.7);
    // Ns = 30: alpha = sqrt(2/32) = 1/4, and roughness is its root.
    EXPECT_NEAR(s.roughness.value, 0.5, kRounding);
    EXPECT_NEAR(at(s.specular_colour.spectrum, 500), 0.5, kRounding);
    EXPECT_EQ(surface<MetallicRoughness>("Ks 1\nNi 1\n").ior, 1.5);
}

TEST(Mtl, RoughnessOfPhongsExponent) {
    EXPECT_NEAR(roughness_of_exponent(0.0), 1.0, kRounding);
    for (const double exponent : {1.0, 10.0, 100.0, 1e5}) {
        const double alpha = std::pow(roughness_of_exponent(exponent), 2.0);
        EXPECT_NEAR(2.0 / (alpha * alpha) - 2.0, exponent, 1e-9 * (1.0 + exponent));
    }
}

TEST_F(MtlTest, TransparentModelsAreBodies) {
    for (const char* model : {"4", "6", "7", "9"}) {
        const auto glass =
            surface<Dielectric>(std::string("Ni 1.5\nd 0.1\nNs 300\nillum ") + model + "\n");
        EXPECT_NEAR(index_at(glass, 589.3), 1.5 * 1.00027, 1e-5);  // against air
        EXPECT_NEAR(index_at(glass, 400), index_at(glass, 700), kRounding);
        EXPECT_TRUE(glass.roughness == 0.0);
        EXPECT_FALSE(glass.tint);
    }
    EXPECT_FALSE(material("Ni 1.5\nd 0.1\nillum 7\n").coverage);
    const auto tinted = surface<Dielectric>("Ni 1.5\nTf 0.5 0.5 0.5\nPr 0.3\nillum 6\n");
    EXPECT_NEAR(at(tinted.tint.spectrum, 600), 0.5, kRounding);
    EXPECT_EQ(tinted.roughness.value, 0.3);
    EXPECT_NO_THROW(surface<Diffuse>("Kd 0.5\nNi 1\nillum 4\n"));
}

TEST_F(MtlTest, AGlassOfTheCatalogueIsNamedInAComment) {
    for (const char* comment : {"# dewbow: glass schott/N-BK7\n", "#dewbow: glass N-BK7\n"}) {
        const auto glass = surface<Dielectric>(std::string("Kd 1 1 1\nillum 2\n") + comment);
        // Schott's n_d against air is 1.51680; Ciddor's air at d has 1.000272.
        EXPECT_NEAR(index_at(glass, 587.5618), 1.51680 * 1.000272, 1e-5);
        EXPECT_GT(index_at(glass, 400), index_at(glass, 700) + 0.01);
    }
    EXPECT_NE(error("# dewbow: glass N-BK8\n").find("a.mtl:2: "), std::string::npos);
    EXPECT_NE(error("# dewbow: glass N-BK8\n").find("N-BK7"), std::string::npos);
    EXPECT_NE(error("# dewbow: glas N-BK7\n").find("expected: # dewbow: glass NAME"),
              std::string::npos);
}

TEST_F(MtlTest, MirrorsAndTheirColour) {
    EXPECT_NEAR(at(surface<Mirror>("Kd 0\nKs 0.9\nillum 3\n").reflectance.spectrum, 500), 0.9,
                kRounding);
    EXPECT_NO_THROW(surface<MetallicRoughness>("Kd 0.1\nKs 0.9\nillum 3\n"));
}

TEST_F(MtlTest, PhysicallyBasedStatements) {
    const auto s = surface<MetallicRoughness>(
        "Kd 0.5\nKs 0.5\nPr 0.4\nPm 1\nPs 0.2\nPc 0.7\nPcr 0.1\nNi 1.45\n");
    EXPECT_EQ(s.roughness.value, 0.4);
    EXPECT_EQ(s.metalness.value, 1.0);
    EXPECT_EQ(s.clearcoat.value, 0.7);
    EXPECT_EQ(s.clearcoat_roughness.value, 0.1);
    EXPECT_NEAR(at(s.sheen_colour.spectrum, 500), 0.2, kRounding);
    EXPECT_FALSE(s.specular_colour);
    EXPECT_EQ(s.ior, 1.45);
    EXPECT_FALSE(surface<MetallicRoughness>("Pr 0.4\n").sheen_colour);
}

TEST_F(MtlTest, OpacityIsCoverage) {
    EXPECT_FALSE(material("Kd 1\n").coverage);
    EXPECT_FALSE(material("Kd 1\nd 1\n").coverage);
    EXPECT_EQ(material("Kd 1\nd 0.25\n").coverage->alpha.value, 0.25);
    EXPECT_EQ(material("Kd 1\nTr 0.25\n").coverage->alpha.value, 0.75);
    // Where both stand, d is right.
    EXPECT_FALSE(material("Kd 1\nTr 1\nd 1\n").coverage);
    EXPECT_FALSE(material("Kd 1\nd 1\nTr 1\n").coverage);
}

TEST_F(MtlTest, LightIsGivenOffOnBothSides) {
    const Material lamp = material("Ke 3 3 3\n");
    ASSERT_TRUE(lamp.emission);
    EXPECT_TRUE(lamp.two_sided_emission);
    EXPECT_FALSE(material("Ke 0 0 0\n").emission);
}

TEST_F(MtlTest, PicturesWithTheirOptions) {
    write_picture("my wood.png", {255, 0, 0, 0, 0, 255});
    const auto plain = surface<Diffuse>("map_Kd my wood.png\n").reflectance;
    ASSERT_TRUE(plain.texture);
    EXPECT_EQ(plain.factor[0], 1.0);  // no Kd: nothing but the picture
    EXPECT_EQ(plain.texture->image->width, 2);
    EXPECT_EQ(plain.texture->coding, TextureCoding::srgb);
    const auto scaled =
        surface<Diffuse>("Kd 0.5\nmap_Kd -s 2 4 1 -o 0.25 0.5 -clamp on my wood.png\n").reflectance;
    EXPECT_EQ(scaled.factor[1], 0.5);
    EXPECT_EQ(scaled.texture->wrap_v, TextureWrap::clamp);
    // A point with OBJ's (u, v) = (0.5, 0.125): MTL looks at (2·0.5 + 0.25, 4·0.125 + 0.5), where v
    // is up: ours are (0.5, 0.875) and (1.25, 0).
    const auto& t = scaled.texture->transform;
    EXPECT_NEAR(t[0][0] * 0.5 + t[0][1] * 0.875 + t[0][2], 1.25, kRounding);
    EXPECT_NEAR(t[1][0] * 0.5 + t[1][1] * 0.875 + t[1][2], 0.0, kRounding);
}

TEST_F(MtlTest, PicturesOfNumbers) {
    write_picture("grey.png", {255, 255, 255, 51, 51, 51});
    const auto s =
        surface<MetallicRoughness>("map_Pr -imfchan g grey.png\nmap_Pm grey.png\nPm 0.5\n");
    EXPECT_EQ(s.roughness.channel, 1);
    EXPECT_EQ(s.roughness.value, 1.0);
    EXPECT_EQ(s.metalness.value, 0.5);
    EXPECT_EQ(s.metalness.texture->coding, TextureCoding::linear);
    const Material cut = material("Kd 1\nmap_d grey.png\n");
    ASSERT_TRUE(cut.coverage);
    EXPECT_EQ(cut.coverage->alpha.channel, 0);  // its alpha says nothing
    const Material lamp = material("map_Ke grey.png\n");
    ASSERT_TRUE(lamp.emission_texture);
    EXPECT_EQ(lamp.emission_texture->factor[0], 1.0);
}

TEST_F(MtlTest, NormalMapsAndHeights) {
    write_picture("normal.png", {128, 128, 255, 100, 128, 250});
    write_picture("height.png", {128, 128, 128, 10, 10, 10});
    EXPECT_EQ(material("norm normal.png\n").normal_map->scale, 1.0);
    EXPECT_EQ(material("map_Bump -bm 0.5 normal.png\n").normal_map->scale, 0.5);
    EXPECT_NE(note("bump height.png\n").find("a.mtl:2: heights"), std::string::npos);
}

TEST_F(MtlTest, WhatCannotBeHadIsNotedAndGreyOrPlain) {
    EXPECT_NE(note("map_Kd gone.png\n").find("a.mtl:2: the picture \"gone.png\" is not used"),
              std::string::npos);
    EXPECT_NE(note("map_Kd C:\\art\\wood.png\n").find("the picture \"C:/art/wood.png\""),
              std::string::npos);
    write("text.png", "hello");
    EXPECT_NE(note("map_Kd text.png\n").find("is not used"), std::string::npos);
    EXPECT_EQ(note("Kd 2 0 0\nKd 3 0 0\n").find("Kd is 2; it must be between 0 and 1"),
              std::string((folder_ / "a.mtl").string() + ":2: ").size());
    EXPECT_NE(note("aniso 1\naniso 1\n").find("statements \"aniso\" are not used\n"),
              std::string::npos);
    EXPECT_NE(note("Kd spectral x.rfl\n").find("Kd as spectral is not used"), std::string::npos);
    EXPECT_EQ(note("Ka 1 1 1\n\n# a comment\n"), "");
}

TEST_F(MtlTest, MissingLibrariesAndMaterialsAreGrey) {
    write("b.obj", "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\n");
    const ParsedScene missing = load_obj_scene(folder_ / "b.obj");
    ASSERT_EQ(missing.diagnostics.size(), 2u);
    EXPECT_NE(missing.diagnostics[0].text.find("\"none.mtl\" is not read"), std::string::npos);
    EXPECT_EQ(missing.diagnostics[0].place.line, 1u);
    EXPECT_EQ(missing.diagnostics[1].text, "no library holds the material \"x\": it is grey");
    EXPECT_EQ(missing.scene.materials.at(0).name, kDefaultMaterial);
    write("c.mtl", "newmtl steel\nKd 1\n");
    write("c.obj", "mtllib c.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl steal\nf 1 2 3\n");
    EXPECT_NE(load_obj_scene(folder_ / "c.obj").diagnostics.at(0).text.find("\"steel\""),
              std::string::npos);
}

TEST_F(MtlTest, ErrorsNameTheLine) {
    const std::pair<const char*, const char*> wrong[] = {
        {"Kd red\n", "a.mtl:2: \"red\" is no number"},
        {"Kd 1 2\n", "\"Kd\" needs one or three numbers"},
        {"Ns\n", "\"Ns\" needs a number"},
        {"Ns nan\n", "\"nan\" is no number"},
        {"map_Kd -s\n", "the option -s needs a value"},
        {"map_Kd -bm 1\n", "\"map_Kd\" needs the name of a file"},
        {"newmtl\n", "\"newmtl\" needs a name"},
    };
    for (const auto& [lines, phrase] : wrong)
        EXPECT_NE(error(lines).find(phrase), std::string::npos) << error(lines);
    Diagnostics diagnostics;
    EXPECT_THROW(parse_mtl("x.mtl", "Kd 1 1 1\n", diagnostics), InputError);
    EXPECT_THROW(parse_mtl("x.mtl", std::string("a\0b", 3), diagnostics), InputError);
}

TEST_F(MtlTest, VertexColoursShowWhereThereIsNoMaterial) {
    write("d.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    const Scene scene = load_obj_scene(folder_ / "d.obj").scene;
    EXPECT_TRUE(std::get<Diffuse>(scene.materials.at(0).surface).reflectance.vertex_colour);
}

}  // namespace
}  // namespace dewbow
