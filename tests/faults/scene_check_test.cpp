// SPDX-License-Identifier: Apache-2.0

// What `dewbow scene check` tells of scenes.

#include <gtest/gtest.h>

#include <fstream>

#include "dewbow/image/png.h"
#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr const char* kScene = R"(
[materials.flint]
type = "glass"
glass = "schott/N-SF11"
[materials.frosted]
type = "glass"
ior = 1.5
roughness = 0.3
[materials.wall]
type = "diffuse"
reflectance = "wood.png"
[[shapes]]
type = "box"
material = "flint"
width_m = 1
height_m = 2
depth_m = 3
[[shapes]]
type = "sphere"
material = "frosted"
radius_m = 0.5
[[shapes]]
type = "mesh"
file = "a.obj"
material = "wall"
group = "leaf"
[[instances]]
of = "leaf"
positions = [[0, 0, 0], [0.1, 0, 0], [0.2, 0, 0]]
[[lights]]
type = "distant"
direction = [0, -1, 0]
irradiance = 1
angular_radius_deg = 0.2666
)";

/// Standard output of `scene check` with `options`.
std::string told(const std::string& scene, const std::vector<std::string>& options) {
    const Folder folder;
    folder.put("scene.toml", scene);
    folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 4 3\nl 1 2\n");
    folder.put("wood.png", encode_png({2, 1, {255, 0, 0, 0, 0, 255}}, {}));
    std::vector<std::string> arguments{"scene", "check", "scene.toml"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    return outcome.standard_output;
}

void expect_all(const std::string& text, const std::vector<const char*>& phrases) {
    for (const char* phrase : phrases)
        EXPECT_NE(text.find(phrase), std::string::npos) << phrase << " is not in\n" << text;
}

TEST(SceneCheck, TellsWhatIsInAScene) {
    expect_all(told(kScene, {}),
               {"shapes     1 box, 3 mesh, 1 sphere", "triangles  2 in 1 meshes; 6 as placed",
                // Schott's data sheet: n_d 1.78472, V_d 25.68
                "flint: glass, schott/N-SF11, n_d 1.78472, V_d 25.68 (1 shape)",
                "frosted: glass, n_d 1.50000, no dispersion, roughness 0.3",
                "wood.png: 2 x 1, 8 bits", "size       1.7 x 2 x 3 m", "lights     1 distant",
                "a.obj:6: lines and points are not shown"});
}

TEST(SceneCheck, TellsWhatCostsAndWhy) {
    expect_all(
        told(kScene, {}),
        {"rough glass \"frosted\": light behind it is found by chance",
         "a small light, glass, and something matt: what the light sends through the glass"});
    // Without the glass there is no caustic, and nothing rough.
    const std::string plain = told(kScene, {"--set", "materials.flint={type=\"black\"}", "--set",
                                            "materials.frosted={type=\"black\"}"});
    EXPECT_EQ(plain.find("costs"), std::string::npos) << plain;
    expect_all(told(kScene, {"--set", "shapes.2.radius_m=5000"}), {"m across: lengths are metres"});
}

TEST(SceneCheck, TellsProgramsTheSame) {
    expect_all(told(kScene, {"--json"}),
               {"\"shapes\":{\"box\":1,\"mesh\":3,\"sphere\":1}", "\"placed_triangles\":6",
                "\"glass\":\"schott/N-SF11\"", "\"v_d\":25.67", "\"width\":960",
                "\"costs\":[{\"what\":\"rough glass", "\"ignored\":[{\"place\""});
}

TEST(SceneCheck, OptionsCount) {
    expect_all(told(kScene, {"--glass", "flint=N-BK7"}), {"schott/N-BK7, n_d 1.51680, V_d 64.17"});
}

}  // namespace
}  // namespace dewbow::faults
