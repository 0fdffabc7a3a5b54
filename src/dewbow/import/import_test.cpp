// SPDX-License-Identifier: Apache-2.0

// Whole files: formats, completion, and the files of other people.

#include "dewbow/import/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "dewbow/base/file.h"
#include "dewbow/import/gltf/test_document.h"
#include "dewbow/import/merge.h"
#include "dewbow/import/toml/scene_toml.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

/// A folder of its own for each test, removed at its end.
class ImportTest : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  ("dewbow_" +
                   std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    std::string error_of(const std::filesystem::path& path) {
        try {
            load_scene(path);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }

    std::filesystem::path folder_;
};

const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

const ImageEnvironment* studio_of(const Scene& scene) {
    if (scene.lights.size() != 1) return nullptr;
    const auto* light = std::get_if<std::shared_ptr<const ImageEnvironment>>(&scene.lights[0]);
    return light ? light->get() : nullptr;
}

TEST_F(ImportTest, AMeshAloneIsGreyInTheStudio) {
    const ImportedScene imported = load_scene(write("a.OBJ", kTriangle));
    const Scene& scene = imported.scene;
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<Diffuse>(scene.materials.at(0).surface));
    ASSERT_NE(studio_of(scene), nullptr);
    // The film's default white is that of the constant spectrum 1, and so is the studio's (1, 1,
    // 1).
    EXPECT_NEAR(studio_of(scene)->scale, 1.0, 1e-4);
    EXPECT_EQ(scene.camera.name, "framed");
}

/// The sides of a narrow picture are nearer: the camera must stand further away.
TEST_F(ImportTest, ASceneIsFramedForThePicturesSize) {
    const std::string file = write("a.obj", kTriangle);
    LoadOptions narrow;
    narrow.width = 100, narrow.height = 400;
    const Scene wide_scene = load_scene(file).scene, narrow_scene = load_scene(file, narrow).scene;
    EXPECT_EQ(narrow_scene.film.width, 100);
    EXPECT_EQ(narrow_scene.film.height, 400);
    const auto distance = [](const Scene& scene) {
        return length(scene.camera.world_from_camera(Point<Camera>{}).v -
                      bounds_of(scene).centre());
    };
    EXPECT_GT(distance(narrow_scene), 2.0 * distance(wide_scene));
}

/// In haze a beam shows by itself.
TEST_F(ImportTest, HazeShowsLampsWithoutTheStudio) {
    const std::string scene =
        "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n[materials.g]\ntype = \"glass\"\nior "
        "= 1.5\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"g\"\nradius_m = 1\n[[lights]]\n"
        "type = \"point\"\nposition = [0, 3, 0]\nintensity = 1\n";
    EXPECT_EQ(load_scene(write("clear.toml", scene)).scene.lights.size(), 2u);
    const std::string haze = "[surroundings]\nglass = \"air\"\nscattering_per_m = 0.1\n";
    EXPECT_EQ(load_scene(write("hazy.toml", haze + scene)).scene.lights.size(), 1u);
}

TEST_F(ImportTest, TheStudioSuitsTheFilmsWhite) {
    const auto imported = load_scene(write("a.gltf", gltf_test::text_of({})));
    ASSERT_NE(studio_of(imported.scene), nullptr);
    EXPECT_EQ(imported.scene.film.white_luminance, 1.0);
    EXPECT_NEAR(studio_of(imported.scene)->scale * kLuminousEfficacy * cie_y_integral(), 1.0, 1e-9);
}

TEST_F(ImportTest, GlowingThingsAreLightEnough) {
    gltf_test::Parts parts;
    parts.materials =
        R"([{"emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}}}])";
    EXPECT_TRUE(load_scene(write("a.gltf", gltf_test::text_of(parts))).scene.lights.empty());
    // A label of glTF, as white as the film's white, is no lamp.
    parts.materials = R"([{"emissiveFactor": [1, 1, 1]}])";
    EXPECT_NE(studio_of(load_scene(write("b.gltf", gltf_test::text_of(parts))).scene), nullptr);
    // A material that nothing wears gives no light.
    const auto path = write("a.toml", "[materials.lamp]\ntype = \"black\"\nemission = 1\n");
    EXPECT_NE(studio_of(load_scene(path).scene), nullptr);
}

