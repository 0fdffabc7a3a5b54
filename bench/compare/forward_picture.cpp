// SPDX-License-Identifier: Apache-2.0
#include "forward_picture.h"

#include <cmath>
#include <numbers>

#include "chance_walk.h"
#include "dewbow/base/parallel.h"
#include "even_points.h"

namespace dewbow::bench {
namespace {

/// Which pixel sees a point, and how large it is there.
struct Seen {
    std::size_t pixel = 0;
    double pixels_per_m2 = 0.0;  ///< of the surface
};
std::optional<Seen> seen_by(const PlainCamera& camera, const Things& things, Vec3 p, Vec3 normal) {
    const Vec3 from_eye = p - camera.eye;
    const double depth = dot(from_eye, camera.forward), facing = -dot(from_eye, normal);
    if (depth <= 0.0 || facing <= 0.0) return std::nullopt;
    const double scale = camera.height / (2.0 * camera.tan_half_vertical_fov);  // pixels
    const double x = 0.5 * camera.width + dot(from_eye, camera.right) / depth * scale;
    const double y = 0.5 * camera.height - dot(from_eye, camera.up) / depth * scale;
    if (!(x >= 0.0 && y >= 0.0 && x < camera.width && y < camera.height)) return std::nullopt;
    if (!things.sees(p, camera.eye)) return std::nullopt;
    // dx dy = scale² cos θ_p / cos³ θ_c dA / distance², cos θ_c = depth / distance.
    const auto pixel = std::size_t(y) * std::size_t(camera.width) + std::size_t(x);
    return Seen{pixel, scale * scale * facing / (depth * depth * depth)};
}

/// Walks of one piece of the paths.
class Walker {
public:
    Walker(const PlainScene& scene, const Things& things, std::vector<Colour<LinearSrgb>>& film)
        : scene_(scene), things_(things), film_(film) {}

    /// @param light  what the path brings to the film for each pixel of 1 m² on a white wall, times
    ///               π.
    void walk(Vec3 origin, Vec3 d, const Colour<LinearSrgb>& light, const WalkBand& band,
              Chances chances) {
        Inside inside = 0;
        bool straight = true;  // nothing was met so far
        for (int meetings = 0; meetings < kMostMeetings; ++meetings) {
            const auto met = things_.first(origin, d, inside);
            if (!met) return;
            origin = origin + d * met->distance;
            const Vec3 normal = dot(met->normal, d) < 0.0 ? met->normal : -met->normal;
            if (met->body >= 0) {
                cross_boundary(things_, *met, normal, band, chances, d, inside);
            } else {
                if (straight || met->reflectance == 0.0) return;
                splat(origin, normal, light * met->reflectance);
                if (chances.next() >= met->reflectance) return;
                d = scattered(normal, chances);
            }
            straight = false;
        }
    }

private:
    void splat(Vec3 p, Vec3 normal, const Colour<LinearSrgb>& light) {
        if (const auto seen = seen_by(scene_.camera, things_, p, normal))
            film_[seen->pixel] =
                film_[seen->pixel] + light * (seen->pixels_per_m2 / std::numbers::pi);
    }

    const PlainScene& scene_;
    const Things& things_;
    std::vector<Colour<LinearSrgb>>& film_;
};

}  // namespace

Picture forward_picture(const PlainScene& scene, std::uint64_t paths, std::uint64_t seed) {
    /// Of the paths, one of so many starts elsewhere than through the gate.
    constexpr std::uint64_t kElsewhere = 8;
    constexpr std::uint64_t kPieces = 64;
    const Things things(scene);
    const Emission emission(scene, things);
    const std::vector<WalkBand> bands = walk_bands(scene);
    Picture picture{scene.camera.width, scene.camera.height, {}};
    picture.pixels.resize(std::size_t(picture.width) * std::size_t(picture.height));
    std::vector<std::vector<Colour<LinearSrgb>>> films(kPieces);
    const auto walk_all = [&](bool gate, std::uint64_t count, std::uint64_t of_source, int source) {
        const EvenPoints<5> points(hash_combine(seed, of_source));
        parallel_for(kPieces, [&](std::size_t piece) {
            films[piece].resize(picture.pixels.size());
            Walker walker(scene, things, films[piece]);
            for (std::uint64_t i = piece; i < count; i += kPieces) {
                const auto u = points[i];
                const std::array<double, 4> place{u[0], u[1], u[2], u[3]};
                const EmittedRay ray =
                    gate ? emission.through_gate(source, place) : emission.elsewhere(source, place);
                if (ray.weight == 0.0) continue;
                const WalkBand& band = bands[std::size_t(u[4] * double(bands.size()))];
                const double flux = ray.weight * band.sources[std::size_t(source)] / double(count);
                walker.walk(ray.origin, ray.d, band.film_weight * flux, band,
                            Chances(hash_combine(seed, of_source), i));
            }
        });
    };
    const auto sources = std::uint64_t(sources_of(scene));
    for (std::uint64_t source = 0; source < sources; ++source) {
        const std::uint64_t elsewhere = paths / kElsewhere / sources;
        walk_all(true, paths / sources - elsewhere, 2 * source, int(source));
        walk_all(false, elsewhere, 2 * source + 1, int(source));
    }
    for (const auto& film : films)
        for (std::size_t i = 0; i < film.size(); ++i)
            picture.pixels[i] = picture.pixels[i] + film[i];
    return picture;
}

Picture lit_picture(const PlainScene& scene, int samples, std::uint64_t seed) {
    constexpr int kPathsToWalks = 4;
    Picture picture = camera_picture(scene, std::max(1, samples / kPathsToWalks), seed).picture;
    const Picture forward =
        forward_picture(scene, std::uint64_t(samples) * picture.pixels.size(), seed);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        picture.pixels[i] = picture.pixels[i] + forward.pixels[i];
    return picture;
}

}  // namespace dewbow::bench
