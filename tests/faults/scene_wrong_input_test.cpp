// SPDX-License-Identifier: Apache-2.0

// Wrong scenes and wrong options that change scenes, given to the program itself: see
// wrong_input_test.cpp. Here are meshes, material libraries, textures, instances, and the options
// --set, --glass and --env; `scene check` must say the same as `render`.

#include <gtest/gtest.h>

#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr int kWrongInput = 1, kWrongUse = 2;

#define GREY "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n"
#define BALL "[[shapes]]\ntype = \"sphere\"\nmaterial = \"grey\"\nradius_m = 1\n"
constexpr const char* kScene = GREY BALL;
constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

using Words = std::vector<std::string>;

struct File {
    std::string name, bytes;
};

struct Row {
    std::string name;
    std::vector<File> files;  ///< the first is the scene
    Words options, phrases;
    int exit_code = kWrongInput;
};

/// The faults of the answers of `render` and of `scene check`; empty without any.
std::string faults_of(const Row& row) {
    std::string faults;
    const std::string scene = row.files.front().name;
    const std::vector<Words> commands = {
        {"render", scene, "-o", "new.png", "--size", "8x8", "--spp", "1"},
        {"scene", "check", scene}};
    for (Words command : commands) {
        const Folder folder;
        for (const File& file : row.files) folder.put(file.name, file.bytes);
        const auto before = folder.snapshot();
        command.insert(command.end(), row.options.begin(), row.options.end());
        const Outcome outcome = run_program(DEWBOW_BINARY, command, folder.path());
        const std::string found = faults_of_answer(outcome, row.exit_code, row.phrases);
        if (!found.empty()) faults += command.front() + ":\n" + found;
        if (folder.snapshot() != before) faults += "  * the folder is not as it was\n";
    }
    return faults;
}

void check(const std::vector<Row>& rows) {
    for (const Row& row : rows) EXPECT_EQ(faults_of(row), "") << row.name;
}

Row option(Words options, Words phrases) {
    std::string name;
    for (const std::string& word : options) name += word + " ";
    return {name, {{"scene.toml", kScene}}, std::move(options), std::move(phrases), kWrongUse};
}
Row file(const std::string& name, const std::string& bytes, Words phrases,
         std::vector<File> others = {}) {
    others.insert(others.begin(), {name, bytes});
    return {name, std::move(others), {}, std::move(phrases), kWrongInput};
}

