// SPDX-License-Identifier: Apache-2.0
#include "exact_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "clear_body.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "film_wavelengths.h"

namespace dewbow::bench {
namespace {

/// A chain ends where less than this share of its light is left: lamps of 16 times white are missed
/// by less than 2e-4 of white,
constexpr double kLeastShare = 1e-5;
/// or after so many faces, if all is reflected for ever.
constexpr int kMostFaces = 1000;

/// All that depends on one wavelength.
struct Band {
    double n = 1.0;  ///< of the body against its surroundings
    double surroundings = 0.0;
    std::vector<double> lamps;  ///< radiances, in the order of the scene's
    Colour<LinearSrgb>
        film_weight;  ///< of a radiance, divided by the probability of the wavelength
};

Band band_at(const PlainScene& scene, double lambda_nm, double pdf_per_nm) {
    const Wavelength lambda = lambda_nm * unit::nm;
    Band band;
    band.n = scene.bodies[0].index->operator()(lambda).value /
             scene.surrounding_index->operator()(lambda).value;
    if (scene.surroundings) band.surroundings = (*scene.surroundings)(lambda);
    for (const PlainLamp& lamp : scene.lamps) band.lamps.push_back((*lamp.radiance)(lambda));
    band.film_weight = film_weight(lambda_nm, pdf_per_nm, scene.film_from_xyz);
    return band;
}

std::vector<Band> make_bands(const PlainScene& scene) {
    std::vector<Band> bands;
    for (const FilmWavelength& wavelength : film_wavelengths(scene.film_from_xyz))
        bands.push_back(band_at(scene, wavelength.lambda_nm, wavelength.pdf_per_nm));
    return bands;
}

class ChainTracer {
public:
    explicit ChainTracer(const PlainScene& scene) : scene_(scene), faces_(scene.bodies[0]) {}

    double radiance(Vec3 origin, Vec3 d, const Band& band) const {
        const auto entry = faces_.entry(origin, d);
        const auto [lamp_distance, lamp_radiance] = outside(origin, d, band);
        if (!entry || lamp_distance < entry->distance) return lamp_radiance;
        Vec3 at = origin + d * entry->distance;
        const Parting first = part(d, entry->normal, band.n);
        double sum = first.reflectance * outside(at, first.reflected, band).second;
        double share = 1.0 - first.reflectance;
        Vec3 inside = first.refracted;
        for (int face = 0; face < kMostFaces && share > kLeastShare; ++face) {
            const auto exit = faces_.exit(at, inside);
            at += inside * exit.distance;
            const Parting parting = part(inside, -exit.normal, 1.0 / band.n);
            if (parting.reflectance < 1.0)
                sum += share * (1.0 - parting.reflectance) *
                       outside(at, parting.refracted, band).second;
            share *= parting.reflectance;
            inside = parting.reflected;
        }
        return sum;
    }

    /// The lamp that a ray in the open meets, or the number of lamps.
    std::size_t lamp_before_all(Vec3 origin, Vec3 d) const {
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t lamp = scene_.lamps.size();
        for (std::size_t i = 0; i < scene_.lamps.size(); ++i)
            if (const auto distance = distance_to(scene_.lamps[i], origin, d);
                distance && *distance < nearest) {
                nearest = *distance;
                lamp = i;
            }
        const auto entry = faces_.entry(origin, d);
        return entry && entry->distance < nearest ? scene_.lamps.size() : lamp;
    }

private:
    /// Distance and radiance of what is seen where there is no body.
    std::pair<double, double> outside(Vec3 origin, Vec3 d, const Band& band) const {
        std::pair<double, double> seen{std::numeric_limits<double>::infinity(), band.surroundings};
        for (std::size_t i = 0; i < scene_.lamps.size(); ++i) {
            const PlainLamp& lamp = scene_.lamps[i];
            const auto distance = distance_to(lamp, origin, d);
            if (!distance || *distance >= seen.first) continue;
            const bool glows = lamp.two_sided || dot(lamp.normal, d) < 0.0;
            seen = {*distance, glows ? band.lamps[i] : 0.0};
        }
        return seen;
    }

    const PlainScene& scene_;
    ConvexFaces faces_;
};

/// Steps over the pixel, whose points lie evenly in a square: powers of 1/g, g³ = g + 1.
/// Wavelengths are even by themselves, since they are strata in their order. [Roberts 2018, "The
/// unreasonable effectiveness of quasirandom sequences"]
constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;

double fraction(double x) { return x - std::floor(x); }

}  // namespace

Picture exact_picture(const PlainScene& scene, int samples, std::uint64_t seed) {
    const ChainTracer tracer(scene);
    const std::vector<Band> bands = make_bands(scene);
    Picture picture{scene.camera.width, scene.camera.height, {}};
    picture.pixels.resize(std::size_t(picture.width) * std::size_t(picture.height));
    parallel_for(picture.pixels.size(), [&](std::size_t pixel) {
        std::array<double, 3> shift{};
        for (std::size_t c = 0; c < 3; ++c)
            shift[c] = double(hash_combine(hash_combine(seed, pixel), c) >> 11) * 0x1p-53;
        Colour<LinearSrgb> sum;
        for (int i = 0; i < samples; ++i) {
            const double x =
                double(pixel % std::size_t(picture.width)) + fraction(shift[0] + i * kStepX);
            const double y =
                double(pixel / std::size_t(picture.width)) + fraction(shift[1] + i * kStepY);
            const double share = (i + shift[2]) / samples;  // below 1
            const Band& band = bands[std::size_t(share * double(bands.size()))];
            const Vec3 d = normalised(scene.camera.direction(x, y));
            sum = sum + band.film_weight * tracer.radiance(scene.camera.eye, d, band);
        }
        picture.pixels[pixel] = sum * (1.0 / samples);
    });
    return picture;
}

double exact_radiance(const PlainScene& scene, double x, double y, double lambda_nm) {
    return ChainTracer(scene).radiance(scene.camera.eye, normalised(scene.camera.direction(x, y)),
                                       band_at(scene, lambda_nm, 1.0));
}

std::vector<bool> pixels_of_lamp(const PlainScene& scene, const std::string& name) {
    const ChainTracer tracer(scene);
    const PlainCamera& camera = scene.camera;
    const auto shows = [&](double x, double y) {
        const auto lamp = tracer.lamp_before_all(camera.eye, normalised(camera.direction(x, y)));
        return lamp < scene.lamps.size() && scene.lamps[lamp].name == name;
    };
    std::vector<bool> pixels;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            pixels.push_back(shows(x, y) && shows(x + 1, y) && shows(x, y + 1) &&
                             shows(x + 1, y + 1));
    return pixels;
}

}  // namespace dewbow::bench
