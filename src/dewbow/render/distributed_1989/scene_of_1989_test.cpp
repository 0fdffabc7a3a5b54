// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/scene_of_1989.h"

#include <gtest/gtest.h>

#include "dewbow/optics/catalogue.h"
#include "dewbow/optics/paper_index.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::distributed_1989 {
namespace {

/// Quadrature of XYZ at 0.5 nm against the models' white.
constexpr double kQuadrature = 1e-6;

SpectralModelPtr model() { return make_spectral_model({}); }

MonitorRgb channels_of(const Spectrum& spectrum) {
    MonitorRgb rgb;
    spectrum.eval_lanes(kChannel_nm, rgb.v);
    return rgb;
}

void expect_near(MonitorRgb a, MonitorRgb b, double tolerance) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << c;
}

double index_at(const Dispersion& dispersion, Wavelength lambda) {
    return dispersion(lambda).value;
}

TEST(SceneOf1989, ChannelsComeBack) {
    const MonitorRgb rgb{{0.2, 0.5, 3.0}};
    EXPECT_EQ(channels_of(*make_channels(rgb)), rgb);
    EXPECT_EQ(make_channels(rgb)->max_value(), 3.0);
    EXPECT_FALSE(make_channels(rgb)->is_constant());
    EXPECT_TRUE(make_channels({{2, 2, 2}})->is_constant());
}

TEST(SceneOf1989, LightsKeepTheirColourAsFarAsAMonitorHasIt) {
    expect_near(channels_of(*channels_of_light(*find_illuminant("D65"), *model())), {{1, 1, 1}},
                kQuadrature);
    // XYZ of the channels are those of the lamp.
    const SpectrumPtr lamp = find_illuminant("A");
    const Colour<Xyz> expected = xyz_from_spectrum(*lamp) * (1.0 / cie_y_integral());
    const Colour<Xyz> found = model()->xyz(channels_of(*channels_of_light(*lamp, *model())));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], kQuadrature);
    // A laser has no monitor's colour: what is missing is not negative.
    const SpectrumPtr laser = make_lines({{520.0 * unit::nm, 100.0}});
    const MonitorRgb green = channels_of(*channels_of_light(*laser, *model()));
    EXPECT_EQ(green[0], 0.0);
    EXPECT_GT(green[1], 0.5);
}

TEST(SceneOf1989, ReflectancesAreSeenUnderWhite) {
    EXPECT_EQ(channels_of(*channels_of_reflectance(*make_constant(0.3), *model())),
              (MonitorRgb{{0.3, 0.3, 0.3}}));
    const SpectrumPtr edge = make_tabulated({360, 599, 600, 830}, {0, 0, 1, 1}, OutsideTable::hold);
    const MonitorRgb red = channels_of(*channels_of_reflectance(*edge, *model()));
    EXPECT_GT(red[0], 0.7);
    EXPECT_LE(red[0], 1.0);
    EXPECT_LT(red[1], 0.2);
    EXPECT_LT(red[2], 0.05);
}

TEST(SceneOf1989, TexturesOfWhiteAreWhite) {
    expect_near(channels_of(*light_basis_in_channels(*model())[0]), {{1, 1, 1}}, kQuadrature);
    expect_near(channels_of(*reflectance_basis_in_channels(*model())[0]), {{1, 1, 1}}, 0.0);
}

TEST(SceneOf1989, IndicesAreLinesAndColoursChannelsIfSettingsSaySo) {
    Scene scene = make_empty_scene();
    const auto flint = std::make_shared<Medium>(
        Medium{"flint", make_dispersion(find_glass("schott/SF11").data), nullptr, 3});
    const SpectrumPtr red = make_tabulated({360, 599, 600, 830}, {0, 0, 1, 1}, OutsideTable::hold);
    scene.add({"flint", Dielectric{flint, 0.0, red}});
    scene.add({"the same flint", Dielectric{flint}});
    scene.add({"card", Diffuse{red}, make_constant(1.0)});
    scene.lights.push_back(UniformEnvironment{red});

    const Scene told = scene_of_1989(scene, *model());
    const auto& glass = std::get<Dielectric>(told.materials[0].surface);
    EXPECT_EQ(glass.interior, std::get<Dielectric>(told.materials[1].surface).interior);
    EXPECT_EQ(glass.interior->priority, 3);
    const DispersionPtr line = paper_index_of(flint->index, IndexReading::intended);
    for (const double nm : {380.0, 500.0, 800.0})
        EXPECT_EQ(index_at(*glass.interior->index, nm * unit::nm), index_at(*line, nm * unit::nm));
    const SpectrumPtr expected = channels_of_reflectance(*red, *model());
    EXPECT_EQ(channels_of(*glass.tint.spectrum), channels_of(*expected));
    EXPECT_EQ(channels_of(*std::get<Diffuse>(told.materials[2].surface).reflectance.spectrum),
              channels_of(*expected));
    EXPECT_EQ(channels_of(*told.materials[2].emission),
              channels_of(*channels_of_light(*make_constant(1.0), *model())));
    EXPECT_EQ(channels_of(*std::get<UniformEnvironment>(told.lights[0]).radiance),
              channels_of(*channels_of_light(*red, *model())));

    scene.render.distributed_1989.index = IndexSource::scene;
    scene.render.distributed_1989.transport = RgbOrSpectral::spectral;
    const Scene same = scene_of_1989(scene, *model());
    EXPECT_EQ(std::get<Dielectric>(same.materials[0].surface).interior, flint);
    EXPECT_EQ(same.materials[2].emission, scene.materials[2].emission);
}

TEST(SceneOf1989, HasNoHaze) {
    Scene scene = make_empty_scene();
    Medium haze = *scene.surroundings;
    haze.absorption = make_constant(2.0);
    haze.scattering = make_constant(1.0);
    haze.phase = henyey_greenstein(0.0);
    scene.surroundings = std::make_shared<Medium>(haze);
    for (const IndexSource index : {IndexSource::linear, IndexSource::scene}) {
        scene.render.distributed_1989.index = index;
        const MediumPtr told = scene_of_1989(scene, *model()).surroundings;
        EXPECT_FALSE(told->scattering);
        EXPECT_EQ(told->absorption, haze.absorption);
    }
}

}  // namespace
}  // namespace dewbow::distributed_1989
