// SPDX-License-Identifier: Apache-2.0

// Wrong command lines, scenes and files, given to the program itself. It says what was found,
// where, and what was expected, in one short error; it leaves the folder as it was, an older
// picture of the output's name included; and it ends soon, by itself, with 1 for a file and 2 for
// the command line.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>

#include "dewbow/import/gltf/test_document.h"
#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr int kWrongInput = 1, kWrongUse = 2;
constexpr std::string_view kMark = "§";

#define CAMERA "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n"
#define GREY "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n"
#define BALL "[[shapes]]\ntype = \"sphere\"\nmaterial = \"grey\"\n"
#define MESH "[[shapes]]\ntype = \"mesh\"\nmaterial = \"grey\"\n"
constexpr const char* kRightScene = CAMERA GREY BALL "radius_m = 1\n";

using Words = std::vector<std::string>;

Words operator+(Words a, const Words& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct File {
    std::string name, bytes;
};

struct Row {
    std::string name;
    std::vector<File> files;
    Words arguments;
    int exit_code;
    Words phrases;
};

/// Writes over an old picture and makes a new one, of the smallest cost.
Words render(const std::string& scene) {
    return {"render", scene, "-o", "old.png", "-o", "new.exr", "--size", "8x8", "--spp", "1"};
}

/// A wrong command line. scene.toml is right.
Row use(const std::string& name, Words arguments, Words phrases) {
    return {
        name, {{"scene.toml", kRightScene}}, std::move(arguments), kWrongUse, std::move(phrases)};
}
Row option(Words words, Words phrases) {
    std::string name;
    for (const std::string& word : words) name += word + " ";
    return use(name, render("scene.toml") + words, std::move(phrases));
}

/// A wrong file that is given as the scene.
Row file(const std::string& name, const std::string& file_name, const std::string& bytes,
         Words phrases) {
    phrases.insert(phrases.begin(), file_name + ":");
    return {name, {{file_name, bytes}}, render(file_name), kWrongInput, std::move(phrases)};
}

/// A wrong scene.toml, in which § stands before the place that the error must name.
Row scene(const std::string& name, std::string text, Words phrases, std::vector<File> others = {}) {
    const std::size_t at = text.find(kMark);
    text.erase(at, kMark.size());
    std::size_t line = 1, column = 1;
    for (std::size_t i = 0; i < at; ++i) {
        if (text[i] == '\n') ++line;
        column = text[i] == '\n' ? 1 : column + 1;
    }
    phrases.push_back("dewbow: scene.toml:" + std::to_string(line) + ":" + std::to_string(column) +
                      ": ");
    others.push_back({"scene.toml", text});
    return {name, std::move(others), render("scene.toml"), kWrongInput, std::move(phrases)};
}

/// A glTF file of one triangle that was changed.
Row gltf(const std::string& name, const std::function<void(gltf_test::Parts&)>& change,
         Words phrases) {
    gltf_test::Parts parts;
    change(parts);
    return file(name, "scene.gltf", gltf_test::text_of(parts), std::move(phrases));
}

using Prepare = std::function<void(const Folder&)>;

/// The faults of one row, without any: empty.
std::string faults_of(const Row& row, const Prepare& prepare, bool as_nobody = false) {
    const Folder folder;
    folder.put("old.png", "an older picture");
    for (const File& f : row.files) folder.put(f.name, f.bytes);
    if (prepare) prepare(folder);
    const auto before = folder.snapshot();
    const Outcome outcome =
        run_program(DEWBOW_BINARY, row.arguments, folder.path(), {.as_nobody = as_nobody});
    std::string faults = faults_of_answer(outcome, row.exit_code, row.phrases);
    if (folder.snapshot() != before) faults += "  * the folder is not as it was\n";
    return faults;
}

void check(const std::vector<Row>& rows, const Prepare& prepare = {}) {
    for (const Row& row : rows) EXPECT_EQ(faults_of(row, prepare), "") << row.name;
}

std::string random_bytes(std::size_t count) {
    std::string bytes;
    for (std::uint32_t i = 0; i < count; ++i) bytes += char((i * 2654435761u + 12345u) >> 23);
    return bytes;
}

// ---- nothing is wrong --------------------------------------------------------------------------

TEST(WrongInput, RightInputIsTaken) {
    const Folder folder;
    folder.put("scene.toml", kRightScene);
    const Outcome outcome = run_program(DEWBOW_BINARY, render("scene.toml"), folder.path());
    EXPECT_EQ(outcome.exit_code, 0) << outcome.standard_error;
    EXPECT_EQ(folder.snapshot().size(), 3u);
}

// ---- the command line --------------------------------------------------------------------------

TEST(WrongInput, CommandLines) {
    const std::string deep(5000, 'a');
    check({
        use("nothing", {}, {"a subcommand is missing", "dewbow --help"}),
        use("subcommand", {"rendr", "scene.toml"}, {"\"rendr\"", "did you mean \"render\"?"}),
        use("subcommand of glass", {"glass", "lst"}, {"\"lst\"", "did you mean \"list\"?"}),
        use("no subcommand of glass", {"glass"}, {"a subcommand is missing", "glass --help"}),
        use("no glass", {"glass", "show"}, {"the name is missing", "glass list"}),
        use("unknown glass", {"glass", "show", "N-BK8"}, {"\"N-BK8\"", "schott/N-BK7"}),
        use("two glasses", {"glass", "show", "N-BK7", "F2"}, {"one word too many: \"F2\""}),
        use("option of another", {"glass", "list", "--spp", "3"}, {"unknown option --spp"}),
        use("no scene", {"render"}, {"the scene is missing", "render --help"}),
        use("empty scene", {"render", ""}, {"the scene is missing"}),
        use("two scenes", {"render", "scene.toml", "b.toml"}, {"one word too many: \"b.toml\""}),
        option({"--sppp", "3"}, {"unknown option --sppp", "did you mean --spp?"}),
        option({"--quite"}, {"unknown option --quite", "did you mean --quiet?"}),
        option({"-x"}, {"unknown option -x", "render --help"}),
        option({"--" + deep}, {"unknown option --aaa", "..."}),
        option({"--\xff\x1b[31m\xc2\x9b"}, {"unknown option --??[31m?"}),
        option({"--spp"}, {"--spp wants a value"}),
        option({"--spp="}, {"--spp wants a value"}),
        option({"--output"}, {"--output wants a value"}),
        option({"--quiet=maybe"}, {"--quiet takes no value"}),
        option({"--json=3"}, {"--json takes no value"}),
        option({"--estimator", "pth"}, {"--estimator is \"pth\"", "did you mean \"path\"?"}),
        option({"--gamut", "towards_white"}, {"--gamut is", "did you mean \"towards-white\"?"}),
        option({"--packet", "3"}, {"--packet is 3; it must be 1, 4, 8 or 16"}),
        option({"--pixel", "1,1"}, {"--pixel and --sample belong together"}),
        option({"--pixel", "8,0", "--sample", "0"}, {"--pixel is 8,0", "picture of 8x8 pixels"}),
        option({"--crop", "4,4,5x5"}, {"--crop is 4,4,5x5", "picture of 8x8 pixels"}),
        option({"--crop", "65535,65535,65536x65536"}, {"--crop is", "picture of 8x8 pixels"}),
        option({"--size", "70000x70000"}, {"--size is \"70000x70000\"", "1 to 65536 pixels"}),
        option({"--threads", "2147483648"}, {"--threads is 2147483648", "1 to 1024"}),
    });
}

TEST(WrongInput, OutputNames) {
    check({
        option({"-o", "new.jpg"}, {"--output is \"new.jpg\"", "ends in .exr or .png"}),
        option({"-o", "new"}, {"--output is \"new\"", "ends in .exr or .png"}),
        option({"-o", ".png"}, {"--output is \".png\"", "ends in .exr or .png"}),
        option({"-o", ""}, {"--output is \"\"", "ends in .exr or .png"}),
        option({"-o", "new.png/"}, {"--output is \"new.png/\"", "ends in .exr or .png"}),
        option({"-o", "scene.toml"}, {"--output is \"scene.toml\"", "ends in .exr or .png"}),
    });
}

// ---- the pictures' place: found before anything is rendered -------------------------------------

Row output(const std::string& name, const std::string& path, Words phrases) {
    const Words arguments = render("scene.toml") + Words{"-o", path};
    return {name, {{"scene.toml", kRightScene}}, arguments, kWrongInput, std::move(phrases)};
}

TEST(WrongInput, OutputPlaces) {
    const auto prepare = [](const Folder& folder) {
        std::filesystem::create_directory(folder.path() / "folder.png");
        std::filesystem::create_symlink("loop.png", folder.path() / "loop.png");
        std::filesystem::create_symlink("missing/new.png", folder.path() / "link.png");
    };
    check(
        {
            output("no folder", "missing/new.png", {"missing/new.png: ", "No such file"}),
            output("file as folder", "scene.toml/new.png", {"\"scene.toml\" is not a folder"}),
            output("a folder", "folder.png", {"folder.png: ", "it is a folder"}),
            output("a loop of links", "loop.png", {"loop.png: ", "symbolic link"}),
            output("a link to nowhere", "link.png", {"link.png: ", "No such file"}),
            output("name too long", std::string(300, 'a') + ".png", {"File name too long"}),
            output("path too long", std::string(5000, 'a') + ".png", {"File name too long"}),
        },
        prepare);
}

TEST(WrongInput, ReadOnlyOutputs) {
    const Folder probe;
    if (run_program(DEWBOW_BINARY, {"--version"}, probe.path(), {.as_nobody = true}).exit_code != 0)
        GTEST_SKIP() << "the program cannot be run as another user";
    const auto prepare = [](const Folder& folder) {
        folder.put("locked/kept", "");
        folder.put("locked.png", "an older picture");
        ::chmod((folder.path() / "old.png").c_str(), 0666);
        ::chmod((folder.path() / "locked").c_str(), 0555);
        ::chmod((folder.path() / "locked.png").c_str(), 0444);
    };
    for (const Row& row : {output("folder", "locked/new.png", {"locked/new.png: ", "denied"}),
                           output("file", "locked.png", {"locked.png: ", "denied"})})
        EXPECT_EQ(faults_of(row, prepare, true), "") << row.name;
}

TEST(WrongInput, PicturesBeyondMemory) {
    const Words huge{"--size", "65536x65536", "--spectral-bins", "940"};
    check({{"beyond memory",
            {{"scene.toml", kRightScene}},
            render("scene.toml") + huge,
            kWrongInput,
            {"65536x65536 pixels with 940 spectral bins", "of memory", "--size"}}});
}

// ---- the scene's file --------------------------------------------------------------------------

TEST(WrongInput, SceneFiles) {
    const auto prepare = [](const Folder& folder) {
        std::filesystem::create_directory(folder.path() / "folder.toml");
        std::filesystem::create_directory(folder.path() / "folder");
        ::mkfifo((folder.path() / "fifo.toml").c_str(), 0666);
    };
    const auto given = [](const std::string& name, Words phrases) {
        return Row{name, {}, render(name), kWrongInput, std::move(phrases)};
    };
    check(
        {
            given("missing.toml", {"missing.toml: cannot read: No such file"}),
            given("missing/scene.glb", {"missing/scene.glb: cannot read: No such file"}),
            given("folder.toml", {"folder.toml: cannot read: it is a folder"}),
            given("folder", {"folder: this is a folder"}),
            given("fifo.toml", {"it is a FIFO"}),
            given("old.png", {"\".png\" is no scene format", ".toml, .gltf, .glb, .obj, .ply"}),
            given("scene", {"needs an extension", ".toml, .gltf, .glb, .obj, .ply"}),
            given(std::string(300, 'a') + ".toml", {"File name too long"}),
            given(std::string(10000, 'a') + ".toml", {"File name too long"}),
            given("\xff\x1b[31m.toml", {"??[31m.toml: cannot read"}),
            given("tw\no.toml", {"o.toml: cannot read"}),
        },
        prepare);
}

TEST(WrongInput, FilesOfNothingAndOfNoise) {
    const std::string noise = random_bytes(3000);
    check({
        file("empty", "a.toml", "", {"the file is empty"}),
        file("empty", "a.gltf", "", {"the file is empty"}),
        file("empty", "a.glb", "", {"the file is empty"}),
        file("empty", "a.obj", "", {"holds no triangle"}),
        file("empty", "a.ply", "", {"does not begin with \"ply\""}),
        file("noise", "a.toml", noise, {"a.toml:1:", "not TOML"}),
        file("noise", "a.gltf", noise, {"neither with \"glTF\"", "nor with {"}),
        file("noise", "a.glb", noise, {"neither with \"glTF\"", "nor with {"}),
        file("noise", "a.obj", noise, {"byte ", "this is no text"}),
        file("noise", "a.ply", noise, {"a.ply:1: ", "does not begin with \"ply\""}),
        file("zeros", "a.toml", std::string(5000, '\0'), {"a.toml:1:1: not TOML"}),
        file("zeros", "a.glb", std::string(5000, '\0'), {"neither with \"glTF\""}),
        file("no UTF-8 in a string", "a.gltf", "{\"asset\": {\"version\": \"2.0\xff\"}}",
             {"a.gltf:1:27: not JSON", "UTF-8"}),
    });
}

// ---- scene.toml --------------------------------------------------------------------------------

TEST(WrongInput, SceneSyntax) {
    const std::string name(100000, 'a');
    check({
        scene("no bracket", "[camera§\nposition = 1\n", {"not TOML"}),
        scene("no value", CAMERA "up =§\n", {"not TOML"}),
        scene("decimal comma", "[film]\nfilter_radius_px = 1§,5\n", {"not TOML"}),
        scene("no number", "[film]\nwidth = 800§px\n", {"not TOML"}),
        scene("key twice", "[film]\nwidth = 8\nwidth = §8\n", {"not TOML", "'width'"}),
        scene("table twice", GREY "§" GREY, {"not TOML", "'materials.grey'"}),
        scene("no UTF-8", "[materials.§a\xff]\n", {"not TOML", "utf-8"}),
        scene("deep", "a = " + std::string(256, '[') + "§" + std::string(9000, '['), {"depth"}),
        scene("long key", "§" + name + " = 1\n", {"unknown key \"aaa", "in the scene file"}),
        scene("long name", GREY "[[shapes]]\ntype = \"plane\"\nmaterial = §\"" + name + "\"\n",
              {"there is no material \"aaa", "expected one of grey"}),
        scene("long type", "[materials.a]\ntype = §\"" + name + "\"\n",
              {"expected one of diffuse"}),
        scene("long title", "§[materials." + name + "]\n", {"needs type"}),
        scene("long reference", GREY MESH "file = §\"" + name + ".obj\"\n", {"too long"}),
        scene("terminal's codes", "§\"\\u001b[31m\\u009b\" = 1\n", {"unknown key \"?[31m??\""}),
        scene("many lines",
              "§\"" +
                  [] {
                      std::string lines;
                      for (int i = 0; i < 100; ++i) lines += "\\ndewbow: x";
                      return lines;
                  }() +
                  "\" = 1\n",
              {"unknown key"}),
    });
}

TEST(WrongInput, SceneWords) {
    check({
        scene("table", CAMERA GREY BALL "radius_m = 1\n[§filn]\nwidth = 8\n",
              {"unknown key \"filn\"", "did you mean \"film\"?"}),
        scene("key", "[camera]\n§positon = [0, 0, 1]\nlook_at = [0, 0, 0]\n",
              {"unknown key \"positon\" in [camera]", "did you mean \"position\"?"}),
        scene("material", GREY "[[shapes]]\ntype = \"plane\"\nmaterial = §\"gray\"\n",
              {"there is no material \"gray\"", "did you mean \"grey\"?"}),
        scene("no material", CAMERA "§[[shapes]]\ntype = \"sphere\"\nradius_m = 1\n",
              {"shape 1 needs material"}),
        scene("type", "[materials.a]\ntype = §\"difuse\"\n",
              {"unknown material type \"difuse\"", "did you mean \"diffuse\"?"}),
        scene("shape", GREY "[[shapes]]\ntype = §\"cone\"\n",
              {"unknown shape type \"cone\"", "sphere, disc, rectangle"}),
        scene("light", "[[lights]]\ntype = §\"sun\"\n",
              {"\"sun\"", "point, spot, profile, beam, distant"}),
        scene("glass", "[materials.a]\ntype = \"glass\"\nglass = §\"schott/N-BK8\"\n",
              {"unknown glass \"schott/N-BK8\"", "did you mean schott/N-BK7?"}),
        scene("illuminant", "[materials.a]\ntype = \"black\"\nemission = §\"D66\"\n",
              {"unknown lamp \"D66\"", "did you mean illuminant/D65?"}),
        scene("lamp", "[materials.a]\ntype = \"black\"\nemission = {lamp = §\"led/cool-wite\"}\n",
              {"unknown lamp \"led/cool-wite\"", "did you mean led/cool-white?"}),
        scene("camera of no import", "[camera]\nfrom = §\"ring\"\n",
              {"there is no import \"ring\""}),
    });
}

#define PROFILE "[[lights]]\ntype = \"profile\"\nposition = [0, 2, 0]\n"
#define BEAM "[[lights]]\ntype = \"beam\"\nposition = [0, 2, 0]\n"
#define DOWN "direction = [0, -1, 0]\n"

TEST(WrongInput, Lights) {
    const std::string ies =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 90\n0\n100 0\n";
    const std::vector<File> lamp{{"a.ies", ies}};
    check({
        scene("profile of no file", "§" PROFILE, {"light 1 needs file"}),
        scene("profile not there", PROFILE "file = §\"b.ies\"\n", {"b.ies"}, lamp),
        scene("profile of noise", PROFILE "file = §\"b.ies\"\n", {"b.ies"},
              {{"b.ies", random_bytes(999)}}),
        scene("profile elsewhere", PROFILE "file = §\"../a.ies\"\n", {"leads out"}),
        scene("two sizes", PROFILE "file = \"a.ies\"\nscale = 2\n§luminous_flux_lm = 800\n",
              {"luminous_flux_lm"}, lamp),
        scene("two aims", "§" PROFILE DOWN "look_at = [0, 0, 0]\nfile = \"a.ies\"\n",
              {"has both direction and look_at; keep one"}, lamp),
        scene("aim at itself", "§" PROFILE "look_at = [0, 2, 0]\nfile = \"a.ies\"\n",
              {"looks at its own position"}, lamp),
        scene("lamp without light", "§" PROFILE "file = \"a.ies\"\nspectrum = 0\n",
              {"has a spectrum that is black"}, lamp),
        scene("beam without aim", "§" BEAM "radius_mm = 1\nirradiance = 1\n",
              {"light 1 needs direction or look_at"}),
        scene("beam without radius", "§" BEAM DOWN "irradiance = 1\n", {"light 1 needs radius_m"}),
        scene("beam without size", "§" BEAM DOWN "radius_mm = 1\n",
              {"light 1 needs irradiance or power_W"}),
        scene("two strengths", BEAM DOWN "radius_mm = 1\nirradiance = 1\n§power_W = 1\n",
              {"power_W"}),
        scene("negative power", BEAM DOWN "radius_mm = 1\npower_W = §-1\n", {"power_W is -1"}),
        scene("no radius", BEAM DOWN "radius_mm = §0\npower_W = 1\n", {"radius_mm is 0"}),
        scene("slip", BEAM DOWN "radius_mm = 1\npower_W = 1\n§spectrom = 1\n",
              {"did you mean \"spectrum\"?"}),
    });
}

TEST(WrongInput, SceneTypes) {
    check({
        scene("number for a table", "film = §3\n", {"[film] is the number 3; expected a table"}),
        scene("one for many", "§[shapes]\ntype = \"sphere\"\n", {"write [[shapes]] above each"}),
        scene("many for one", "§[[film]]\nwidth = 8\n", {"[film] is an array of 1"}),
        scene("text for a number", "[film]\nwidth = §\"8\"\n",
              {"width is the string \"8\"; expected a whole number"}),
        scene("boolean for a number", "[film]\nwidth = §true\n", {"width is the boolean true"}),
        scene("date for a number", "[render]\nseed = §2020-01-01\n", {"seed is a date"}),
        scene("number for a word", "[film]\nfilter = §1\n", {"filter is the number 1"}),
        scene("number for a point", "[camera]\nposition = §5\nlook_at = [0, 0, 0]\n",
              {"position is the number 5; expected an array of 3"}),
        scene("short point", "[camera]\nposition = §[0, 5]\nlook_at = [0, 0, 0]\n",
              {"position is an array of 2"}),
        scene("number for a flag", "[materials.a]\ntype = \"black\"\ntwo_sided_emission = §1\n",
              {"two_sided_emission is the number 1"}),
    });
}

TEST(WrongInput, SceneValues) {
    check({
        scene("camera at its target", "[camera]\nposition = [1, 2, 3]\nlook_at = §[1, 2, 3]\n",
              {"look_at is the position itself"}),
        scene("camera along up", "[camera]\nposition = [0, 5, 0]\nlook_at = §[0, 0, 0]\n",
              {"parallel to up", "give another up"}),
        scene("view of 0", CAMERA "vertical_fov_deg = §0\n", {"greater than 0 and less than 180"}),
        scene("view of 180", CAMERA "vertical_fov_deg = §180\n", {"vertical_fov_deg is 180"}),
        scene("view of nan", CAMERA "vertical_fov_deg = §nan\n", {"vertical_fov_deg is nan"}),
        scene("no width", "[film]\nwidth = §0\n", {"width is 0; it must be between 1 and 65536"}),
        scene("no samples", "[render]\nsamples_per_pixel = §0\n", {"samples_per_pixel is 0"}),
        scene("packet", "[render]\npacket = §3\n", {"packet is 3; it must be 1, 4, 8 or 16"}),
        scene("index below 1", "[materials.a]\ntype = \"glass\"\nior = §0.9\n",
              {"ior is 0.9; it must be between 1 and 10"}),
        scene("too rough", "[materials.a]\ntype = \"glass\"\nior = 1.5\nroughness = §2\n",
              {"roughness is 2; it must be between 0 and 1"}),
        scene("reflects too much", "[materials.a]\ntype = \"diffuse\"\nreflectance = §1.5\n",
              {"reflectance is 1.5; it must be between 0 and 1"}),
        scene("mix of itself",
              "[materials]\n§a = {type = \"mix\", first = \"a\", second = \"a\"}\n",
              {"the mix [materials.a] contains itself"}),
        scene("mix in a circle",
              "[materials]\n§a = {type = \"mix\", first = \"b\", second = \"c\"}\n"
              "b = {type = \"mix\", first = \"c\", second = \"a\"}\nc = {type = \"black\"}\n",
              {"the mix [materials.a] contains itself"}),
        scene("no size", GREY BALL "radius_m = §0\n", {"radius_m is 0"}),
        scene("infinite size", GREY BALL "radius_m = §inf\n", {"radius_m is inf"}),
        scene("squeezed flat", GREY BALL "radius_m = 1\nscale = §[1, 0, 1]\n",
              {"scale has the component 0"}),
        scene("turn about nothing", GREY BALL "radius_m = 1\nrotate_deg = [§[0, 0, 0, 9]]\n",
              {"the axis of rotate_deg[0] is zero"}),
        scene("negative light", "[[lights]]\ntype = \"environment\"\nradiance = §-1\n",
              {"radiance is -1; it must be between 0"}),
        scene("negative colour", "[[lights]]\ntype = \"environment\"\nradiance = [1, §-1, 1]\n",
              {"radiance[1] is -1"}),
        scene("wavelengths that descend",
              "[[lights]]\ntype = \"environment\"\nradiance = {lambda_nm = [500, §400], values = "
              "[1, 1]}\n",
              {"lambda_nm[1] is 400 after 500; wavelengths must ascend"}),
        scene("more wavelengths than values",
              "[[lights]]\ntype = \"environment\"\nradiance = {lambda_nm = [400, 500], values = "
              "§[1]}\n",
              {"values is an array of 1"}),
        scene("light without direction",
              "[[lights]]\ntype = \"distant\"\ndirection = §[0, 0, 0]\nirradiance = 1\n",
              {"direction has no direction"}),
    });
}

// ---- what a scene refers to --------------------------------------------------------------------

Row reference(const std::string& name, const std::string& file_name, Words phrases,
              std::vector<File> others = {}) {
    return scene(name, GREY MESH "file = §'" + file_name + "'\n", std::move(phrases),
                 std::move(others));
}

TEST(WrongInput, References) {
    const auto prepare = [](const Folder& folder) {
        std::filesystem::create_symlink("/etc/passwd", folder.path() / "link.obj");
        std::filesystem::create_symlink("/etc", folder.path() / "etc");
        ::mkfifo((folder.path() / "fifo.obj").c_str(), 0666);
    };
    check(
        {
            reference("missing", "missing.obj", {"missing.obj: cannot read: No such file"}),
            reference("empty", "", {"reference \"\" is empty"}),
            reference("above", "../secret.obj", {"leads out of the scene's folder"}),
            reference("above by a detour", "a/../../b.obj", {"leads out of the scene's folder"}),
            reference("absolute", "/etc/passwd", {"is absolute"}),
            reference("file:", "file:///etc/passwd", {"has a scheme"}),
            reference("http:", "http://localhost/a.obj", {"has a scheme"}),
            reference("drive", "C:/a.obj", {"has a scheme"}),
            reference("share", "\\\\host\\a.obj", {"backslash"}),
            reference("link out", "link.obj", {"leads out", "by a symbolic link"}),
            reference("folder out", "etc/passwd", {"leads out", "by a symbolic link"}),
            reference("shell", "|id", {"|id: ", "is no mesh format"}),
            reference("FIFO", "fifo.obj", {"it is a FIFO"}),
            reference("folder", ".", {"is no mesh format that is read", ".obj, .ply or .stl"}),
            reference("other format", "a.fbx",
                      {"\".fbx\" is no mesh format", ".obj, .ply or .stl"}),
            reference("wrong mesh", "a.obj", {"a.obj:2: ", "\"1,5\" is no number"},
                      {{"a.obj", "v 0 0 0\nv 1,5 0 0\n"}}),
            scene("import of a scene", "[[imports]]\nfile = §\"scene.toml\"\n",
                  {"imports no other scene file", "import .gltf, .glb, .obj, .ply or .stl"}),
            scene("import of another format", "[[imports]]\nfile = §\"a.fbx\"\n",
                  {"a.fbx: ", "no format that is imported",
                   "import .gltf, .glb, .obj, .ply or .stl"}),
            scene("wrong picture", "[[lights]]\ntype = \"environment\"\nfile = §\"a.exr\"\n",
                  {"a.exr: ", "not an OpenEXR file"}, {{"a.exr", random_bytes(999)}}),
            scene("wrong picture", "[[lights]]\ntype = \"environment\"\nfile = §\"a.hdr\"\n",
                  {"a.hdr: ", "not a Radiance HDR file"}, {{"a.hdr", random_bytes(999)}}),
            scene("other picture", "[[lights]]\ntype = \"environment\"\nfile = §\"a.jpg\"\n",
                  {"\".jpg\" is no environment picture", ".exr or .hdr"}),
            scene("override of none",
                  GREY "[[imports]]\nfile = \"a.obj\"\n[imports.materials]\n§defalt = \"grey\"\n",
                  {"unknown key \"defalt\"", "did you mean \"default\"?"},
                  {{"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}}),
        },
        prepare);
}

// ---- glTF --------------------------------------------------------------------------------------

using Parts = gltf_test::Parts;

TEST(WrongInput, Gltf) {
    const std::string position = R"("componentType": 5126, "type": "VEC3")";
    check({
        file("syntax", "a.gltf", "{\"asset\": {\"version\": \"2.0\"}, }",
             {"a.gltf:1:31: not JSON"}),
        file("no object", "a.gltf", "{}", {"needs \"asset\""}),
        file("version 1", "a.gltf", R"({"asset": {"version": "1.0"}})",
             {"/asset/version: this is glTF 1.0; glTF 2.0 is read"}),
        file("type", "a.gltf", R"({"asset": {"version": 2}})",
             {"/asset/version: is the number 2; expected a string"}),
        file("no scene", "a.gltf", R"({"asset": {"version": "2.0"}})", {"has no scene"}),
        gltf("unknown extension",
             [](Parts& p) { p.rest = R"(, "extensionsRequired": ["EXT_of_nobody"])"; },
             {"/extensionsRequired/0: ", "EXT_of_nobody"}),
        gltf("draco",
             [](Parts& p) {
                 p.primitive =
                     R"({"attributes": {"POSITION": 0}, "extensions": {"KHR_draco_mesh_compression":
                         {"bufferView": 0, "attributes": {"POSITION": 0}}}})";
             },
             {"KHR_draco_mesh_compression: ", "does not begin with \"DRACO\""}),
        gltf(
            "accessor",
            [&](Parts& p) { p.accessors = R"([{"bufferView": 0, "count": 9, )" + position + "}]"; },
            {"/accessors/0: asks for 9 elements", "inside /bufferViews/0 of 36"}),
        gltf("accessor of all memory",
             [&](Parts& p) { p.accessors = R"([{"count": 9007199254740991, )" + position + "}]"; },
             {"/accessors/0", "9007199254740991"}),
        gltf("no such accessor",
             [](Parts& p) { p.primitive = R"({"attributes": {"POSITION": 7}})"; },
             {"/attributes/POSITION: is 7; it must be a whole number between 0 and 1"}),
        gltf("index", [](Parts& p) { p.bytes[40] = 3; }, {"uses vertex 3; there are 3, from 0"}),
        gltf("cycle", [](Parts& p) { p.nodes = R"([{"children": [1]}, {"children": [0]}])"; },
             {"/nodes/1/children/0: node 0 has two parents"}),
        gltf("rotation of zero",
             [](Parts& p) { p.nodes = R"([{"mesh": 0, "rotation": [0, 0, 0, 0]}])"; },
             {"/nodes/0/rotation: is zero"}),
        gltf("above", [](Parts& p) { p.uri = "../secret.bin"; }, {"/buffers/0/uri: ", "leads out"}),
        gltf("above, encoded", [](Parts& p) { p.uri = "%2e%2e/secret.bin"; }, {"leads out"}),
        gltf("absolute", [](Parts& p) { p.uri = "/etc/passwd"; }, {"is absolute"}),
        gltf("file:", [](Parts& p) { p.uri = "file:///etc/passwd"; }, {"has a scheme"}),
        gltf("http:", [](Parts& p) { p.uri = "http://localhost/a"; }, {"has a scheme"}),
        gltf("missing", [](Parts& p) { p.uri = "missing.bin"; }, {"missing.bin: cannot read"}),
        gltf("lines that look like errors", [](Parts& p) { p.uri = "a\\ndewbow: b"; },
             {"a dewbow: b"}),
        gltf("names that write", [](Parts& p) { p.uri = "\\u001b]0;x\\u0007\\u009b"; },
             {"?]0;x??"}),
    });
}

TEST(WrongInput, Glb) {
    const std::string json = R"({"asset": {"version": "2.0"}})";
    const auto glb = [&](std::uint32_t version, std::uint32_t length, std::uint32_t chunk) {
        return "glTF" + gltf_test::bytes_of<std::uint32_t>({version, length, chunk}) + "JSON" +
               json;
    };
    const auto size = std::uint32_t(20 + json.size()), chunk = std::uint32_t(json.size());
    check({
        file("cut in the header", "a.glb", glb(2, size, chunk).substr(0, 9),
             {"byte 0: the file ends within its header"}),
        file("cut in the chunk", "a.glb", glb(2, size, chunk).substr(0, 30),
             {"byte 0: the header states"}),
        file("chunk too long", "a.glb", glb(2, size, 0xffffffffu), {"byte 12: a chunk states"}),
        file("version 1", "a.glb", glb(1, size, chunk), {"this is version 1 of .glb"}),
    });
}

// ---- meshes ------------------------------------------------------------------------------------

std::string ply(const std::string& vertices, const std::string& body) {
    return "ply\nformat ascii 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
           "property list uchar int vertex_indices\nend_header\n" +
           body;
}

TEST(WrongInput, Meshes) {
    check({
        file("no faces", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"holds no triangle"}),
        file("no area", "a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n",
             {"has no triangle with an area"}),
        file("nothing finite", "a.obj", "v nan 0 0\nv inf 0 0\nv 1e999 0 0\nf 1 2 3\n",
             {"a.obj:3: \"1e999\" is no number"}),
        file("nothing finite", "a.obj", "v nan 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n",
             {"no triangle that can be shown: 1 with a vertex that is not finite"}),
        file("no such vertex", "a.obj", "v 0 0 0\nf 1 2 3\n", {"a.obj:2: there is no vertex 2"}),
        file("no such vertex", "a.ply", ply("3", "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
             {"face 1 uses vertex 3; there are 3"}),
        file("more than the file holds", "a.ply", ply("1000000000000", "0 0 0\n"),
             {"there cannot be 1000000000000 elements"}),
        file("negative count", "a.ply", ply("-1", "0 0 0\n"), {"a.ply:3: "}),
        file("nothing finite", "a.ply", ply("3", "nan 0 0\n1 inf 0\n0 1 0\n3 0 1 2\n"),
             {"no triangle that can be shown: 1 with a vertex that is not finite"}),
    });
}

}  // namespace
}  // namespace dewbow::faults
