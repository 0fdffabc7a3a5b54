// SPDX-License-Identifier: Apache-2.0

// Scenes as an artist exports them: Blender runs the scripts of examples/blender, and what they
// write is rendered. Skipped where Blender is not installed.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "small_render.h"

namespace dewbow {
namespace {

using corpus::render_small;
using corpus::SmallPicture;
using Rgb = Colour<LinearSrgb>;

bool runs(const std::string& command) { return std::system(command.c_str()) == 0; }

class Blender : public testing::Test {
protected:
    void SetUp() override {
        if (!runs("command -v blender >/dev/null")) GTEST_SKIP() << "Blender is not installed";
        if (!runs("/usr/bin/python3 -c 'import numpy' 2>/dev/null"))
            GTEST_SKIP() << "Blender's glTF exporter needs python3-numpy, which is not installed";
        std::string name = (std::filesystem::temp_directory_path() / "dewbow-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override {
        if (!folder_.empty()) std::filesystem::remove_all(folder_);
    }

    std::filesystem::path exported(const std::string& name) const {
        const auto file = folder_ / (name + ".glb"), log = folder_ / (name + ".log");
        const auto script =
            std::filesystem::path(DEWBOW_SOURCE_DIR) / "examples/blender" / (name + ".py");
        EXPECT_TRUE(runs("timeout 200 blender --background --factory-startup --python '" +
                         script.string() + "' -- '" + file.string() + "' >'" + log.string() +
                         "' 2>&1 </dev/null"));
        std::stringstream text;
        text << std::ifstream(log).rdbuf();
        EXPECT_TRUE(std::filesystem::exists(file)) << text.str();
        return file;
    }

private:
    std::filesystem::path folder_;
};

/// Whether two colours differ by less than `error` in each channel.
bool alike(const Rgb& a, const Rgb& b, double error) {
    return std::abs(a[0] - b[0]) < error && std::abs(a[1] - b[1]) < error &&
           std::abs(a[2] - b[2]) < error;
}

/// Spectra of colours, and edges of pixels, take this much of an albedo.
constexpr double kAlbedoError = 0.04;

std::string texts(const Diagnostics& diagnostics) {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) all += diagnostic.text + "\n";
    return all;
}

const Material& material_named(const Scene& scene, const std::string& name) {
    for (const Material& material : scene.materials)
        if (material.name == name) return material;
    throw std::runtime_error("no material " + name);
}

TEST_F(Blender, TheRingIsOfGoldWithADiamond) {
    const SmallPicture picture = render_small(exported("ring"), 80, 60, 8);
    EXPECT_EQ(texts(picture.imported.diagnostics),
              "gem/diamond: data of 226 to 760 nm; 760 to 830 nm is extrapolated\n");
    const double gold = picture.share([&](int x, int y) {
        return alike(picture.albedo(x, y), {{1.0, 0.77, 0.34}}, kAlbedoError);
    });
    EXPECT_GT(gold, 0.05);
    EXPECT_LT(gold, 0.4);
    // Of a custom property of the material: n_d 2.4175 [Peter 1923], and real dispersion.
    const auto& stone =
        std::get<Dielectric>(material_named(picture.imported.scene, "Diamond").surface);
    EXPECT_NEAR(abbe_number(*stone.interior->index, *air()), 55.0, 2.0);
}

TEST_F(Blender, TheBottleHasItsLabelAndItsCloth) {
    const SmallPicture picture = render_small(exported("bottle"), 80, 60, 8);
    EXPECT_EQ(texts(picture.imported.diagnostics), "");
    const auto shows = [&](Rgb colour) {
        return picture.share(
            [&](int x, int y) { return alike(picture.albedo(x, y), colour, kAlbedoError); });
    };
    // The paper of the label and the two colours of the cloth, decoded from sRGB pictures as they
    // were written: Blender takes the numbers of a picture that it makes for sRGB codes.
    const auto linear = [](double code) { return std::pow((code + 0.055) / 1.055, 2.4); };
    EXPECT_GT(shows({{linear(0.93), linear(0.90), linear(0.80)}}), 0.01);
    EXPECT_GT(shows({{linear(0.85), linear(0.84), linear(0.80)}}), 0.01);
    EXPECT_GT(shows({{linear(0.16), linear(0.24), linear(0.48)}}), 0.01);
    // The label's corners are cut out by its alpha.
    const Material& label = material_named(picture.imported.scene, "Label");
    ASSERT_TRUE(label.coverage.has_value());
    EXPECT_TRUE(label.coverage->cutoff.has_value());
    // Wine absorbs blue and green.
    const auto& wine = std::get<Dielectric>(material_named(picture.imported.scene, "Wine").surface);
    ASSERT_NE(wine.interior->absorption, nullptr);
    EXPECT_GT((*wine.interior->absorption)(480.0 * unit::nm),
              2.0 * (*wine.interior->absorption)(650.0 * unit::nm));
}

TEST_F(Blender, TheLampShinesThroughItsHoles) {
    const std::filesystem::path file = exported("lamp");
    const SmallPicture picture = render_small(file, 80, 60, 16);
    EXPECT_EQ(texts(picture.imported.diagnostics),
              "the scene is shown at rest; --frame N shows its animations\n");
    const double glowing = picture.share([&](int x, int y) { return picture.rgb(x, y)[0] > 5.0; });
    EXPECT_GT(glowing, 0.001);
    EXPECT_LT(glowing, 0.1);

    // Half of the animation later the globe has turned: other colours, the same desk.
    LoadOptions later;
    later.frame = 12.0;
    const SmallPicture turned = render_small(file, 80, 60, 16, later);
    const double moved = picture.share(
        [&](int x, int y) { return !alike(picture.albedo(x, y), turned.albedo(x, y), 0.1); });
    EXPECT_GT(moved, 0.005);
    EXPECT_LT(moved, 0.1);
}

}  // namespace
}  // namespace dewbow
