// SPDX-License-Identifier: Apache-2.0
#include "aliasing/rendered.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/optics/paper_index.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/render/distributed_1989/distributed_1989.h"
#include "dewbow/render/session.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::bench {
namespace {

using unit::m;

/// So far that parallax within the prism is nothing, and what stands for infinitely many samples:
/// a multiple of 13, so that no colour is missed.
constexpr double kFar = 2e4;
constexpr int kLimit = 13 * 60;
constexpr int kSamplesPerPixel = 16;
/// Black around the picture, for the widest blur.
constexpr double kMargin_arcmin = 60.0;

Angle arcmin(double minutes) { return minutes / 60.0 * unit::deg; }

/// A slit across the dispersion, seen through a prism with its apex up, one column wide.
Scene slit_through_prism(const Prism& prism, Angle apex, double width_arcmin, double pixel_arcmin) {
    const double half = 0.5 * apex.to(unit::rad), middle = prism.eta_red + 0.5 * prism.slope;
    const double incidence = std::asin(middle * std::sin(half)), turn = incidence - half;
    const double reflected = fresnel_dielectric(std::cos(incidence), middle).unpolarised();
    const Vec3 in{std::cos(turn), std::sin(turn), 0.0}, out{std::cos(turn), -std::sin(turn), 0.0};
    const Vec3 face{0.5 * std::sin(half), std::cos(half) / 6.0, 0.0};

    Scene scene = make_empty_scene();
    const auto add = [&](Geometry geometry, Material material, const Affine& place) {
        const int id = scene.add(std::move(material));
        scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), id});
    };
    const auto medium = std::make_shared<Medium>(
        Medium{"glass", paper_index(prism.eta_red, prism.w, IndexReading::intended), nullptr, 0});
    add(dewbow::Prism{apex, 1.0 * m, 1.0 * m},
        {"glass", Dielectric{medium, 0.0, nullptr}, nullptr, false}, {});
    // As bright as white behind both faces.
    const double bright = 1.0 / ((1.0 - reflected) * (1.0 - reflected));
    const double width = 2.0 * kFar * std::tan(0.5 * arcmin(width_arcmin).to(unit::rad));
    add(Rectangle{kFar * m, width * m},
        {"slit", Black{}, make_emission({{bright, bright, bright}}), false},
        translation(face + kFar * out) * rotation({0, 0, 1}, -turn * unit::rad) *
            rotation({0, 1, 0}, -90.0 * unit::deg));

    const Vec3 seen{-face.x, face.y, 0.0};
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at(seen - 0.5 * in, seen, {0, 1, 0}));
    const double field = prism.spread_arcmin + width_arcmin + 2.0 * kMargin_arcmin;
    scene.film.width = 1;
    scene.film.height = int(std::ceil(field / pixel_arcmin));
    scene.camera.projection = Perspective{arcmin(scene.film.height * pixel_arcmin)};
    scene.film.filter = {FilterKind::box, 0.5};
    scene.render.samples_per_pixel = kSamplesPerPixel;
    scene.render.max_depth = 2;  // both faces, and no ghosts
    return scene;
}

using Line = std::vector<Colour<Opponent>>;

Line render(Scene scene, int samples) {
    scene.render.distributed_1989.sampling.samples = samples;
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_distributed_1989_estimator(scene), options, film);
    Line line;
    for (int y = 0; y < film.height(); ++y) line.push_back(opponent_from_xyz(film.xyz(0, y)));
    return line;
}

/// As an eye sees the middles of its pixels; beyond its ends the line goes on as there.
Line seen(const Line& line, double pixel) {
    Line result(line.size());
    for (std::size_t c = 0; c < 3; ++c)
        for (const Lobe& lobe : lobes(c)) {
            const int reach = int(std::ceil(4.0 * lobe.sigma_arcmin / pixel));
            const double scale = pixel / (std::numbers::sqrt2 * lobe.sigma_arcmin);
            for (int step = -reach; step <= reach; ++step) {
                const double share =
                    0.5 * lobe.weight *
                    (std::erf((step + 0.5) * scale) - std::erf((step - 0.5) * scale));
                for (int y = 0; y < int(line.size()); ++y) {
                    const int from = std::clamp(y + step, 0, int(line.size()) - 1);
                    result[std::size_t(y)][c] += share * line[std::size_t(from)][c];
                }
            }
        }
    return result;
}

}  // namespace

double rendered_aliasing(const Prism& prism, Angle apex, double width_arcmin, double pixel_arcmin,
                         int samples) {
    const Scene scene = slit_through_prism(prism, apex, width_arcmin, pixel_arcmin);
    const Line few = seen(render(scene, samples), pixel_arcmin);
    const Line many = seen(render(scene, kLimit), pixel_arcmin);
    double most = 0.0;
    for (std::size_t y = 0; y < few.size(); ++y)
        most = std::max(most, visible_difference(few[y], many[y]));
    return most;
}

}  // namespace dewbow::bench
