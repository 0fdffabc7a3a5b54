// SPDX-License-Identifier: Apache-2.0

// What right scenes become.

#include "dewbow/import/toml/scene_toml.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/lamp.h"

namespace dewbow {
namespace {

/// Rounding of a handful of multiplications by numbers near 1, in double.
constexpr double kRounding = 1e-12;

ParsedScene parse(const std::string& text) { return parse_scene_toml("scene.toml", text); }

double at(const SpectrumPtr& spectrum, double lambda_nm) {
    return (*spectrum)(lambda_nm * unit::nm);
}
double index_at(const DispersionPtr& index, double lambda_nm) {
    return (*index)(lambda_nm * unit::nm).value;
}

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, kRounding);
    EXPECT_NEAR(a.y, b.y, kRounding);
    EXPECT_NEAR(a.z, b.z, kRounding);
}

/// The surface of a material table with these lines.
Material material(const std::string& lines) {
    return parse("[materials.a]\n" + lines).scene.materials.at(0);
}
template <class Surface>
Surface surface(const std::string& lines) {
    return std::get<Surface>(material(lines).surface);
}
SpectrumPtr emission(const std::string& value) {
    return material("type = \"black\"\nemission = " + value).emission;
}

/// A shape with these lines, in a grey material.
Shape shape(const std::string& lines) {
    return parse(
               "[materials.grey]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\nmaterial = "
               "\"grey\"\n" +
               lines)
        .scene.shapes.at(0);
}
Vec3 world(const Shape& s, Vec3 p) { return s.world_from_object(Point<Object>{p}).v; }

TEST(SceneToml, NothingIsAnEmptyScene) {
    const ParsedScene parsed = parse("# nothing\n");
    EXPECT_TRUE(parsed.scene.shapes.empty());
    EXPECT_TRUE(parsed.scene.cameras.empty());
    EXPECT_EQ(parsed.scene.film.width, Film{}.width);
    EXPECT_EQ(parsed.scene.surroundings->index, air());
}

TEST(SceneToml, LensesStereoPairsAndProjections) {
    const ParsedScene parsed = parse(R"(
        [cameras.lens]
        position = [0, 0, 5]
        look_at = [0, 0, 0]
        lens = { f_number = 2, focal_length_mm = 80, focus_on = [1, 2, 1], blades = 6, glass = "N-BK7" }
        stereo = { separation_mm = 63, convergence_m = 3, layout = "over-under" }
        [cameras.plan]
        position = [0, 5, 0]
        look_at = [0, 0, 0]
        up = [0, 0, -1]
        projection = "orthographic"
        height_cm = 250
        [cameras.round]
        position = [0, 1, 0]
        look_at = [0, 1, -1]
        projection = "panorama"
    )");
    const auto& cameras = parsed.scene.cameras;
    ASSERT_EQ(cameras.size(), 3u);
    EXPECT_EQ(cameras[0].name, "lens");
    EXPECT_NEAR(cameras[0].lens->aperture_radius.to(unit::mm), 20.0, kRounding);
    EXPECT_NEAR(cameras[0].lens->focus_distance.to(unit::m), 4.0, kRounding);
    EXPECT_EQ(cameras[0].lens->blades, 6);
    EXPECT_NEAR(cameras[0].lens->glass->focal_length.to(unit::m), 0.08, kRounding);
    EXPECT_NEAR(cameras[0].stereo->separation.to(unit::mm), 63.0, kRounding);
    EXPECT_NEAR(cameras[0].stereo->convergence.to(unit::m), 3.0, kRounding);
    EXPECT_EQ(cameras[0].stereo->layout, StereoLayout::over_under);
    EXPECT_EQ(std::get<Orthographic>(cameras[1].projection).height.to(unit::m), 2.5);
    EXPECT_TRUE(std::holds_alternative<Panorama>(cameras[2].projection));
}

