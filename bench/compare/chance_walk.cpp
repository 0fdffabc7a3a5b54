// SPDX-License-Identifier: Apache-2.0
#include "chance_walk.h"

#include <cmath>

#include "film_wavelengths.h"

namespace dewbow::bench {

int sources_of(const PlainScene& scene) {
    return int(scene.lamps.size() + scene.spots.size() + scene.suns.size());
}

const Spectrum& spectrum_of(const PlainScene& scene, int source) {
    auto i = std::size_t(source);
    if (i < scene.lamps.size()) return *scene.lamps[i].radiance;
    i -= scene.lamps.size();
    if (i < scene.spots.size()) return *scene.spots[i].intensity;
    return *scene.suns[i - scene.spots.size()].irradiance;
}

std::vector<WalkBand> walk_bands(const PlainScene& scene) {
    std::vector<WalkBand> bands;
    for (const FilmWavelength& wavelength : film_wavelengths(scene.film_from_xyz)) {
        const Wavelength lambda = wavelength.lambda_nm * unit::nm;
        WalkBand band;
        for (const PlainBody& body : scene.bodies)
            band.index.push_back((*body.index)(lambda).value);
        band.around = (*scene.surrounding_index)(lambda).value;
        for (int source = 0; source < sources_of(scene); ++source)
            band.sources.push_back(spectrum_of(scene, source)(lambda));
        band.film_weight = wavelength.film_weight;
        bands.push_back(std::move(band));
    }
    return bands;
}

void cross_boundary(const Things& things, const Meeting& met, Vec3 normal, const WalkBand& band,
                    Chances& chances, Vec3& d, Inside& inside) {
    const Inside beyond = inside ^ (Inside{1} << met.body);
    const int before = things.medium(inside), after = things.medium(beyond);
    if (before == after) {
        inside = beyond;
        return;
    }
    const Parting parting = part(d, normal, band.index_of(after) / band.index_of(before));
    if (chances.next() < parting.reflectance) {
        d = parting.reflected;
    } else {
        d = parting.refracted;
        inside = beyond;
    }
}

Vec3 scattered(Vec3 normal, Chances& chances) {
    const double u = chances.next();
    const auto p = point_in_disc(u, chances.next());
    const Tangents tangents = tangents_of(normal);
    return normalised(tangents.t * p[0] + tangents.b * p[1] +
                      normal * std::sqrt(std::max(0.0, 1.0 - u)));
}

}  // namespace dewbow::bench
