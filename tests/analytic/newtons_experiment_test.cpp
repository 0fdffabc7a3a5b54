// SPDX-License-Identifier: Apache-2.0

// Newton's prism, rendered and by quadrature: each wavelength falls on the wall where Snell's law
// at two planes sends it, averaged over the sun's disc and the slit, and brings as much as Fresnel
// and the glass let through.
//
// An orthographic camera looks at the wall at right angles, so that a pixel is a square of known
// size. A bin of the film holds one band of wavelengths: its mean radiance L̄ over a bin of width
// Δλ is the flux π / ρ ΣL̄ Δλ · (size of a pixel)² for a wall of reflectance ρ.

#include <gtest/gtest.h>

#include "dewbow/math/quadrature.h"
#include "newtons_experiment.h"
#include "pictures.h"
#include "scene_kit.h"
#include "statistics.h"
#include "welch.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr double kReflectance = 0.8;
constexpr double kAbsorption_per_m = 12.0;  ///< takes 0.3 of what goes through
/// The sheets around the slit: larger than all that the sun may reach past them.
constexpr double kSheet_m = 20.0;
constexpr int kBins = 47;  ///< of 10 nm
constexpr double kBinWidth_nm = (kLambdaMax_nm - kLambdaMin_nm) / kBins;
constexpr int kFirstLine = 4, kLines = 40;  ///< 405 to 795 nm, in the middles of their bins

/// What is asked: where, and how much.
constexpr double kPlace_mm = 0.1, kPower = 0.002;

/// Turned, so that nothing lies along an axis of the world.
const Affine kAskew = translation({0.3, -0.2, 0.1}) * rotation(normalised({1, 2, 3}), 40.0 * deg);

struct View {
    double pixel_m;       ///< side of a pixel
    int width, height;    ///< pixels
    double middle_u = 0;  ///< m, of the picture on the wall
};

double line_nm(int line) { return kLambdaMin_nm + kBinWidth_nm * (kFirstLine + line + 0.5); }

/// Bands of `band_nm` about the lines, each of the sun's irradiance 1 W m⁻².
SpectrumPtr lines(double band_nm) {
    std::vector<Line> all;
    for (int k = 0; k < kLines; ++k) all.push_back({line_nm(k) * unit::nm, 1.0});
    return make_lines(all, band_nm * unit::nm);
}

void add_rectangle(Scene& scene, Vec3 middle, Vec3 x, Vec3 y, double width, double height,
                   const Material& material) {
    const Vec3 z = cross(x, y);
    const Affine place{
        {{{x.x, y.x, z.x, middle.x}, {x.y, y.y, z.y, middle.y}, {x.z, y.z, z.z, middle.z}}}};
    add(scene, Rectangle{width * m, height * m}, material, kAskew * place);
}

Scene scene_of(const NewtonsExperiment& setup, const View& view, double band_nm) {
    // Into the prism, out of it, onto the wall: nothing else is asked for.
    Scene scene = empty_scene(3);
    scene.surroundings = medium(air(), nullptr, -1000);
    add(scene, Prism{setup.apex_rad * unit::rad, setup.side * m, setup.length * m},
        dielectric(glass("schott/N-SF11", make_constant(kAbsorption_per_m))), kAskew);

    const Vec3 across = setup.across_slit(), z{0, 0, 1}, slit = setup.slit_centre();
    const Material black{"sheet", Black{}, nullptr, false};
    for (const double side : {-1.0, 1.0}) {
        add_rectangle(scene, slit + across * (side * 0.5 * (kSheet_m + setup.slit_width)), across,
                      z, kSheet_m, 2.0 * kSheet_m, black);
        add_rectangle(scene, slit + z * (side * 0.5 * (kSheet_m + setup.slit_height)), across, z,
                      setup.slit_width, kSheet_m, black);
    }

    const Vec3 u = setup.along_wall(), wall = setup.wall_centre() + u * view.middle_u;
    const Vec3 onward = setup.onward();
    const double width = view.pixel_m * view.width, height = view.pixel_m * view.height;
    // Its normal z × u points back to the prism.
    add_rectangle(scene, wall, z, u, height, width, diffuse(kReflectance));
    scene.camera.world_from_camera = Transform<World, Camera>(
        kAskew * looking_at(wall - onward * (0.5 * setup.wall_distance), wall, z));
    scene.camera.projection = Orthographic{height * m};
    scene.film.width = view.width;
    scene.film.height = view.height;
    scene.film.filter = {FilterKind::box, 0.5};
    scene.film.spectral_bins = kBins;
    scene.render.wavelengths = WavelengthSampling::uniform;
    scene.render.caustics.light_paths = 6.0;  // cameras are asked for little
    scene.lights.push_back(DistantLight{
        {kAskew.apply_linear(setup.sunward())}, setup.sun_radius_rad * unit::rad, lines(band_nm)});
    return scene;
}

/// What the picture says of one band.
SpotOnWall seen(const FilmSums& film, const View& view, int bin) {
    SpotOnWall spot;
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const double value = film.bin(x, y, bin);
            spot.power += value;
            spot.u += value * (view.middle_u + (x + 0.5 - 0.5 * view.width) * view.pixel_m);
            spot.v += value * (0.5 * view.height - y - 0.5) * view.pixel_m;
        }
    spot.u /= spot.power;
    spot.v /= spot.power;
    spot.power *= kPi / kReflectance * kBinWidth_nm * view.pixel_m * view.pixel_m;
    return spot;
}