TEST(SceneToml, CameraFilmAndRender) {
    const ParsedScene parsed = parse(R"(
        [camera]
        position_cm = [0, 100, 500]
        look_at = [0, 1, 0]
        vertical_fov_deg = 25
        [film]
        width = 320
        height = 200
        filter = "gaussian"
        filter_radius_px = 2.5
        exposure_stops = -1.5
        white_luminance_cd_m2 = 250
        spectral_bins = 47
        [render]
        samples_per_pixel = 9
        seed = 1234567890123
        packet = 16
        wavelengths = "uniform"
        max_depth = 12
        roulette_depth = 3
    )");
    ASSERT_EQ(parsed.scene.cameras.size(), 1u);
    const CameraView& camera = parsed.scene.cameras[0];
    expect_near(camera.world_from_camera(Point<Camera>{}).v, {0, 1, 5});
    expect_near(camera.world_from_camera(Dir<Camera>{{0, 0, -1}}).v, {0, 0, -1});
    EXPECT_NEAR(std::get<Perspective>(camera.projection).vertical_field_of_view.to(unit::deg), 25.0,
                kRounding);
    const Film& film = parsed.scene.film;
    EXPECT_EQ(film.width, 320);
    EXPECT_EQ(film.height, 200);
    EXPECT_EQ(film.filter.kind, FilterKind::gaussian);
    EXPECT_EQ(film.filter.radius, 2.5);
    EXPECT_EQ(film.exposure_stops, -1.5);
    EXPECT_EQ(film.white_luminance, 250.0);
    EXPECT_EQ(film.spectral_bins, 47);
    const RenderSettings& render = parsed.scene.render;
    EXPECT_EQ(render.samples_per_pixel, 9);
    EXPECT_EQ(render.seed, 1234567890123u);
    EXPECT_EQ(render.packet, 16);
    EXPECT_EQ(render.wavelengths, WavelengthSampling::uniform);
    EXPECT_EQ(render.max_depth, 12);
    EXPECT_EQ(render.roulette_depth, 3);
}

TEST(SceneToml, ABoxFilterIsOnePixelWide) {
    EXPECT_EQ(parse("[film]\nfilter = \"box\"").scene.film.filter.radius, 0.5);
}

TEST(SceneTomlMaterials, EachType) {
    EXPECT_EQ(
        at(surface<Diffuse>("type = \"diffuse\"\nreflectance = 0.3").reflectance.spectrum, 500),
        0.3);
    EXPECT_EQ(at(surface<Mirror>("type = \"mirror\"").reflectance.spectrum, 500), 1.0);
    material("type = \"black\"");
    const auto thin =
        surface<ThinDielectric>("type = \"thin-glass\"\nglass = \"water\"\ntint = [0.5, 0.5, 0.5]");
    EXPECT_NEAR(index_at(thin.index, 589.3), 1.3334, 5e-4);
    EXPECT_NEAR(at(thin.tint.spectrum, 500), 0.5, 1e-6);
    const auto metal = surface<MetallicRoughness>(
        "type = \"metallic-roughness\"\nbase_colour = 0.9\nmetalness = 0.25\nroughness = "
        "0.125\nior = 1.4");
    EXPECT_EQ(metal.metalness, 0.25);
    EXPECT_EQ(metal.roughness, 0.125);
    EXPECT_EQ(metal.ior, 1.4);
}

TEST(SceneTomlMaterials, GlassByNameByFormulaByNumber) {
    const auto named = surface<Dielectric>(
        "type = \"glass\"\nglass = \"schott/N-BK7\"\npriority = 7\nroughness = 0.2");
    const double n_air = index_at(air(), kLined.to(unit::nm));
    EXPECT_NEAR(index_at(named.interior->index, kLined.to(unit::nm)) / n_air, 1.5168, 1e-5);
    EXPECT_EQ(named.interior->priority, 7);
    EXPECT_EQ(named.interior->name, "a");
    EXPECT_EQ(named.roughness, 0.2);
    const auto formula = surface<Dielectric>(
        "type = \"glass\"\ndispersion = {form = \"cauchy\", coefficients = [1.5, 0.004], reference "
        "= \"vacuum\"}");
    EXPECT_NEAR(index_at(formula.interior->index, 500), 1.5 + 0.004 / 0.25, kRounding);
    const auto number = surface<Dielectric>("type = \"glass\"\nior = 1.5\nabbe = 30");
    EXPECT_NEAR(abbe_number(*number.interior->index, *air()), 30.0,
                0.02);  // the form's constants have 4 digits
}

