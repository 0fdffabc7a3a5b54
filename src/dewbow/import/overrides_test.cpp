// SPDX-License-Identifier: Apache-2.0

// What the command line changes in scenes of any format.

#include "dewbow/import/overrides.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "dewbow/image/hdr.h"
#include "dewbow/import/gltf/test_document.h"
#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

/// Of a formula that is read twice.
constexpr double kRounding = 1e-12;

const char* const kPrisms =
    "[film]\nwidth = 10\n"
    "[materials.flint]\ntype = \"glass\"\nglass = \"SF10\"\nroughness = 0.25\ntint = 0.5\n"
    "absorption_per_m = 2\npriority = 3\n"
    "[materials.paper]\ntype = \"diffuse\"\nreflectance = 0.5\nalpha = 0.5\n"
    "[[shapes]]\ntype = \"prism\"\nmaterial = \"flint\"\napex_deg = 60\nside_cm = 4\nlength_cm = "
    "8\n"
    "[[shapes]]\ntype = \"sphere\"\nname = \"ball\"\nmaterial = \"paper\"\nradius_m = 1\n";

class OverridesTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_overrides_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
        write("scene.toml", kPrisms);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }

    Scene with(const LoadOptions& options, const std::string& file = "scene.toml") const {
        return load_scene(folder_ / file, options).scene;
    }
    Scene set(std::vector<std::string> settings, const std::string& file = "scene.toml") const {
        return with({.settings = std::move(settings)}, file);
    }
    /// The message; empty unless it is a UsageError.
    std::string usage_error(const LoadOptions& options, const std::string& file = "scene.toml") {
        try {
            with(options, file);
        } catch (const UsageError& error) {
            return error.what();
        } catch (const InputError& error) {
            return std::string("no UsageError: ") + error.what();
        }
        return {};
    }

    std::filesystem::path folder_;
};

double index_at_d(const Scene& scene, std::size_t material) {
    const auto& glass = std::get<Dielectric>(scene.materials.at(material).surface);
    return (*glass.interior->index)(kLined).value;
}

// ---- --set -------------------------------------------------------------------------------------

TEST_F(OverridesTest, ValuesAreSetByTheirPath) {
    const Scene scene = set({"film.width=400", "render.seed=7", "materials.flint.glass=\"N-BK7\"",
                             "shapes.1.apex_deg=45", "shapes.ball.radius_m=2",
                             "materials.\"paper\".reflectance = 0.25"});
    EXPECT_EQ(scene.film.width, 400);
    EXPECT_EQ(scene.render.seed, 7u);
    EXPECT_NEAR(index_at_d(scene, 0), 1.51680 * 1.000272, 1e-5);
    EXPECT_NEAR(std::get<Prism>(scene.shapes[0].geometry).apex.to(unit::deg), 45.0, kRounding);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[1].geometry).radius.to(unit::m), 2.0);
    EXPECT_EQ(scene.shapes.size(), 2u);
}

TEST_F(OverridesTest, TheLastOfEqualSettingsCounts) {
    EXPECT_EQ(set({"film.width=400", "film.width=500"}).film.width, 500);
}

TEST_F(OverridesTest, TablesAndEntriesAreMadeWhereThereAreNone) {
    const Scene scene =
        set({"camera.position=[0, 0, 9]", "camera.look_at=[0, 0, 0]",
             "lights.1.type=\"environment\"", "lights.1.radiance=2", "lights.2={type=\"studio\"}"});
    EXPECT_EQ(scene.camera.name, "camera");
    EXPECT_EQ(scene.lights.size(), 2u);
}

TEST_F(OverridesTest, OtherFormatsActAsIfImported) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene =
        set({"film.width=77", "imports.1.scale=0.001", "lights.1.type=\"studio\""}, "a.obj");
    EXPECT_EQ(scene.film.width, 77);
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_NEAR(bounds_of(scene).high.x, 0.001, kRounding);
    EXPECT_EQ(scene.lights.size(), 1u);
}

TEST_F(OverridesTest, SettingsOfAGltfLeaveTheRestAsItWas) {
    write("a.gltf", gltf_test::text_of({}));
    const Scene plain = with({}, "a.gltf"), set_one = set({"render.seed=5"}, "a.gltf");
    EXPECT_EQ(set_one.render.seed, 5u);
    EXPECT_EQ(set_one.film.white_luminance, plain.film.white_luminance);
    EXPECT_EQ(set_one.film.exposure, plain.film.exposure);
    EXPECT_EQ(set_one.shapes.size(), plain.shapes.size());
    EXPECT_EQ(set_one.camera.name, plain.camera.name);
    EXPECT_EQ(set_one.lights.size(), plain.lights.size());
}

