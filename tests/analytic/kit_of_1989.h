// SPDX-License-Identifier: Apache-2.0
#pragma once

// A prism of the paper's index before something bright, pictures of it by distributed_1989, and the
// same prism in two dimensions, by hand.

#include <cmath>
#include <vector>

#include "dewbow/optics/paper_index.h"
#include "dewbow/render/distributed_1989/distributed_1989.h"
#include "dewbow/render/session.h"
#include "dewbow/spectrum/rgb.h"
#include "dewbow/spectrum/spectral_samples.h"
#include "scene_kit.h"

namespace dewbow::kit {

/// The index at the far red and the dispersive power of the glass: outlandish, as the paper says,
/// so that small pictures show what there is to see. η(f) = 1.7 + 0.184 f.
inline constexpr double kEtaRed = 1.7, kDispersivePower = 0.2;

inline double eta_of(double f) {
    return linear_index(kEtaRed, kDispersivePower, IndexReading::intended).at(f);
}
inline MediumPtr glass_of_1989() {
    return medium(paper_index(kEtaRed, kDispersivePower, IndexReading::intended));
}
/// Light that films as (1, 1, 1).
inline SpectrumPtr film_white() { return make_emission({{1.0, 1.0, 1.0}}); }

/// Air, one sample a pixel through a box filter, nothing that the paper's tree leaves out.
inline Scene scene_of_tests(int width, int height, int depth) {
    Scene scene = empty_scene(depth);
    scene.surroundings = medium(air(), nullptr, -1000);
    scene.film.width = width;
    scene.film.height = height;
    scene.film.filter = {FilterKind::box, 0.5};
    scene.render.samples_per_pixel = 1;
    scene.render.distributed_1989.least_weight = 0.0;
    return scene;
}

/// What the scene's spectral model sends to the monitor, row by row.
inline std::vector<MonitorRgb> monitor_picture(const Scene& scene) {
    SessionOptions options;
    FilmSums film = make_film(scene, options);
    run_session(scene, *make_distributed_1989_estimator(scene), options, film);
    const SpectralModelPtr model = make_spectral_model(scene.render.distributed_1989.model);
    std::vector<MonitorRgb> picture;
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) picture.push_back(model->rgb(film.xyz(x, y)));
    return picture;
}

/// A prism with its apex up, seen from the left at minimum deviation for f = 1/2. Rows of the
/// picture are angles of deviation; light that leaves in the direction of the middle row's meets
/// the middle of a far plane at right angles.
class PrismView {
public:
    static constexpr int kRows = 240;

    /// @param far_shape  stands in the far plane; its own x, y are the plane's, y up.
    PrismView(Geometry far_shape, Material far_material, Vec3 far_place) {
        const double half = 0.5 * kApex_rad;
        turn_ = std::asin(eta_of(0.5) * std::sin(half)) - half;
        scene_ = scene_of_tests(1, kRows, 2);  // two refractions: no ghosts of reflections inside
        add(scene_, Prism{kApex_rad * unit::rad, 1.0 * m, 1.0 * m}, dielectric(glass_of_1989()));
        const Affine stands = translation(middle_of_face(1.0) + kFar * out()) *
                              rotation({0, 0, 1}, -turn_ * unit::rad) *
                              rotation({0, 1, 0}, -90.0 * deg);
        add(scene_, std::move(far_shape), std::move(far_material), stands * translation(far_place));
        const Vec3 in{std::cos(turn_), std::sin(turn_), 0.0};
        const Vec3 eye = middle_of_face(-1.0) - 2.0 * in;
        scene_.camera.world_from_camera =
            Transform<World, Camera>(looking_at(eye, middle_of_face(-1.0), {0, 1, 0}));
        scene_.camera.projection = Perspective{kField_deg * deg};
    }

    Scene& scene() { return scene_; }

    /// Where the light of f that is seen at height `y` of the picture comes from.
    struct Arrival {
        double height;     ///< in the far plane, from its middle, m
        double transmits;  ///< through both faces, with Fresnel's factors of the nominal index
    };
    Arrival arrival(double y, double f) const {
        const double nominal = eta_of(paper_coordinate(kLineD, SpectralSpacing::frequency));
        const Ray ray = CameraRays(scene_).ray_through(0.5, y);
        const double half = 0.5 * kApex_rad, n = eta_of(f);
        const Vec3 left{-std::cos(half), std::sin(half), 0},
            right{std::cos(half), std::sin(half), 0};
        const Vec3 p = meet(ray.origin, ray.direction, left);
        const Vec3 inside = bend(ray.direction, -left, 1.0 / n);
        const Vec3 q = meet(p, inside, right);
        const Vec3 outside = bend(inside, right, n);
        const double reflected = reflectance(-dot(ray.direction, left), nominal);
        const double reflected_inside = reflectance(dot(inside, right), 1.0 / nominal);
        const Vec3 to = middle_of_face(1.0) + kFar * out() - q;
        const Vec3 at = q + outside * (dot(to, out()) / dot(outside, out()));
        const Vec3 up{std::sin(turn_), std::cos(turn_), 0.0};
        return {dot(at - (q + to), up), (1.0 - reflected) * (1.0 - reflected_inside)};
    }

private:
    static constexpr double kApex_rad = 40.0 * kPi / 180.0, kFar = 40.0, kField_deg = 18.0;

    Vec3 out() const { return {std::cos(turn_), -std::sin(turn_), 0.0}; }
    static Vec3 middle_of_face(double side) {
        const double half = 0.5 * kApex_rad, apex = 2.0 / 3.0 * std::cos(half);
        return {side * 0.5 * std::sin(half), apex - 0.5 * std::cos(half), 0.0};
    }
    /// A face through the apex.
    static Vec3 meet(Vec3 from, Vec3 direction, Vec3 normal) {
        const Vec3 apex{0.0, 2.0 / 3.0 * std::cos(0.5 * kApex_rad), 0.0};
        return from + direction * (dot(normal, apex - from) / dot(normal, direction));
    }
    /// Fresnel's, unpolarised.
    static double reflectance(double cosine, double n) {
        const double inner = std::sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
        const double s = (cosine - n * inner) / (cosine + n * inner);
        const double p = (n * cosine - inner) / (n * cosine + inner);
        return 0.5 * (s * s + p * p);
    }
    /// Snell's law; `normal` along d, `ratio` n_i / n_t.
    static Vec3 bend(Vec3 d, Vec3 normal, double ratio) {
        const Vec3 across = (d - normal * dot(d, normal)) * ratio;
        return across + normal * std::sqrt(1.0 - dot(across, across));
    }

    double turn_ = 0.0;
    Scene scene_;
};

}  // namespace dewbow::kit