/// The mean over the band, which is narrow: five nodes leave nothing.
SpotOnWall expected(const NewtonsExperiment& setup, double middle_nm, double band_nm) {
    SpotOnWall spot;
    const QuadratureRule rule = gauss_legendre(5);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double n = n_sf11(middle_nm + 0.5 * band_nm * rule.nodes[i]);
        const SpotOnWall at = spot_on_wall(setup, n, kAbsorption_per_m, 6);
        spot.power += 0.5 * rule.weights[i] * at.power;
        spot.u += 0.5 * rule.weights[i] * at.power * at.u;
        spot.v += 0.5 * rule.weights[i] * at.power * at.v;
    }
    spot.u /= spot.power;
    spot.v /= spot.power;
    return spot;
}

struct Compared {
    MeanSums u_mm, v_mm, power;  ///< seen minus expected; of the power its share
};

/// Pictures of different seeds, band by band and (last) all bands together.
std::vector<Compared> compare(const NewtonsExperiment& setup, const View& view, double band_nm,
                              const std::string& name, int samples, int replicates) {
    std::vector<Compared> bands(kLines + 1);
    std::vector<SpotOnWall> oracle;
    double all = 0.0;
    for (int k = 0; k < kLines; ++k) {
        oracle.push_back(expected(setup, line_nm(k), band_nm));
        all += oracle.back().power;
    }
    for (int r = 0; r < replicates; ++r) {
        const FilmSums film =
            film_of(scene_of(setup, view, band_nm), method(name), samples, std::uint64_t(r)).film;
        double sum = 0.0;
        for (int k = 0; k < kLines; ++k) {
            const SpotOnWall found = seen(film, view, kFirstLine + k);
            const SpotOnWall& o = oracle[std::size_t(k)];
            Compared& band = bands[std::size_t(k)];
            band.u_mm.add(1e3 * (found.u - o.u));
            band.v_mm.add(1e3 * (found.v - o.v));
            band.power.add(found.power / o.power - 1.0);
            sum += found.power;
        }
        bands.back().power.add(sum / all - 1.0);
    }
    return bands;
}

/// Means of bands against the oracle. A line may lie kPlace off and be as wrong as chance makes it;
/// what all bring together is known to kPower.
constexpr double kFalseAlarm = 1e-6;  ///< of one line's power; 4e-5 for all
double chance_of(const MeanSums& few) { return two_sided_chance(few.z(), few.n - 1.0); }
void expect_lines(const std::vector<Compared>& bands) {
    double worst_mm = 0.0, worst_error_mm = 0.0;
    for (int k = 0; k < kLines; ++k) {
        const Compared& band = bands[std::size_t(k)];
        for (const MeanSums* place : {&band.u_mm, &band.v_mm}) {
            EXPECT_LT(std::abs(place->mean()), kPlace_mm) << line_nm(k) << " nm";
            worst_mm = std::max(worst_mm, std::abs(place->mean()));
            worst_error_mm = std::max(worst_error_mm, place->standard_error());
        }
        EXPECT_GT(chance_of(band.power), kFalseAlarm) << line_nm(k) << " nm";
    }
    const MeanSums& all = bands.back().power;
    EXPECT_LT(std::abs(all.mean()), kPower);
    EXPECT_LT(3.0 * all.standard_error(), kPower) << "too few light paths";
    std::printf("    places within %.3f mm (standard errors up to %.3f mm), power %.5f ± %.5f\n",
                worst_mm, worst_error_mm, all.mean(), all.standard_error());
}

/// Pixels of 2 mm; 405 nm falls 299 mm above the middle, 795 nm 86 mm below it.
const View kWall{0.002, 240, 48, 0.107};

TEST(NewtonsExperiment, BandsFallWhereSnellsLawSendsThem) {
    expect_lines(compare({}, kWall, kBinWidth_nm, "caustics", 4, 8));
}

class LongNewtonsExperiment : public ::testing::Test {};
TEST_F(LongNewtonsExperiment, LaserLinesFallWhereSnellsLawSendsThem) {
    expect_lines(compare({}, kWall, 1.0, "caustics", 32, 16));
}

/// A sun of 5°, a wide slit and a near wall, which camera paths find by chance: the oracle itself
/// is right, and the way from pixels to millimetres.
TEST_F(LongNewtonsExperiment, PathFindsAWideOne) {
    NewtonsExperiment setup;
    setup.sun_radius_rad = 5.0 * kPi / 180.0;
    setup.slit_width = 0.012;
    setup.slit_distance = 0.03;
    setup.wall_distance = 0.1;
    const auto bands = compare(setup, {0.004, 24, 12, 0.004}, kBinWidth_nm, "path", 4096, 8);
    for (int k = 0; k < kLines; ++k)
        for (const MeanSums Compared::*what : {&Compared::u_mm, &Compared::v_mm, &Compared::power})
            EXPECT_GT(chance_of(bands[std::size_t(k)].*what), kFalseAlarm) << line_nm(k);
    const MeanSums& all = bands.back().power;
    EXPECT_GT(chance_of(all), kFalseAlarm);
    EXPECT_LT(all.standard_error(), 0.02);
}

}  // namespace
}  // namespace dewbow