// η + w (η − 1)/0.76 at the far violet; exact η + w (η − 1)/(κ − w f_D), with κ and f_D 0.3859 and
// 0.3231 in frequency, 0.4052 and 0.5013 in wavelength.
TEST(SceneTomlMaterials, ThePapersIndex) {
    constexpr double kFourFigures = 5e-3;
    const auto at_violet = [](const char* lines) {
        const auto glass = surface<Dielectric>("type = \"glass\"\nw = 0.5\n" + std::string(lines));
        return index_at(glass.interior->index, 380) / index_at(air(), 380);
    };
    EXPECT_NEAR(at_violet("eta_red = 4.2"), 6.3053, kFourFigures);
    EXPECT_NEAR(at_violet("eta_red = 2\nindex_reading = \"exact\""), 2.0 + 0.5 / 0.22435,
                kFourFigures);
    EXPECT_NEAR(at_violet("eta_red = 2\nindex_reading = \"exact\"\nindex_spacing = \"wavelength\""),
                2.0 + 0.5 / 0.15455, kFourFigures);
}

TEST(SceneTomlMaterials, AirInAirIsTheSameFunction) {
    for (const char* lines :
         {"ior = 1", "eta_red = 1\nw = 0.5", "glass = \"air\"", "glass = \"fluid/air\""}) {
        EXPECT_EQ(surface<Dielectric>("type = \"glass\"\n" + std::string(lines)).interior->index,
                  air());
    }
    EXPECT_EQ(parse("[surroundings]\nglass = \"vacuum\"").scene.surroundings->index, vacuum());
}

TEST(SceneTomlMaterials, Absorption) {
    const auto colour = surface<Dielectric>(
        "type = \"glass\"\nior = 1.5\nabsorption_colour = [0.5, 0.5, 0.5]\nabsorption_depth_mm = "
        "10");
    EXPECT_NEAR(at(colour.interior->absorption, 550), std::log(2.0) / 0.01, 1e-4);
    const auto table = surface<Dielectric>(
        "type = \"glass\"\nior = 1.5\nabsorption_per_m = {lambda_nm = [400, 600], values = [2, 4], "
        "scale = 10}");
    EXPECT_NEAR(at(table.interior->absorption, 500), 30.0, kRounding);
    EXPECT_NEAR(at(table.interior->absorption, 800), 40.0, kRounding);  // held
}

TEST(SceneTomlMaterials, Scattering) {
    const auto phase = [](const Medium& medium, double cosine) {
        const std::array<double, 1> lambda_nm{550.0};
        std::array<double, 1> p;
        medium.phase->eval_lanes(cosine, lambda_nm, p);
        return p[0];
    };
    const auto milk = surface<Dielectric>(
        "type = \"glass\"\nior = 1.35\nscattering_per_m = {lambda_nm = [400, 600], values = [4, "
        "2]}");
    EXPECT_NEAR(at(milk.interior->scattering, 500), 3.0, kRounding);
    EXPECT_NEAR(at(milk.interior->scattering, 800), 2.0, kRounding);  // held
    EXPECT_NEAR(phase(*milk.interior, 1.0), 0.25 / std::numbers::pi, kRounding);
    const MediumPtr air = parse(
                              "[surroundings]\nglass = \"air\"\nscattering_per_m = 0.1\n"
                              "anisotropy = 0.5")
                              .scene.surroundings;
    EXPECT_NEAR(at(air->scattering, 500), 0.1, kRounding);
    // (1 + g) / (1 − g)² / 4π forward.
    EXPECT_NEAR(phase(*air, 1.0), 1.5 / std::numbers::pi, kRounding);
}

TEST(SceneTomlMaterials, MixesNameWhatStandsBelow) {
    const ParsedScene parsed = parse(R"(
        [materials.z]
        type = "mix"
        first = "a"
        second = "b"
        second_share = 0.25
        [materials.b]
        type = "mirror"
        [materials.a]
        type = "black")");
    const auto& mix = std::get<Mix>(parsed.scene.materials.at(0).surface);
    EXPECT_EQ(parsed.scene.materials[std::size_t(mix.first)].name, "a");
    EXPECT_EQ(parsed.scene.materials[std::size_t(mix.second)].name, "b");
    EXPECT_EQ(mix.second_share, 0.25);
}