TEST_F(OverridesTest, WrongSettingsAreWrongUse) {
    const std::pair<const char*, const char*> wrong[] = {
        {"film.widht=400", "--set film.widht=400: unknown key \"widht\" in [film]"},
        {"film.widht=400", "did you mean \"width\"?"},
        {"flim.width=400", "did you mean \"film\"?"},
        {"film.width", "expected PATH=VALUE"},
        {"=3", "expected PATH=VALUE"},
        {"film width=3", "\"film width\" is no path"},
        {"a.b\nc=3", "is no path"},
        {"film.width=", "\"\" is no value of TOML"},
        {"film.filter=box", "strings stand in quotes: --set 'film.filter=\"box\"'"},
        {"film.width=3\nseed=4", "is no value of TOML"},
        {"film.width=0", "--set film.width=0: width is 0; it must be between 1 and 65536"},
        {"film.width=\"wide\"", "expected a whole number"},
        {"film.width.x=3", "film.width is the number 10: there is nothing in it"},
        {"shapes.4.radius_m=1", "shapes has 2 entries, none of which is \"4\""},
        {"shapes.0.radius_m=1", "they are counted from 1"},
        {"shapes.bal.radius_m=1", "did you mean \"ball\"?"},
        {"shapes.3.type=\"sphere\"", "--set shapes.3.type=\"sphere\": shape 3 needs radius_m"},
        {"shapes.1.radius_m=1", "unknown key \"radius_m\" in shape 1"},
        {"materials.flint.glass=\"SF66x\"", "unknown glass"},
        {"materials.flint.ior=1.5", "has both glass and ior"},
        {"materials.new.type=\"black\"", ""},
        {"imports.1.file=\"gone.obj\"", "gone.obj"},
        {"camera.position=[0, 0, 1]", "[camera] needs look_at"},
    };
    for (const auto& [setting, phrase] : wrong) {
        const std::string message = usage_error({.settings = {setting}});
        EXPECT_NE(message.find(phrase), std::string::npos) << setting << "\n" << message;
        EXPECT_EQ(message.empty(), *phrase == 0) << setting << "\n" << message;
        EXPECT_FALSE(message.starts_with("no UsageError")) << message;
    }
}

// ---- --glass -----------------------------------------------------------------------------------

TEST_F(OverridesTest, GlassKeepsWhatItIsBesidesItsIndex) {
    const Scene scene = with({.glasses = {{"flint", "N-BK7"}}});
    const auto& glass = std::get<Dielectric>(scene.materials[0].surface);
    EXPECT_NEAR(index_at_d(scene, 0), 1.51680 * 1.000272, 1e-5);
    EXPECT_EQ(glass.roughness.value, 0.25);
    EXPECT_TRUE(glass.tint);
    EXPECT_TRUE(glass.interior->absorption);
    EXPECT_EQ(glass.interior->priority, 3);
}

TEST_F(OverridesTest, OtherMaterialsBecomeClearBodies) {
    const Scene scene = with({.glasses = {{"paper", "diamond"}}});
    const auto& glass = std::get<Dielectric>(scene.materials[1].surface);
    EXPECT_TRUE(glass.roughness == 0.0);
    EXPECT_FALSE(glass.tint);
    EXPECT_FALSE(scene.materials[1].coverage);  // half of a stone is no stone
    EXPECT_NEAR(index_at_d(scene, 1), 2.417, 2e-3);
}

TEST_F(OverridesTest, WhatHasToBeSaidOfAGlassIsSaidOnce) {
    const auto notes = [&](const std::string& glass) {
        write("scene.toml",
              "[materials.a]\ntype = \"glass\"\nglass = \"" + glass +
                  "\"\n[materials.b]\ntype = \"glass\"\nglass = \"" + glass +
                  "\"\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"a\"\nradius_m = 1\n");
        return load_scene(folder_ / "scene.toml", {.glasses = {{"b", glass}}}).diagnostics;
    };
    EXPECT_TRUE(notes("N-BK7").empty());
    const Diagnostics short_range = notes("SF11");  // its data begin at 390 nm
    ASSERT_EQ(short_range.size(), 1u);
    EXPECT_EQ(short_range[0].text, range_warning(find_glass("SF11")));
    EXPECT_EQ(short_range[0].place.line, 3u);
    const Diagnostics calcite = notes("calcite");
    ASSERT_FALSE(calcite.empty());
    EXPECT_EQ(calcite.back().text, birefringence_note(find_glass("calcite")));
}

TEST_F(OverridesTest, WrongGlassesAreWrongUse) {
    EXPECT_NE(usage_error({.glasses = {{"flnt", "N-BK7"}}}).find("did you mean \"flint\"?"),
              std::string::npos);
    EXPECT_NE(usage_error({.glasses = {{"flint", "N-BK8"}}}).find("N-BK7"), std::string::npos);
    EXPECT_NE(usage_error({.glasses = {{"flint", "N-BK8"}}}).find("--glass flint=N-BK8: "),
              std::string::npos);
}

// ---- --env -------------------------------------------------------------------------------------

/// A Radiance picture of 2 × 1 grey pixels, (128 + 0.5)/256 · 2 each [Ward, "Real Pixels", 1991].
std::string grey_hdr() {
    return std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
           std::string("\x80\x80\x80\x81\x80\x80\x80\x81", 8);
}

TEST_F(OverridesTest, APictureReplacesEnvironmentsAndKeepsLamps) {
    write("sky.hdr", grey_hdr());
    write("lit.toml", std::string(kPrisms) +
                          "[[lights]]\ntype = \"environment\"\nradiance = 1\n[[lights]]\ntype = "
                          "\"point\"\nposition = [0, 9, 0]\nintensity = 1\n");
    const Scene scene = with({.environment = (folder_ / "sky.hdr").string()}, "lit.toml");
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<PointLight>(scene.lights[0]));
    const auto& sky = std::get<std::shared_ptr<const ImageEnvironment>>(scene.lights[1]);
    EXPECT_EQ(sky->width, 2);
    // The film's default white is that of the constant spectrum 1.
    EXPECT_NEAR(sky->scale, 1.0, 1e-4);
}

TEST_F(OverridesTest, APictureTakesThePlaceOfTheStudio) {
    write("sky.hdr", grey_hdr());
    EXPECT_EQ(with({.environment = (folder_ / "sky.hdr").string()}).lights.size(), 1u);
}

TEST_F(OverridesTest, AWrongPictureIsWrongUse) {
    EXPECT_NE(usage_error({.environment = "gone.exr"}).find("--env gone.exr: cannot read"),
              std::string::npos);
    EXPECT_NE(usage_error({.environment = "sky.jpg"}).find("expected .exr or .hdr"),
              std::string::npos);
}

}  // namespace
}  // namespace dewbow