TEST_F(ImportTest, OnlyGltfHasAnimations) {
    LoadOptions options;
    options.frame = 1.0;
    EXPECT_NO_THROW(load_scene(write("a.gltf", gltf_test::text_of({})), options));
    EXPECT_THROW(load_scene(write("a.toml", ""), options), UsageError);
}

TEST_F(ImportTest, OtherFormatsAreNamed) {
    EXPECT_NE(
        error_of(write("a.fbx", "solid")).find("expected one of .toml, .gltf, .glb, .obj, .ply"),
        std::string::npos);
    EXPECT_NE(error_of(folder_ / "scene").find("needs an extension"), std::string::npos);
    EXPECT_NE(error_of(folder_ / "missing.toml").find("missing.toml"), std::string::npos);
    EXPECT_EQ(scene_extensions().size(), 6u);
}

TEST_F(ImportTest, AMeshWithoutAreaIsAnError) {
    EXPECT_NE(error_of(write("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"))
                  .find("has no triangle with an area"),
              std::string::npos);
}

TEST(SceneFormatManual, ItsExampleIsAScene) {
    const std::string manual =
        read_file(std::filesystem::path(DEWBOW_SOURCE_DIR) / "docs" / "scene-format.md");
    const std::string fence = "```toml\n";
    const std::size_t begin = manual.find(fence) + fence.size();
    const std::size_t end = manual.find("```", begin);
    ASSERT_LT(begin, end);
    const ParsedScene parsed = parse_scene_toml("manual.toml", manual.substr(begin, end - begin));
    EXPECT_EQ(parsed.scene.shapes.size(), 1u);
    EXPECT_EQ(parsed.scene.cameras.size(), 1u);
}

// ---- imports of scene.toml ---------------------------------------------------------------------

gltf_test::Parts lit_triangle() {
    gltf_test::Parts parts;
    parts.roots = "[0, 1, 2]";
    parts.nodes = R"([{"name": "tri", "mesh": 0},
        {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [1, 0, 0]},
        {"camera": 0, "translation": [0, 0, 2]}])";
    parts.materials = R"([{"name": "gold"}])";
    parts.rest = R"(, "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5}}])";
    return parts;
}

TEST_F(ImportTest, ImportsBringShapesLightsAndCamera) {
    write("ring.gltf", gltf_test::text_of(lit_triangle()));
    const Scene scene = load_scene(write("scene.toml", R"(
        [[imports]]
        file = "ring.gltf"
        scale = 2
        position = [0, 10, 0])"))
                            .scene;
    ASSERT_EQ(scene.shapes.size(), 1u);
    const Vec3 corner = scene.shapes[0].world_from_object(Point<Object>{{1, 0, 0}}).v;
    EXPECT_NEAR(corner.x, 2.0, 1e-12);
    EXPECT_NEAR(corner.y, 10.0, 1e-12);
    EXPECT_NEAR(std::get<PointLight>(scene.lights.at(0)).position.v.x, 2.0, 1e-12);
    // Its camera serves where the scene has none, and its white where the scene has no light.
    EXPECT_NEAR(scene.camera.world_from_camera(Point<Camera>{}).v.z, 4.0, 1e-12);
    EXPECT_EQ(scene.film.white_luminance, 1.0);
}

constexpr const char* kThreeCameras = R"([camera]
position = [0, 0, 1]
look_at = [0, 0, 0]
[cameras.left]
position = [-1, 0, 1]
look_at = [0, 0, 0]
[cameras.ring]
from = "ring/close"
[[imports]]
file = "ring.gltf"
name = "ring")";