TEST(SceneTomlSpectra, OfLight) {
    EXPECT_EQ(at(emission("2.5"), 500), 2.5);
    EXPECT_NEAR(at(emission("\"D65\""), 560), at(find_illuminant("D65"), 560), kRounding);
    EXPECT_NEAR(at(emission("{illuminant = \"A\", scale = 3}"), 560),
                3 * at(find_illuminant("A"), 560), kRounding);
    EXPECT_EQ(at(emission("\"led/cool-white\""), 560),
              at(find_lamp("led/cool-white").spectrum, 560));
    EXPECT_NEAR(at(emission("{lamp = \"HeNe\", scale = 5}"), 633),
                5 * at(find_lamp("laser/hene").spectrum, 633), kRounding);
    EXPECT_NEAR(at(emission("{blackbody_K = 3200, scale = 2}"), 560),
                2 * at(make_blackbody(3200.0 * unit::K), 560), kRounding);
    const auto table = emission("{lambda_nm = [500, 600], values = [1, 3]}");
    EXPECT_NEAR(at(table, 550), 2.0, kRounding);
    EXPECT_EQ(at(table, 601), 0.0);
    const auto lines = emission("{lines_nm = [546, 436], strengths = [4, 2], width_nm = 2}");
    EXPECT_NEAR(at(lines, 546), 2.0, kRounding);
    EXPECT_NEAR(at(lines, 436.5), 1.0, kRounding);
    EXPECT_EQ(at(lines, 500), 0.0);
    // (1,1,1) is as bright as the constant 1.
    EXPECT_NEAR(xyz_from_spectrum(*emission("[1, 1, 1]"))[1], cie_y_integral(),
                1e-3 * cie_y_integral());
}

TEST(SceneTomlSpectra, PhotometricSizes) {
    const double luminance =
        kLuminousEfficacy *
        xyz_from_spectrum(*emission("{illuminant = \"A\", luminance_cd_m2 = 500}"))[1];
    EXPECT_NEAR(luminance, 500.0, 1e-6);
    const auto sodium = emission("{lamp = \"lamp/sodium-low-pressure\", luminance_cd_m2 = 80}");
    EXPECT_NEAR(kLuminousEfficacy * xyz_from_spectrum(*sodium)[1], 80.0, 1e-9);
    const ParsedScene parsed = parse(R"(
        [[lights]]
        type = "distant"
        direction = [0, -2, 0]
        irradiance = {rgb = [1, 0.9, 0.8], illuminance_lx = 1e5}
        angular_radius_deg = 0.2666)");
    const auto& sun = std::get<DistantLight>(parsed.scene.lights.at(0));
    EXPECT_NEAR(kLuminousEfficacy * xyz_from_spectrum(*sun.irradiance)[1], 1e5, 1e-3);
    expect_near(sun.direction.v, {0, -1, 0});
    EXPECT_NEAR(sun.angular_radius.to(unit::deg), 0.2666, kRounding);
}

TEST(SceneTomlShapes, EachTypeInItsUnits) {
    EXPECT_NEAR(
        std::get<Sphere>(shape("type = \"sphere\"\nradius_mm = 5").geometry).radius.to(unit::m),
        0.005, kRounding);
    EXPECT_NEAR(std::get<Disc>(shape("type = \"disc\"\nradius_cm = 5").geometry).radius.to(unit::m),
                0.05, kRounding);
    const auto rectangle =
        std::get<Rectangle>(shape("type = \"rectangle\"\nwidth_m = 1\nheight_cm = 2").geometry);
    EXPECT_NEAR(rectangle.height.to(unit::m), 0.02, kRounding);
    const auto box =
        std::get<Box>(shape("type = \"box\"\nwidth_m = 1\nheight_m = 2\ndepth_m = 3").geometry);
    EXPECT_NEAR(box.depth.to(unit::m), 3.0, kRounding);
    const auto prism = std::get<Prism>(
        shape("type = \"prism\"\napex_deg = 60\nside_m = 1\nlength_m = 2").geometry);
    EXPECT_NEAR(prism.apex.to(unit::deg), 60.0, kRounding);
    const Shape plane = shape("type = \"plane\"");
    EXPECT_TRUE(std::holds_alternative<Plane>(plane.geometry));
    EXPECT_EQ(plane.name, "plane 1");
}