TEST(SceneWrongInput, RightInputIsTaken) {
    const Folder folder;
    folder.put("scene.toml", kScene);
    const Outcome outcome =
        run_program(DEWBOW_BINARY, {"scene", "check", "scene.toml", "--json"}, folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_NE(outcome.standard_output.find("\"shapes\":{\"sphere\":1}"), std::string::npos)
        << outcome.standard_output;
}

TEST(SceneWrongInput, Options) {
    check({
        option({"--set", "film.widht=4"}, {"--set film.widht=4: ", "did you mean \"width\"?"}),
        option({"--set", "film.width=0"}, {"width is 0; it must be between 1 and 65536"}),
        option({"--set", "film.width"}, {"--set film.width: expected PATH=VALUE"}),
        option({"--set", "film.filter=box"}, {"is no value of TOML", "strings stand in quotes"}),
        option({"--set", "shapes.2.radius_m=1"}, {"shape 2 needs type"}),
        option({"--set", "shapes.9.radius_m=1"}, {"shapes has 1 entries"}),
        option({"--set", "a b=1"}, {"\"a b\" is no path"}),
        option({"--set"}, {"--set wants a value"}),
        option({"--glass", "grye=N-BK7"}, {"there is no material", "did you mean \"grey\"?"}),
        option({"--glass", "grey=N-BK8"}, {"--glass grey=N-BK8: ", "N-BK7"}),
        option({"--glass", "grey"}, {"--glass is grey; it must be MATERIAL=GLASS"}),
        option({"--glass", "=N-BK7"}, {"it must be MATERIAL=GLASS"}),
        option({"--env", "gone.exr"}, {"--env gone.exr: ", "cannot read"}),
        option({"--env", "scene.toml"}, {"is no environment picture", "expected .exr or .hdr"}),
        option({"--env", ""}, {"--env wants the name of a file"}),
    });
}

TEST(SceneWrongInput, Rains) {
    const std::string rain = "[[rain]]\nregion = { type = \"layer\", bottom_m = 0, top_m = 500 }\n";
    const std::string drops = "drop_radius_mm = 0.5\nmodel = \"descartes\"\n";
    check({
        file("a.toml", "[[rain]]\n", {"a.toml:1:", "rain 1 needs region"}),
        file("a.toml", rain, {"a.toml:1:", "rain 1 needs drop_sizes, drop_radius_mm or"}),
        file("a.toml", rain + drops, {"rain 1 needs rate_mm_per_h, extinction_per_km"}),
        file("a.toml", rain + drops + "rate_mm_per_h = 0\n", {"a.toml:5:", "rate_mm_per_h is 0"}),
        file("a.toml", rain + drops + "optical_depth = 1e9\n",
             {"a.toml:5:", "optical_depth is 1000000000; it must be", "at most 1000"}),
        file("a.toml", rain + drops + "extinction_per_km = 1e5\n", {"drops would fill"}),
        file("a.toml", rain + "drop_radius_mm = 0\n", {"a.toml:3:", "drop_radius_mm is 0"}),
        file("a.toml", rain + "drop_sizes = \"1m\"\n", {"a.toml:3:", "expected 1 nm to 10 mm"}),
        file("a.toml", rain + "drop_sizes = \"1cm\"\nrate_mm_per_h = 5\n", {"break up"}),
    });
}

TEST(SceneWrongInput, Meshes) {
    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
        "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
    check({
        file("a.obj", std::string(kTriangle) + "f 1 2 4\n", {"a.obj:4: ", "there is no vertex 4"}),
        file("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
             {"a.obj: ", "1 with a vertex that is not finite"}),
        file("a.obj", std::string(kTriangle) + "f 1/2 2/2 3/2\n",
             {"there is no texture coordinate 2"}),
        file("a.obj", kTriangle, {"a.obj: holds no triangle"}),
        file("a.ply", ply + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n",
             {"a.ply: ", "a vertex that is not finite"}),
        file("a.ply", ply + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", {"face 1 uses vertex 7"}),
        file("a.stl", std::string(80, ' ') + std::string("\xff\xff\xff\x7f", 4) + "abc",
             {"states 2147483647 triangles", "the file has 87"}),
        file("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
             {"a.stl:4: ", "the file ends before \"endsolid\""}),
        file("a.stl", "solid x\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendsolid\n",
             {"a vertex that is not finite"}),
        file("a.stl", "hello", {"5 bytes are too few for a binary STL file"}),
        file("a.stl", std::string("solid \xff\xfe\nvert\xff 0 0 0\n"), {"a.stl:2: unknown word"}),
    });
}

TEST(SceneWrongInput, MaterialLibraries) {
    const std::string obj = std::string("mtllib a.mtl\n") + kTriangle + "usemtl a\nf 1 2 3\n";
    check({
        file("a.obj", obj, {"a.mtl:2: \"red\" is no number"}, {{"a.mtl", "newmtl a\nKd red\n"}}),
        file("a.obj", obj, {"a.mtl:1: ", "needs a newmtl above it"}, {{"a.mtl", "Kd 1 1 1\n"}}),
        file("a.obj", obj, {"a.mtl:2: ", "N-BK7"},
             {{"a.mtl", "newmtl a\n# dewbow: glass N-BK8\n"}}),
        file("a.obj", obj, {"this is no text"}, {{"a.mtl", std::string("newmtl a\0b", 10)}}),
    });
}

TEST(SceneWrongInput, AMissingLibraryOrPictureIsAWarning) {
    const Folder folder;
    folder.put("a.obj", std::string("mtllib gone.mtl b.mtl\n") + kTriangle + "usemtl b\nf 1 2 3\n");
    folder.put("b.mtl", "newmtl b\nKd 1 0 0\nmap_Kd gone.png\n");
    const Outcome outcome = run_program(
        DEWBOW_BINARY, {"render", "a.obj", "-o", "a.png", "--size", "8x8", "--spp", "1"},
        folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    for (const char* phrase : {"warning: a.obj:1: the material library \"gone.mtl\" is not read",
                               "warning: ./b.mtl:3: the picture \"gone.png\" is not used"})
        EXPECT_NE(outcome.standard_error.find(phrase), std::string::npos) << outcome.standard_error;
}

TEST(SceneWrongInput, Textures) {
    const auto material = [](const std::string& line, Words phrases,
                             std::vector<File> others = {}) {
        return file("scene.toml",
                    "[materials.a]\ntype = \"diffuse\"\n" + line + "\n" +
                        "[[shapes]]\ntype = \"sphere\"\nmaterial = \"a\"\nradius_m = 1\n",
                    std::move(phrases), std::move(others));
    };
    check({
        material("reflectance = \"gone.png\"", {"scene.toml:3:15: ", "gone.png: cannot read"}),
        material("reflectance = \"a.png\"", {"a.png: ", "is neither a PNG nor a JPEG picture"},
                 {{"a.png", "hello"}}),
        material("reflectance = \"../a.png\"", {"scene.toml:3:15: ", "\"../a.png\""}),
        material("reflectance = 0.5\nalpha = 2", {"alpha is 2; it must be between 0 and 1"}),
        material("reflectance = 0.5\nnormal_map = \"gone.png\"", {"gone.png: cannot read"}),
        material("reflectance = \"\xff\xfe\"", {"not TOML"}),
    });
}

TEST(SceneWrongInput, Instances) {
    const std::string ball = std::string(GREY BALL) + "group = \"ball\"\n[[instances]]\n";
    check({
        file("scene.toml", ball + "of = \"bal\"\n",
             {"there is no group", "did you mean \"ball\"?"}),
        file("scene.toml", ball + "of = \"ball\"\ngroup = \"ball\"\n", {"contains itself"}),
        file("scene.toml", ball + "of = \"ball\"\nfile = \"a.csv\"\n",
             {"a.csv:2: \"x\" is no number", "expected: x, y, z"}, {{"a.csv", "1,2,3\n1,2,x\n"}}),
        file("scene.toml", ball + "of = \"ball\"\nfile = \"gone.csv\"\n",
             {"gone.csv: cannot read"}),
        file("scene.toml", ball + "of = \"ball\"\nmaterial = \"gray\"\n",
             {"did you mean \"grey\"?"}),
    });
}

}  // namespace
}  // namespace dewbow::faults