gltf_test::Parts two_cameras() {
    gltf_test::Parts parts = lit_triangle();
    parts.roots = "[0, 1, 2, 3]";
    parts.nodes = R"([{"name": "tri", "mesh": 0}, {"name": "far", "camera": 0},
        {"camera": 1, "translation": [0, 0, 2]}, {"name": "far", "camera": 0}])";
    parts.rest = R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5}},
        {"name": "close", "type": "perspective", "perspective": {"yfov": 0.25}}])";
    return parts;
}

std::vector<std::string> camera_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const CameraView& camera : scene.cameras) names.push_back(camera.name);
    return names;
}

TEST_F(ImportTest, CamerasAreOfferedByName) {
    write("ring.gltf", gltf_test::text_of(two_cameras()));
    const std::string path = write("scene.toml", kThreeCameras);
    const ImportedScene imported = load_scene(path);
    EXPECT_EQ(camera_names(imported.scene),
              (std::vector<std::string>{"camera", "left", "ring", "ring/far", "ring/close",
                                        "ring/far 2"}));
    EXPECT_EQ(imported.scene.camera.name, "camera");
    EXPECT_TRUE(imported.diagnostics.empty());  // the file says which one
    EXPECT_EQ(load_scene(path, {.camera = "left"}).scene.camera.name, "left");
    const CameraView ring = load_scene(path, {.camera = "ring"}).scene.camera;
    EXPECT_NEAR(std::get<Perspective>(ring.projection).vertical_field_of_view.to(unit::rad), 0.25,
                1e-12);
}

TEST_F(ImportTest, TheFirstCameraOfAGltfTakesThePictureAndTheOthersAreNamed) {
    const std::string path = write("ring.gltf", gltf_test::text_of(two_cameras()));
    const ImportedScene imported = load_scene(path);
    EXPECT_EQ(imported.scene.camera.name, "far");
    ASSERT_EQ(imported.diagnostics.size(), 1u);
    EXPECT_EQ(imported.diagnostics[0].text,
              "camera \"far\" takes the picture; --camera NAME picks another: close, far 2");
    const ImportedScene chosen = load_scene(path, {.camera = "close"});
    EXPECT_EQ(chosen.scene.camera.name, "close");
    EXPECT_TRUE(chosen.diagnostics.empty());
}

