// SPDX-License-Identifier: Apache-2.0

// What the reader of scene.toml says of wrong scenes, and where. In each text § stands before the
// place that the error must name.

#include <gtest/gtest.h>

#include "dewbow/import/toml/scene_toml.h"

namespace dewbow {
namespace {

constexpr std::string_view kMark = "§";

struct WrongScene {
    const char* text;
    const char* phrase;  ///< in the sentence or the hint
};

// A material and a shape to go on with.
#define GREY "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n"
#define BALL "[[shapes]]\ntype = \"sphere\"\nmaterial = \"grey\"\n"
#define VIEW "[camera]\nposition = [0, 0, 5]\nlook_at = [0, 0, 0]\n"

#define SUN "[sky]\nsun = { altitude_deg = 20, azimuth_deg = 250 }\n"
#define DATE(date, time) \
    "[sky]\nsun = { date = " date ", time = \"" time "\", latitude_deg = 48, longitude_deg = 11 }"

constexpr WrongScene kWrongScenes[] = {
    // The document
    {"[camera§\nposition = 1", "not TOML"},
    {"§camra = 1", "did you mean \"camera\"?"},
    {"[film]\nwidth = 10\n[§filn]\nwidth = 10", "unknown key \"filn\""},
    {"film = §3", "[film] is the number 3; expected a table"},
    {"shapes = §\"x\"", "write [[shapes]]"},
    // [camera]
    {"§[camera]\nlook_at = [0, 0, 0]", "[camera] needs position"},
    {"[camera]\nposition = [0, 0, 1]\nlook_at = [0, 0, 0]\n§fov = 3",
     "unknown key \"fov\" in [camera]"},
    {"[camera]\nposition = §[0, 0]\nlook_at = [0, 0, 0]",
     "position is an array of 2; expected an array of 3"},
    {"[camera]\nposition = [0, §\"a\", 0]\nlook_at = [0, 0, 1]",
     "position[1] is the string \"a\"; expected a number"},
    {"[camera]\nposition = [0, §nan, 0]\nlook_at = [0, 0, 1]",
     "position[1] is nan; it must be between"},
    {"[camera]\nposition = [0, 0, §-inf]\nlook_at = [0, 0, 1]", "position[2] is -inf"},
    {"[camera]\nposition = [0, 0, 1]\nlook_at = §[0, 0, 1]", "look_at is the position itself"},
    {"[camera]\nposition = [0, 0, 0]\nlook_at = §[0, 5, 0]", "parallel to up"},
    {"[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, 1]\nup = §[0, 0, 0]", "up has no direction"},
    {"[camera]\nposition = [0, 0, 0]\nlook_at = [0, 0, 1]\nvertical_fov_deg = §180",
     "vertical_fov_deg is 180; it must be greater than 0 and less than 180"},
    {"[camera]\nposition = [0, 0, 0]\n§position_mm = [0, 0, 0]\nlook_at = [0, 0, 1]",
     "position and position_mm say the same thing"},
    {"[camera]\nfrom = §\"ring\"", "there is no import \"ring\""},
    {VIEW "projection = §\"ortographic\"", "did you mean \"orthographic\"?"},
    {"§" VIEW "projection = \"orthographic\"", "[camera] needs height_m"},
    {VIEW "projection = \"orthographic\"\nheight_m = §-2", "height_m is -2"},
    {VIEW "projection = \"panorama\"\n§vertical_fov_deg = 40", "unknown key \"vertical_fov_deg\""},
    {VIEW "projection = \"panorama\"\nlens = §{ f_number = 2 }",
     "[camera] is a panorama; only a perspective camera has a lens"},
    {VIEW "projection = \"orthographic\"\nheight_m = 2\nstereo = §{ separation_mm = 63 }",
     "[camera] is orthographic; only a perspective camera has a stereo"},
    {VIEW "lens = { aperture_radius_mm = §-5, focus_distance_m = 2 }", "aperture_radius_mm is -5"},
    {VIEW "lens = §{ focus_distance_m = 2 }",
     "lens of [camera] needs aperture_radius_mm, or f_number and focal_length_mm"},
    {VIEW "lens = §{ f_number = 2, focus_distance_m = 2 }", "needs focal_length_mm with it"},
    {VIEW "lens = §{ f_number = 2, focal_length_mm = 50, aperture_radius_mm = 3 }",
     "has both aperture_radius and f_number; keep one"},
    {VIEW "lens = §{ aperture_radius_mm = 5 }", "needs focus_distance_m or focus_on"},
    {VIEW "lens = §{ aperture_radius_mm = 5, focus_on = [0, 0, 6] }",
     "focuses on a point that does not lie in front of the camera"},
    {VIEW "lens = §{ f_number = 2, focal_length_mm = 50, focus_distance_mm = 40 }",
     "focuses on 0.04 m, which is not beyond its focal length, 0.05 m"},
    {VIEW "lens = §{ aperture_radius_mm = 5, focus_distance_m = 2, glass = \"N-BK7\" }",
     "is of glass and needs focal_length_mm"},
    {VIEW "lens = { aperture_radius_mm = 5, focus_distance_m = 2, blades = §2 }",
     "blades is 2; it must be between 3 and 64"},
    {VIEW "stereo = { separation_mm = 63, convergence_m = 3, layout = §\"sidebyside\" }",
     "did you mean \"side-by-side\"?"},
    {VIEW "stereo = §{ separation_mm = 63 }", "stereo of [camera] needs convergence_m"},
    {VIEW "stereo = { separation_mm = §0, convergence_m = 3 }", "separation_mm is 0"},
    {"cameras = §3", "write [cameras.NAME] above each"},
    {"[cameras]\nleft = §3", "[cameras.left] is the number 3; expected a table"},
    {"§[cameras.left]\nlook_at = [0, 0, 0]", "[cameras.left] needs position"},
    {"[camera]\nposition = [0, 0, 1]\nlook_at = [0, 0, 0]\n[cameras.§camera]\nfrom = \"ring\"",
     "[cameras.camera] has the name of [camera]"},
    // [film] and [render]
    {"[film]\nwidth = §0", "width is 0; it must be between 1 and 65536"},
    {"[film]\nwidth = §1.5", "width is the number 1.5; expected a whole number"},
    {"[film]\nwidth = §9223372036854775807", "must be between 1 and 65536"},
    {"[film]\nfilter = §\"gausian\"", "did you mean \"gaussian\"?"},
    {"[film]\nfilter_radius_px = §0", "filter_radius_px is 0; it must be between 0.1 and 16"},
    {"[film]\nexposure_stops = §1e308", "exposure_stops is 1e+308"},
    {"[film]\nwhite_luminance_cd_m2 = §-1", "white_luminance_cd_m2 is -1"},
    {"[film]\nspectral_bins = §true", "spectral_bins is the boolean true; expected a whole number"},
    {"[render]\nsamples_per_pixel = §-1",
     "samples_per_pixel is -1; it must be between 1 and 16777216"},
    {"[render]\npacket = §3", "packet is 3; it must be 1, 4, 8 or 16"},
    {"[render]\nwavelengths = §\"visible\"", "unknown wavelengths \"visible\""},
    {"[render]\nseed = §2020-01-01", "seed is a date or time; expected a whole number"},
    // [materials]
    {"§[materials.a]", "[materials.a] needs type"},
    {"[materials.a]\ntype = §\"difuse\"", "did you mean \"diffuse\"?"},
    {"[materials.a]\ntype = \"diffuse\"\nreflectance = 1\n§rougness = 1",
     "unknown key \"rougness\" in [materials.a]"},
    {"[materials.a]\ntype = \"metallic-roughness\"\nbase_colour = 1\n§rougness = 1",
     "did you mean \"roughness\"?"},
    {"[materials.a]\ntype = \"diffuse\"\nreflectance = §1.5",
     "reflectance is 1.5; it must be between 0 and 1"},
    {"[materials.a]\ntype = \"diffuse\"\nreflectance = [0, §2, 0]", "reflectance[1] is 2"},
    {"[materials.a]\ntype = \"glass\"\nglass = §\"schott/N-BK8\"", "schott/N-BK7"},
    {"§[materials.a]\ntype = \"glass\"", "needs one of glass, dispersion, ior, eta_red"},
    {"[materials.a]\ntype = \"glass\"\n§eta_rad = 4.2\nw = 0.5", "did you mean \"eta_red\"?"},
    {"§[materials.a]\ntype = \"glass\"\neta_red = 4.2", "needs w"},
    {"[materials.a]\ntype = \"glass\"\nglass = \"water\"\n§w = 0.5", "has both glass and w"},
    {"[materials.a]\ntype = \"glass\"\nior = 1.5\n§index_reading = \"exact\"",
     "has both ior and index_reading"},
    {"[materials.a]\ntype = \"glass\"\neta_red = §0.9\nw = 0.5",
     "eta_red is 0.9; it must be between 1 and 10"},
    {"[materials.a]\ntype = \"glass\"\neta_red = 1.5\nw = §-1", "w is -1"},
    {"[materials.a]\ntype = \"glass\"\neta_red = §4.2\nw = 3", "expected 1 to 10"},
    {"[materials.a]\ntype = \"glass\"\neta_red = §4.2\nw = 0.5\nindex_reading = \"printed\"",
     "-3.42 at the far violet"},
    {"[materials.a]\ntype = \"glass\"\neta_red = §1.1\nw = 1.3\nindex_reading = \"exact\"",
     "below w = 1.19"},
    {"[materials.a]\ntype = \"glass\"\neta_red = 4.2\nw = 0.5\nindex_reading = §\"exakt\"",
     "did you mean \"exact\"?"},
    {"[materials.a]\ntype = \"glass\"\nior = 1.5\n§glass = \"water\"", "has both ior and glass"},
    {"[materials.a]\ntype = \"glass\"\nior = §0.5", "ior is 0.5; it must be between 1 and 10"},
    {"[materials.a]\ntype = \"glass\"\nior = 1.5\nabbe = §0", "abbe is 0"},
    {"[materials.a]\ntype = \"glass\"\ndispersion = {form = §\"selmeier\", coefficients = [1]}",
     "did you mean \"sellmeier\"?"},
    {"[materials.a]\ntype = \"glass\"\ndispersion = §{form = \"sellmeier\", coefficients = [1]}",
     "coefficients"},
    {"[materials.a]\ntype = \"glass\"\ndispersion = {form = \"constant\", coefficients = [1], "
     "§refrence = \"air\"}",
     "did you mean \"reference\"?"},
    {"§[materials.a]\ntype = \"glass\"\nior = 1.5\nabsorption_colour = [0.5, 0.5, 0.5]",
     "needs absorption_depth_m"},
    {"[materials.a]\ntype = \"glass\"\nior = 1.5\nabsorption_per_m = §[1, 2, 3]", "is no colour"},
    {"[surroundings]\nglass = \"air\"\nscattering_per_m = §[1, 2, 3]",
     "write a number or { lambda_nm, values }"},
    {"[surroundings]\nglass = \"air\"\nscattering_per_m = 1\nanisotropy = §1", "anisotropy is 1"},
    {"§[surroundings]\nglass = \"air\"\nanisotropy = 0.5",
     "has anisotropy, but no scattering_per_m"},
    {"[surroundings]\nglass = \"air\"\n§scatering_per_m = 1", "did you mean \"scattering_per_m\"?"},
    {"[materials.a]\ntype = \"mix\"\nfirst = §\"b\"\nsecond = \"a\"", "there is no material \"b\""},
    {"[materials.a]\ntype = \"black\"\nemission = §\"D66\"", "did you mean illuminant/D65?"},
    {"[materials.a]\ntype = \"black\"\nemission = §\"led/cold-white\"",
     "unknown lamp \"led/cold-white\""},
    {"[materials.a]\ntype = \"black\"\nemission = {lamp = §\"laser/henna\"}",
     "did you mean laser/hene?"},
    {"[materials.a]\ntype = \"black\"\nemission = {lamp = §3}", "3"},
    {"[materials.a]\ntype = \"black\"\nemission = {lamp = \"hene\", §illuminant = \"A\"}",
     "illuminant"},
    {"[materials.a]\ntype = \"diffuse\"\nreflectance = §\"led/cool-white\"", "reflectance"},
    {"[materials.a]\ntype = \"black\"\nemission = {illuminant = \"D65\", §scal = 3}",
     "did you mean \"scale\"?"},
    {"[materials.a]\ntype = \"black\"\nemission = {blackbody_K = §3}",
     "blackbody_K is 3; it must be between 500"},
    {"[materials.a]\ntype = \"black\"\nemission = {lambda_nm = [500, §400], values = [1, 1]}",
     "must ascend"},
    {"[materials.a]\ntype = \"black\"\nemission = {lambda_nm = [500, 600], values = §[1]}",
     "expected an array of 2"},
    {"[materials.a]\ntype = \"black\"\nemission = {lambda_nm = [§100], values = [1]}",
     "between 200 and 3000"},
    {"[materials.a]\ntype = \"black\"\nemission = {lines_nm = [§900], strengths = [1]}",
     "between 360 and 830"},
    {"[materials.a]\ntype = \"black\"\nemission = §{scale = 2}", "needs one of rgb, illuminant"},
    {"[materials.a]\ntype = \"black\"\nemission = §{rgb = [0, 0, 0], luminance_cd_m2 = 5}",
     "is black"},
    // [[shapes]]
    {GREY BALL "radius_m = §0", "radius_m is 0; it must be between 1e-12 and"},
    {GREY BALL "radius_mm = §-3", "radius_mm is -3"},
    {GREY "§" BALL, "shape 1 needs radius_m (or radius_cm or radius_mm)"},
    {"[camera]\nlook_at = [0, 0, 0]\n§positon = [0, 0, 1]", "did you mean \"position\"?"},
    {GREY BALL "§radius = 1", "did you mean \"radius_m\"?"},
    {GREY BALL "radius_m = 1\n§radius_cm = 100", "say the same thing"},
    {GREY "[[shapes]]\ntype = §\"cone\"", "unknown shape type \"cone\""},
    {GREY "[[shapes]]\ntype = \"plane\"\nmaterial = §\"gray\"", "did you mean \"grey\"?"},
    {GREY BALL "radius_m = 1\nscale = §0", "scale is 0"},
    {GREY BALL "radius_m = 1\nscale = §[1, 0, 1]", "scale has the component 0"},
    {GREY BALL "radius_m = 1\nrotate_deg = [§[0, 0, 0, 90]]", "the axis of rotate_deg[0] is zero"},
    {GREY BALL "radius_m = 1\nrotate_deg = §90", "expected [[axis x, y, z, angle], …]"},
    {GREY BALL "radius_m = 1\nlook_at = [0, 0, 1]\nrotate_x_deg = §1",
     "both look_at and rotate_x_deg"},
    {GREY
     "[[shapes]]\ntype = \"prism\"\nmaterial = \"grey\"\napex_deg = §180\nside_m = 1\nlength_m = 1",
     "apex_deg is 180"},
    {GREY "[[shapes]]\ntype = \"mesh\"\nmaterial = \"grey\"\nfile = §\"../x.obj\"", "x.obj"},
    {GREY "[[shapes]]\ntype = \"mesh\"\nmaterial = \"grey\"\nfile = §\"no-such-file.obj\"",
     "no-such-file.obj"},
    // [[lights]]
    {"§[[lights]]\ntype = \"point\"\nposition = [0, 0, 0]", "light 1 needs intensity"},
    {"[[lights]]\ntype = §\"sun\"", "unknown light type \"sun\""},
    {"[[lights]]\ntype = \"distant\"\ndirection = §[0, 0, 0]\nirradiance = 1",
     "direction has no direction"},
    {"[[lights]]\ntype = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nouter_deg = "
     "§91\nintensity = 1",
     "outer_deg is 91; it must be greater than 0 and at most 90"},
    {"[[lights]]\ntype = \"spot\"\nposition = [0, 0, 0]\ndirection = [0, 0, 1]\nouter_deg = "
     "9\ninner_deg = §9\n"
     "intensity = 1",
     "inner_deg is 9; it must be at least 0 and less than 9"},
    {"[[lights]]\ntype = \"environment\"\nradiance = 1\n§file = \"x.exr\"",
     "has both radiance and file"},
    {"[[lights]]\ntype = \"environment\"\nfile = §\"/etc/passwd\"", "/etc/passwd"},
    // [sky]
    {"sky = §\"clear\"", "[sky] is the string \"clear\"; expected a table"},
    {"§[sky]\nvisibility_km = 60", "needs sun = { altitude_deg, azimuth_deg }"},
    {"[sky]\nkind = §\"overcst\"", "did you mean \"overcast\"?"},
    {SUN "§visibilty_km = 60", "did you mean \"visibility_km\"?"},
    {SUN "visibility_km = §0.2", "visibility_km is 0.2; it must be between 1 and 330"},
    {SUN "visibility_km = 60\n§aerosol_depth = 0.1", "has both visibility_km and aerosol_depth"},
    {SUN "§moon = { altitude_deg = 20, azimuth_deg = 0 }", "has both sun and moon"},
    {"§[sky]\nkind = \"night\"\nsun = { altitude_deg = 20, azimuth_deg = 0 }",
     "is a night and has a sun"},
    {"§[sky]\nkind = \"overcast\"\nmoon = { altitude_deg = 20, azimuth_deg = 0 }",
     "is overcast and has a moon"},
    {"[sky]\nkind = \"overcast\"\nsun = { altitude_deg = 20, azimuth_deg = 0 }\n§ozone_dobson = 1",
     "unknown key \"ozone_dobson\""},
    {"[sky]\nsun = §{ altitude_deg = -3.5, azimuth_deg = 0 }",
     "puts the sun 3.50° below the horizon"},
    {"[sky]\nmoon = §{ altitude_deg = -1, azimuth_deg = 0 }",
     "puts the moon 1.00° below the horizon"},
    {"[sky]\nmoon = { altitude_deg = 1, azimuth_deg = 0, phase_deg = §120 }",
     "phase_deg is 120; it must be between 0 and 97"},
    {"[sky]\nsun = { altitude_deg = §91, azimuth_deg = 0 }", "altitude_deg is 91"},
    {"[sky]\nsun = §{ altitude_deg = 20 }", "needs azimuth_deg"},
    {"[sky]\nsun = { date = \"2026-06-21\", §altitude_deg = 20, azimuth_deg = 1 }",
     "has both date and altitude_deg; keep one"},
    {"[sky]\nsun = §{ date = \"2026-06-21\" }", "needs time"},
    {DATE("§\"2026-02-29\"", "12:00"), "there is no 29 February in 2026"},
    {DATE("§\"2026-06-21\"", "25:00"), "there is no 25:00 o'clock"},
    {"[sky]\nsun = §{ date = \"2026-12-21\", time = \"23:00\", latitude_deg = 48, longitude_deg = "
     "0 }",
     "below the horizon"},
    {SUN "cloud = §{ }", "needs azimuth_deg"},
    {SUN "cloud = §{ azimuth_deg = 0, bottom_deg = 30, top_deg = 20 }",
     "the upper edge of a bank of cloud must be above its lower edge"},
    {SUN "cloud = { azimuth_deg = 0, §softnes_deg = 20 }", "did you mean \"softness_deg\"?"},
    // [surroundings] and [[imports]]
    {"[surroundings]\nglass = §\"watr\"", "water"},
    {"[[imports]]\nfile = §\"other.toml\"", "imports no other scene file"},
    {"§[[imports]]\nname = \"ring\"", "import 1 needs file"},
};

struct Expected {
    std::string text;
    std::size_t line = 0, column = 0;
};

/// Takes the mark out and says where it stood.
Expected without_mark(const std::string& marked) {
    const std::size_t at = marked.find(kMark);
    Expected expected{marked, 1, 1};
    expected.text.erase(at, kMark.size());
    for (std::size_t i = 0; i < at; ++i) {
        if (marked[i] == '\n') ++expected.line;
        expected.column = marked[i] == '\n' ? 1 : expected.column + 1;
    }
    return expected;
}

class WrongSceneTest : public testing::TestWithParam<WrongScene> {};

TEST_P(WrongSceneTest, SaysWhatAndWhere) {
    const Expected expected = without_mark(GetParam().text);
    try {
        parse_scene_toml("scene.toml", expected.text);
        FAIL() << "this scene was taken:\n" << expected.text;
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find(GetParam().phrase), std::string::npos) << message;
        EXPECT_EQ(error.place().line, expected.line) << message;
        EXPECT_EQ(error.place().column, expected.column) << message;
    }
}

INSTANTIATE_TEST_SUITE_P(Toml, WrongSceneTest, testing::ValuesIn(kWrongScenes));

// A message as a whole, as the user sees it.
TEST(SceneTomlErrors, ShowTheLine) {
    try {
        parse_scene_toml("scene.toml", "[film]\nwidth = 10\nheigth = 20\n");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "scene.toml:3:1: unknown key \"heigth\" in [film]\n"
                     "  3 | heigth = 20\n"
                     "    | ^\n"
                     "  hint: did you mean \"height\"?");
    }
}

}  // namespace
}  // namespace dewbow