TEST(SceneTomlShapes, AreScaledThenTurnedThenMoved) {
    const Shape turned =
        shape("type = \"plane\"\nscale = [2, 1, 1]\nrotate_z_deg = 90\nposition = [5, 0, 0]");
    expect_near(world(turned, {1, 0, 0}), {5, 2, 0});
    // x first, then y: z goes to −y, and stays there.
    const Shape named = shape("type = \"plane\"\nrotate_y_deg = 90\nrotate_x_deg = 90");
    expect_near(world(named, {0, 0, 1}), {0, -1, 0});
    // y first, then x: z goes to x, and stays there.
    const Shape listed = shape("type = \"plane\"\nrotate_deg = [[0, 3, 0, 90], [1, 0, 0, 90]]");
    expect_near(world(listed, {0, 0, 1}), {1, 0, 0});
}

TEST(SceneTomlShapes, LookAtTurnsTheNormal) {
    const Shape aimed =
        shape("type = \"disc\"\nradius_m = 1\nposition = [0, 4, 3]\nlook_at = [0, 0, 0]");
    expect_near(world(aimed, {0, 0, 5}), {0, 0, 0});
    EXPECT_NEAR(world(aimed, {1, 0, 0}).y, 4.0, kRounding);  // x stays level
    const Shape down =
        shape("type = \"disc\"\nradius_m = 1\nposition = [0, 4, 0]\nlook_at = [0, 0, 0]");
    expect_near(world(down, {0, 0, 4}), {0, 0, 0});
}

TEST(SceneTomlShapes, MirrorImagesAreUndone) {
    const Shape mirrored =
        shape("type = \"sphere\"\nradius_m = 1\nscale = [1, 1, -2]\nposition = [0, 0, 3]");
    EXPECT_GT(mirrored.world_from_object.affine().determinant(), 0.0);
    expect_near(world(mirrored, {0, 0, 1}), {0, 0, 1});
}

TEST(SceneTomlLights, EachType) {
    const ParsedScene parsed = parse(R"(
        [[lights]]
        type = "point"
        position = [1, 2, 3]
        intensity = 4
        [[lights]]
        type = "spot"
        position = [0, 5, 0]
        look_at = [0, 0, 0]
        inner_deg = 10
        outer_deg = 20
        intensity = "A"
        [[lights]]
        type = "environment"
        radiance = [0.1, 0.2, 0.3]
        [[lights]]
        type = "studio"
        scale = 0.5
        rotate_y_deg = 90)");
    const auto& lights = parsed.scene.lights;
    expect_near(std::get<PointLight>(lights.at(0)).position.v, {1, 2, 3});
    const auto& spot = std::get<SpotLight>(lights.at(1));
    expect_near(spot.direction.v, {0, -1, 0});
    EXPECT_NEAR(spot.inner.to(unit::deg), 10.0, kRounding);
    EXPECT_NEAR(spot.outer.to(unit::deg), 20.0, kRounding);
    EXPECT_TRUE(std::holds_alternative<UniformEnvironment>(lights.at(2)));
    const auto& studio = *std::get<std::shared_ptr<const ImageEnvironment>>(lights.at(3));
    EXPECT_EQ(studio.scale, 0.5);
    expect_near(studio.world_from_object(Dir<Object>{{0, 0, -1}}).v, {-1, 0, 0});
}

/// Power of the whole disc, and flux of the whole web, are what the file says.
TEST(SceneToml, BeamsAndProfilesHaveTheirPower) {
    constexpr double kLines = 1e-3;  // steps of the quadrature across the edges of a line
    const ParsedScene parsed = parse(R"(
        [[lights]]
        type = "beam"
        position_mm = [0, 100, 0]
        direction = [0, -2, 0]
        radius_mm = 3
        power_W = 0.005
        spectrum = { lines_nm = [532], strengths = [7] }
    )");
    const auto& beam = std::get<BeamLight>(parsed.scene.lights.at(0));
    double power = 0.0;
    for (int i = 0; i < 4000; ++i)
        power += (*beam.irradiance)((530.0 + (i + 0.5) * 1e-3) * unit::nm) * 1e-3;
    EXPECT_NEAR(power * std::numbers::pi * 9e-6 / 0.005, 1.0, kLines);
    expect_near(beam.direction.v, {0, -1, 0});
}

}  // namespace
}  // namespace dewbow