TEST_F(ImportTest, OrthographicPicturesGrowWithTheirImport) {
    gltf_test::Parts parts = lit_triangle();
    parts.rest = R"(, "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
        "cameras": [{"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1}}])";
    write("ring.gltf", gltf_test::text_of(parts));
    const Scene scene =
        load_scene(write("s.toml", "[[imports]]\nfile = \"ring.gltf\"\nscale = 3\n")).scene;
    EXPECT_NEAR(std::get<Orthographic>(scene.camera.projection).height.to(unit::m), 6.0, 1e-12);
}

TEST_F(ImportTest, CamerasThatAreNotThereAreErrors) {
    const auto error_of = [](const std::string& path, const std::string& camera) {
        try {
            load_scene(path, {.camera = camera});
        } catch (const InputError& error) {
            return std::string(error.sentence()) + " | " + std::string(error.hint());
        }
        return std::string("no error");
    };
    const std::string gltf = write("ring.gltf", gltf_test::text_of(two_cameras()));
    EXPECT_EQ(error_of(gltf, "clase"),
              "--camera clase: there is no camera \"clase\" | did you mean \"close\"?");
    EXPECT_EQ(error_of(write("a.obj", kTriangle), "any"),
              "--camera any: there is no camera \"any\" | the scene has no camera");
}

TEST_F(ImportTest, WhatTheSceneSaysWins) {
    write("ring.gltf", gltf_test::text_of(lit_triangle()));
    const Scene scene = load_scene(write("scene.toml", R"(
        [film]
        white_luminance_cd_m2 = 77
        [materials.glass]
        type = "glass"
        glass = "diamond"
        [[imports]]
        file = "ring.gltf"
        name = "ring"
        [imports.materials]
        gold = "glass"
        [camera]
        from = "ring")"))
                            .scene;
    EXPECT_EQ(scene.film.white_luminance, 77.0);
    EXPECT_EQ(scene.materials[std::size_t(scene.shapes.at(0).material)].name, "glass");
    EXPECT_NEAR(std::get<Perspective>(scene.camera.projection).vertical_field_of_view.to(unit::rad),
                0.5, 1e-12);
}

TEST_F(ImportTest, OverridesNameMaterialsThatAreThere) {
    write("ring.gltf", gltf_test::text_of(lit_triangle()));
    const std::string message =
        error_of(write("scene.toml",
                       "[materials.a]\ntype = \"black\"\n[[imports]]\nfile = "
                       "\"ring.gltf\"\n[imports.materials]\ngolt = \"a\"\n"));
    EXPECT_NE(message.find("scene.toml:6:1"), std::string::npos) << message;
    EXPECT_NE(message.find("did you mean \"gold\"?"), std::string::npos) << message;
}

TEST_F(ImportTest, AMirroredImportKeepsItsFrontOutside) {
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const Scene scene =
        load_scene(write("scene.toml", "[[imports]]\nfile = \"a.obj\"\nscale = [1, 1, -1]\n"))
            .scene;
    const Shape& shape = scene.shapes.at(0);
    const Mesh& mesh = gltf_test::mesh_of(shape);
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
        p[i] = shape.world_from_object(mesh.vertices[mesh.triangles[0][i]]).v;
    const Vec3 by_winding = normalised(cross(p[1] - p[0], p[2] - p[0]));
    const Vec3 by_normal = shape.world_from_object(mesh.normals.at(0)).v;
    EXPECT_NEAR(by_winding.z, -1.0, 1e-12);
    EXPECT_NEAR(by_normal.z, -1.0, 1e-12);
}

TEST_F(ImportTest, ErrorsWithinAnImportNameBoth) {
    write("ring.gltf", "{}");
    const std::string message =
        error_of(write("scene.toml", "[[imports]]\nfile = \"ring.gltf\"\n"));
    EXPECT_NE(message.find("scene.toml:2:8"), std::string::npos) << message;
    EXPECT_NE(message.find("ring.gltf: needs \"asset\""), std::string::npos) << message;
}

// ---- files of other people ---------------------------------------------------------------------

struct KnownFile {
    const char* name;
    std::size_t shapes, materials, lights, diagnostics;
    bool own_camera;
};

// Materials: those in use, and two more for each that is a mix. Light 1 without a light of its own:
// the studio; balls of glass alone need it beside their sun.
const KnownFile kKnownFiles[] = {
    {"DispersionTest.glb", 27, 27, 1, 0, false}, {"TransmissionTest.glb", 22, 34, 1, 0, true},
    {"self_prisms.gltf", 4, 4, 2, 0, true},      {"self_gems.glb", 6, 6, 0, 0, true},
    {"self_balls.glb", 3, 3, 2, 0, true},
};

std::filesystem::path shared(const std::string& name) {
    return std::filesystem::path(DEWBOW_SHARED_DATA) / "gltf" / name;
}

std::string listed(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics)
        text += to_string(diagnostic.place) + ": " + diagnostic.text + "\n";
    return text;
}

TEST(KnownFiles, AreReadWhole) {
    if (!std::filesystem::exists(shared("DispersionTest.glb"))) GTEST_SKIP() << "no " << shared("");
    for (const KnownFile& file : kKnownFiles) {
        const ImportedScene imported = load_scene(shared(file.name));
        EXPECT_EQ(imported.scene.shapes.size(), file.shapes) << file.name;
        EXPECT_EQ(imported.scene.materials.size(), file.materials) << file.name;
        EXPECT_EQ(imported.scene.lights.size(), file.lights) << file.name;
        EXPECT_EQ(imported.diagnostics.size(), file.diagnostics) << file.name << "\n"
                                                                 << listed(imported.diagnostics);
        EXPECT_EQ(imported.scene.camera.name != "framed", file.own_camera) << file.name;
    }
}

TEST(KnownFiles, DispersionTestHasItsTwentyFiveGlasses) {
    if (!std::filesystem::exists(shared("DispersionTest.glb"))) GTEST_SKIP() << "no " << shared("");
    const ImportedScene imported = load_scene(shared("DispersionTest.glb"));
    const double iors[] = {1.0, 1.33, 1.5, 1.76, 2.42}, dispersions[] = {0.0, 0.5, 1.0, 2.0, 5.0};
    const double n_air = (*air())(kLined).value;
    std::size_t found = 0;
    for (const Material& material : imported.scene.materials) {
        const auto* glass = std::get_if<Dielectric>(&material.surface);
        if (!glass) continue;
        ASSERT_EQ(material.name.substr(0, 8), "Mat_IOR_") << material.name;
        const double ior = (*glass->interior->index)(kLined).value / n_air;
        const auto* nearest = std::min_element(
            std::begin(iors), std::end(iors),
            [&](double a, double b) { return std::abs(a - ior) < std::abs(b - ior); });
        EXPECT_NEAR(ior, *nearest, 1e-5) << material.name;
        const double dispersion = dispersions[std::size_t(material.name.back() - '1')];
        const double measured = 20.0 / abbe_number(*glass->interior->index, *air());
        // Index 1 cannot disperse; the form's constants have four digits.
        EXPECT_NEAR(measured, ior < 1.001 ? 0.0 : dispersion, 1e-3 * dispersion + 1e-3)
            << material.name;
        ++found;
    }
    EXPECT_EQ(found, 25u);
}

TEST(KnownFiles, GemsHaveTheVolumesTheyWereMadeWith) {
    if (!std::filesystem::exists(shared("self_gems.glb"))) GTEST_SKIP() << "no " << shared("");
    const ImportedScene imported = load_scene(shared("self_gems.glb"));
    std::size_t gems = 0;
    for (const Shape& shape : imported.scene.shapes) {
        if (!shape.name.starts_with("gem_")) continue;
        const Mesh& mesh = gltf_test::mesh_of(shape);
        double volume = 0.0;
        for (const auto& t : mesh.triangles) {
            const auto at = [&](int i) {
                return shape.world_from_object(mesh.vertices[t[std::size_t(i)]]).v;
            };
            volume += dot(at(0), cross(at(1), at(2))) / 6.0;
        }
        EXPECT_NEAR(volume, 0.21002, 1e-4) << shape.name;  // positive: fronts are outside
        ++gems;
    }
    EXPECT_EQ(gems, 4u);
}

/// A guest that is blown up twofold and lies on its side: its beam is twice as wide, its profile
/// shines along the turned nadir.
TEST(Merge, MovesBeamsAndProfiles) {
    constexpr double kRounding = 1e-12;
    const auto web =
        std::make_shared<const PhotometricWeb>(PhotometricTable{{0.0, 90.0}, {0.0}, {1.0, 0.0}});
    Scene guest = make_empty_scene(), host = make_empty_scene();
    guest.lights.push_back(
        BeamLight{{{1, 0, 0}}, {{0, -1, 0}}, 0.25 * unit::m, make_constant(1.0)});
    guest.lights.push_back(ProfileLight{{{1, 0, 0}}, {}, web, make_constant(1.0)});
    // A quarter turn about z takes −y to +x and +x to +y.
    merge(host, guest, rotation({0, 0, 1}, 90.0 * unit::deg) * scaling({2, 2, 2}), {});
    const auto& beam = std::get<BeamLight>(host.lights.at(0));
    EXPECT_NEAR(beam.radius.to(unit::m), 0.5, kRounding);
    EXPECT_NEAR(length(beam.direction.v - Vec3{1, 0, 0}), 0.0, kRounding);
    EXPECT_NEAR(length(beam.position.v - Vec3{0, 2, 0}), 0.0, kRounding);
    const auto& profile = std::get<ProfileLight>(host.lights.at(1));
    const Vec3 nadir = profile.world_from_object(Dir<Object>{{0, -1, 0}}).v;
    EXPECT_NEAR(length(nadir - Vec3{1, 0, 0}), 0.0, kRounding);
}

}  // namespace
}  // namespace dewbow
