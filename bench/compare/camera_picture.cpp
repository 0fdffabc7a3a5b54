// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "chance_walk.h"
#include "dewbow/base/parallel.h"
#include "even_points.h"
#include "forward_picture.h"

namespace dewbow::bench {
namespace {

/// Direct light of one point of a receiver, by one point of each lamp.
class DirectLight {
public:
    DirectLight(const PlainScene& scene, const Things& things) : scene_(scene), things_(things) {}

    /// Irradiance on the side to which `normal` points, in film colours, times one square metre
    /// steradian over watt.
    Colour<LinearSrgb> irradiance(Vec3 p, Vec3 normal, const std::array<double, 2>& u) const {
        Colour<LinearSrgb> sum;
        for_each(p, normal, u,
                 [&](int source, double factor) { sum = sum + colour_of(source) * factor; });
        return sum;
    }
    /// Of one wavelength, W m⁻² nm⁻¹.
    double irradiance(Vec3 p, Vec3 normal, const std::array<double, 2>& u,
                      const WalkBand& band) const {
        double sum = 0.0;
        for_each(p, normal, u, [&](int source, double factor) {
            sum += band.sources[std::size_t(source)] * factor;
        });
        return sum;
    }

private:
    /// Calls add(source, irradiance over the source's spectrum) for each that is seen.
    template <class Add>
    void for_each(Vec3 p, Vec3 normal, const std::array<double, 2>& u, const Add& add) const {
        int source = 0;
        for (const PlainLamp& lamp : scene_.lamps) {
            const double factor = from_lamp(lamp, p, normal, u);
            if (factor > 0.0) add(source, factor);
            ++source;
        }
        for (const PlainSpot& spot : scene_.spots) {
            const Vec3 to = spot.position - p, d = normalised(to);
            const double cosine = dot(normal, d);
            if (cosine > 0.0 && -dot(d, spot.direction) >= std::cos(spot.half_angle_rad) &&
                things_.sees(p, spot.position))
                add(source, cosine / dot(to, to));
            ++source;
        }
        for (const PlainSun& sun : scene_.suns) {
            const Vec3 d = -direction_from(sun, u[0], u[1]);
            const double cosine = dot(normal, d);
            if (cosine > 0.0 && things_.is_free(p, d)) add(source, cosine / -dot(d, sun.direction));
            ++source;
        }
    }
    double from_lamp(const PlainLamp& lamp, Vec3 p, Vec3 normal,
                     const std::array<double, 2>& u) const {
        const Vec3 q = point_of(lamp, u[0], u[1]), to = q - p, d = normalised(to);
        const double cosine = dot(normal, d), at_lamp = -dot(lamp.normal, d);
        if (cosine <= 0.0 || at_lamp <= 0.0 || !things_.sees(p, q)) return 0.0;
        return cosine * at_lamp * area_m2(lamp) / dot(to, to);
    }
    const Colour<LinearSrgb>& colour_of(int source) const {
        auto i = std::size_t(source);
        if (i < scene_.lamps.size()) return scene_.lamps[i].colour;
        i -= scene_.lamps.size();
        if (i < scene_.spots.size()) return scene_.spots[i].colour;
        return scene_.suns[i - scene_.spots.size()].colour;
    }

    const PlainScene& scene_;
    const Things& things_;
};

/// One picture, with or without what comes from other receivers.
class CameraSide {
public:
    CameraSide(const PlainScene& scene, bool walks)
        : scene_(scene), things_(scene), light_(scene, things_), walks_(walks) {
        if (walks) bands_ = walk_bands(scene);
    }

    /// @param u  the pixel's point, a point of the lamps, and the wavelength, each in [0, 1).
    /// @param receivers  set to false if something else is seen.
    Colour<LinearSrgb> radiance(double column, double row, const std::array<double, 5>& u,
                                Chances chances, bool& receivers) const {
        const PlainCamera& camera = scene_.camera;
        const Vec3 d = normalised(camera.direction(column + u[0], row + u[1]));
        const auto met = things_.first(camera.eye, d, 0);
        if (!met || met->body >= 0 || met->reflectance == 0.0) {
            receivers = false;
            return {};
        }
        const Vec3 p = camera.eye + d * met->distance;
        const Vec3 normal = dot(met->normal, d) < 0.0 ? met->normal : -met->normal;
        const Colour<LinearSrgb> direct =
            light_.irradiance(p, normal, {u[2], u[3]}) * (met->reflectance / std::numbers::pi);
        if (!walks_) return direct;
        const WalkBand& band = bands_[std::size_t(u[4] * double(bands_.size()))];
        return direct + band.film_weight * (met->reflectance * walk(p, normal, band, chances));
    }

private:
    /// What comes to a point from other receivers: radiance, averaged by Lambert's law.
    double walk(Vec3 origin, Vec3 normal, const WalkBand& band, Chances& chances) const {
        double radiance = 0.0;
        Vec3 d = scattered(normal, chances);
        Inside inside = 0;
        for (int meetings = 0; meetings < kMostMeetings; ++meetings) {
            const auto met = things_.first(origin, d, inside);
            if (!met) break;
            origin = origin + d * met->distance;
            normal = dot(met->normal, d) < 0.0 ? met->normal : -met->normal;
            if (met->body >= 0) {
                cross_boundary(things_, *met, normal, band, chances, d, inside);
                continue;
            }
            if (met->reflectance == 0.0) break;
            const std::array<double, 2> u{chances.next(), chances.next()};
            radiance +=
                light_.irradiance(origin, normal, u, band) * met->reflectance / std::numbers::pi;
            if (chances.next() >= met->reflectance) break;
            d = scattered(normal, chances);
        }
        return radiance;
    }

    const PlainScene& scene_;
    Things things_;
    DirectLight light_;
    bool walks_;
    std::vector<WalkBand> bands_;
};

SeenPicture seen_picture(const PlainScene& scene, bool walks, int samples, std::uint64_t seed) {
    const CameraSide side(scene, walks);
    const PlainCamera& camera = scene.camera;
    SeenPicture seen{{camera.width, camera.height, {}}, {}};
    const auto pixels = std::size_t(camera.width) * std::size_t(camera.height);
    seen.picture.pixels.resize(pixels);
    std::vector<char> shows_receivers(pixels, 1);  // not bits: threads write side by side
    parallel_for(pixels, [&](std::size_t pixel) {
        const std::uint64_t key = hash_combine(seed, pixel);
        const EvenPoints<5> points(key);
        const auto column = double(pixel % std::size_t(camera.width));
        const auto row = double(pixel / std::size_t(camera.width));
        bool receivers = true;
        Colour<LinearSrgb> sum;
        for (std::uint64_t i = 0; i < std::uint64_t(samples); ++i)
            sum = sum + side.radiance(column, row, points[i], Chances(key, i), receivers);
        seen.picture.pixels[pixel] = sum * (1.0 / samples);
        shows_receivers[pixel] = receivers;
    });
    seen.receivers.assign(shows_receivers.begin(), shows_receivers.end());
    return seen;
}

}  // namespace

SeenPicture direct_picture(const PlainScene& scene, int samples, std::uint64_t seed) {
    return seen_picture(scene, false, samples, seed);
}

SeenPicture camera_picture(const PlainScene& scene, int samples, std::uint64_t seed) {
    return seen_picture(scene, true, samples, seed);
}

}  // namespace dewbow::bench
