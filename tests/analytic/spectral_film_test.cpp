// SPDX-License-Identifier: Apache-2.0

// Each bin of a spectral film holds its own wavelengths and no others: a lamp seen through a prism
// lies in each bin where that bin's wavelengths go.

#include <gtest/gtest.h>

#include "dewbow/render/session.h"
#include "scene_kit.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kBins = 10;
/// Films of so few samples are blurred by the pixel filter (a box of one pixel) alone.
constexpr int kSamples = 64;
/// Share of a bin's energy that may lie where its wavelengths never go: none. Fixed point and
/// rounding leave this.
constexpr double kElsewhere = 1e-9;

Scene lamp_behind_prism() {
    Scene scene = empty_scene(2);  // two refractions: no ghosts of reflections inside
    const MediumPtr flint = glass("schott/SF66");
    add(scene, Prism{40.0 * deg, 1.0 * m, 1.0 * m}, dielectric(flint));
    const double turn = std::asin(index_of(*flint, 560.0) * std::sin(kPi / 9.0)) - kPi / 9.0;
    const Vec3 in{std::cos(turn), std::sin(turn), 0.0}, out{std::cos(turn), -std::sin(turn), 0.0};
    const double x = 2.0 / 3.0 * std::sin(kPi / 9.0);
    add(scene, Sphere{0.1 * m}, lamp(1.0), translation(Vec3{x, 0, 0} + 4.0 * out));
    const Vec3 eye = Vec3{-x, 0, 0} - 2.0 * in;
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at(eye, Vec3{-x, 0, 0}, {0, 1, 0}));
    scene.camera.projection = Perspective{14.0 * deg};
    scene.film.width = 8;
    scene.film.height = 96;
    scene.film.filter = {FilterKind::box, 0.5};
    scene.film.spectral_bins = kBins;
    scene.render.samples_per_pixel = kSamples;
    return scene;
}

/// Whether a ray of `lambda_nm` through height y of the picture (its middle column) ends on the
/// lamp, by two refractions in the plane: independent of the renderer.
bool reaches_lamp(double y, double lambda_nm) {
    const Scene scene = lamp_behind_prism();
    const CameraRays camera(scene);
    const Ray ray = camera.ray_through(0.5 * scene.film.width, y);
    const auto& prism = std::get<Dielectric>(scene.materials[0].surface);
    const double n = index_of(*prism.interior, lambda_nm);
    const double half = kPi / 9.0;
    // Faces through the apex: n · p = d.
    const double apex = 2.0 / 3.0 * std::cos(half);
    const Vec3 left{-std::cos(half), std::sin(half), 0}, right{std::cos(half), std::sin(half), 0};
    const double distance = apex * std::sin(half);
    const auto meet = [&](Vec3 o, Vec3 d, Vec3 normal) {
        return o + d * ((distance - dot(normal, o)) / dot(normal, d));
    };
    const Vec3 p = meet(ray.origin, ray.direction, left);
    const auto bend = [](Vec3 d, Vec3 normal, double ratio) {  // ratio n_i / n_t; normal along d
        const Vec3 across = (d - normal * dot(d, normal)) * ratio;
        const double s = dot(across, across);
        return s < 1.0 ? across + normal * std::sqrt(1.0 - s) : Vec3{};
    };
    const Vec3 inside = bend(ray.direction, -left, 1.0 / n);
    const Vec3 q = meet(p, inside, right);
    const Vec3 outside = bend(inside, right, n);
    const Vec3 centre = scene.shapes[1].world_from_object.affine().apply({});
    const Vec3 to = centre - q;
    return length(to - outside * dot(to, outside)) < 0.1 && dot(to, outside) > 0.0;
}

TEST(SpectralFilm, EachBinIsWhereItsWavelengthsGo) {
    const Scene scene = lamp_behind_prism();
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_path_estimator(scene), options, film);
    const double width = (kLambdaMax_nm - kLambdaMin_nm) / kBins;
    double first_centre = 0.0, last_centre = 0.0;
    for (int bin = 0; bin < kBins; ++bin) {
        const double low = kLambdaMin_nm + bin * width;
        // Rows that any wavelength of the bin reaches from any height within them.
        std::vector<bool> reached(std::size_t(scene.film.height), false);
        for (int fine = 0; fine < 8 * scene.film.height; ++fine)
            for (int step = 0; step <= 16; ++step)
                if (reaches_lamp((fine + 0.5) / 8.0, low + width * step / 16.0))
                    reached[std::size_t(fine / 8)] = true;
        double inside = 0.0, elsewhere = 0.0, moment = 0.0;
        for (int y = 0; y < scene.film.height; ++y) {
            // One row of margin: the lamp is round, and the middle column is not all of it.
            bool here = false;
            for (int near = std::max(0, y - 1); near <= std::min(scene.film.height - 1, y + 1);
                 ++near)
                here = here || reached[std::size_t(near)];
            for (int x = 0; x < scene.film.width; ++x) {
                const double value = film.bin(x, y, bin);
                (here ? inside : elsewhere) += value;
                moment += value * (y + 0.5);
            }
        }
        EXPECT_GT(inside, 0.0) << bin;
        EXPECT_LE(elsewhere, kElsewhere * inside) << bin;
        // The middle of the bin's picture is that of its middle wavelength.
        double sum = 0.0, rows = 0.0;
        for (int fine = 0; fine < 8 * scene.film.height; ++fine)
            if (reaches_lamp((fine + 0.5) / 8.0, low + 0.5 * width))
                sum += (fine + 0.5) / 8.0, rows += 1.0;
        ASSERT_GT(rows, 0.0);
        const double centre = moment / (inside + elsewhere);
        EXPECT_NEAR(centre, sum / rows, 0.6) << bin;  // pixels; the curve of n within a bin
        (bin == 0 ? first_centre : last_centre) = centre;
    }
    // And the whole is spread by far more than that.
    EXPECT_GT(std::abs(last_centre - first_centre), 8.0);
    std::printf("    bins spread over %.1f pixels\n", std::abs(last_centre - first_centre));
}

}  // namespace
}  // namespace dewbow
