// SPDX-License-Identifier: Apache-2.0
//
// Light that drops of rain scatter into a path once: of suns by the law of sky/rain_law.h, of all
// other lights by next event.
#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/render/path/camera_walk.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow::walk {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Random numbers of one sun and the next, and of all other lights.
constexpr std::uint32_t kNextSun = 0xc2b2ae3du, kOtherLights = 0x27d4eb2fu;
/// Of the way from the sun to a mirror.
constexpr std::uint32_t kBehindMirror = 0x165667b1u;
/// Points of a camera's flight from which the sun is looked for, evenly by what they send: where
/// shafts cut a flight, four leave a small part of the noise of one.
constexpr int kPointsOfSun = 4;
/// Share of the points at which the direction of skylight is chosen by the drops' phase function,
/// which the fog's forward peak needs, and not by the sky's brightness.
constexpr double kByChance = 0.5;
/// Share of the points at which other lights are asked that is taken by where lamps are near.
constexpr double kByLamps = 0.5;

/// p at each lane, per sr.
/// @param perpendicular  how much of the light counts that is polarised so, and 1 minus it of the
/// parallel light: half and half without regard to polarisation.
void phase_at(const DropCloud& drops, double cosine, std::size_t disc, const LaneSet& lanes,
              LaneValues& out, double perpendicular = 0.5) {
    std::array<Intensities, kMaxLanes> p;
    drops.phase_lanes(cosine, disc, lanes.lambdas(), std::span(p).first(std::size_t(lanes.count)));
    for (int k = 0; k < lanes.count; ++k)
        out[k] = perpendicular * p[std::size_t(k)].perpendicular +
                 (1.0 - perpendicular) * p[std::size_t(k)].parallel;
}

/// Of a rain's lanes, those that a path carries.
LaneValues carried(const std::array<double, kMaxLanes>& values, const LaneSet& lanes) {
    LaneValues out;
    for (int k = 0; k < lanes.count; ++k) out[k] = values[std::size_t(lanes.id[std::size_t(k)])];
    return out;
}

}  // namespace

void CameraWalk::light_in_rain(const SharedPath& path, const Hit& hit) {
    const Way way = flight(path, hit);
    for (std::size_t sun = 0; sun < prepared_.weather->suns().size(); ++sun)
        sun_in_rain(path, way, sun);
    if (prepared_.lights.any(LightSet::Asked::all_but_distant)) sky_in_rain(path, way);
}

/// What a metre of each rain stops, as dense as it mostly is. What it sends is yet to be said.
void CameraWalk::set_extinction_of_rains(const LaneSet& lanes) {
    const Weather& weather = *prepared_.weather;
    auto& rains = rain_memory().lanes;
    rains.resize(weather.rains().size());
    for (std::size_t i = 0; i < rains.size(); ++i) {
        rains[i].extinction = carried(packet_weather().rain(i).extinction, lanes);
        for (int k = 0; k < lanes.count; ++k) rains[i].extinction[k] *= weather.usual_density(i);
    }
}

/// Of the medium between the drops.
std::span<const double> CameraWalk::haze_on(const SharedPath& path, LaneValues& extinction) {
    const auto* sigma = packet_media().extinction(path.media.interior());
    if (!sigma) return {};
    extinction = carried(*sigma, path.lanes);
    return extinction.first(path.lanes.count);
}

/// The law on the whole flight; whether the sun is seen is asked at points of it (kPointsOfSun, or
/// one), which are taken in proportion to what it sends. The sun's disc is in the phase function,
/// so that only what stands before it makes noise; to the rain itself the sun stands at its middle.
void CameraWalk::sun_in_rain(const SharedPath& path, const Way& way, std::size_t sun_index) {
    const Weather& weather = *prepared_.weather;
    const RainSun& sun = weather.suns()[sun_index];
    auto& [pieces, light, lanes] = rain_memory();
    pieces.cut(weather, way, &sun);
    if (pieces.empty()) return;
    const int count = path.lanes.count;
    const double cosine = dot(way.direction, sun.towards);
    const LaneValues irradiance = carried(packet_weather().sun(sun_index), path.lanes);
    // A bow seen behind glass or in a mirror, or one of mirrored light, counts as unpolarised.
    const auto& polariser = prepared_.camera.polariser();
    const double perpendicular = polariser && path.sees_start() && !sun.mirror
                                     ? polariser->perpendicular_share(way.direction, sun.towards)
                                     : 0.5;
    set_extinction_of_rains(path.lanes);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const LaneValues albedo = carried(packet_weather().rain(i).albedo, path.lanes);
        phase_at(*weather.rains()[i].drops, cosine, sun.discs[i], path.lanes, lanes[i].source,
                 perpendicular);
        for (int k = 0; k < count; ++k)
            lanes[i].source[k] *= irradiance[k] * albedo[k] * lanes[i].extinction[k];
    }
    LaneValues haze;
    light.weigh(pieces, lanes, haze_on(path, haze), count);

    // A mirror changes what was weighed; points of uneven rain are dear, and far flights count
    // less.
    const bool once = sun.mirror || weather.uneven() || path.depth > 0;
    const int points = once ? 1 : kPointsOfSun;
    const std::uint32_t at = way.at + kNextSun * std::uint32_t(sun_index + 1);
    const double u = key_.one(at, Purpose::rain_point);
    for (int i = 0; i < points; ++i)
        if (const auto sample = light.sample((i + u) / points))
            sun_at_point_of_rain(path, way, sun, *sample, at, 1.0 / points);
}

/// @param share  of what the flight sends that the point stands for.
void CameraWalk::sun_at_point_of_rain(const SharedPath& path, const Way& way, const RainSun& sun,
                                      const RainLight::Sample& sample, std::uint32_t at,
                                      double share) {
    const Weather& weather = *prepared_.weather;
    auto& lanes = rain_memory().lanes;
    const int count = path.lanes.count;
    const Vec3 point = way.origin + way.direction * sample.distance;
    const auto seen = prepared_.lights.infinite()[std::size_t(sun.light)].sample(
        {key_.third(at, Purpose::rain_point), key_.fourth(at, Purpose::rain_point)});
    if (!seen) return;
    if (sun.mirror) {
        const auto shares = sun.mirror->reflect(prepared_, {point}, {seen->direction}, key_, at,
                                                path.lanes, packet_media());
        if (!shares) return;
        mirror_in_rain(sun, way, *shares, path.lanes, lanes);
    } else if (prepared_.accelerator.occluded({point, seen->direction, {}}, kInfinity)) {
        return;
    }
    LaneValues radiance;
    radiance.v.fill(0.0);
    const auto there = rain_memory().pieces.rains(sample.piece);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        if (!there[i].inside) continue;
        const double density = weather.density(i, point) / weather.usual_density(i);
        for (int k = 0; k < count; ++k) radiance[k] += lanes[i].source[k] * density;
    }
    if (!weather.uneven()) {
        for (int k = 0; k < count; ++k) radiance[k] *= sample.left[k];
        weather.dim_by_air({way.origin, way.direction, sample.distance, at, way.purpose},
                           path.lanes, radiance);
        if (sun.mirror) weather.dim_by_air(way_to_mirror(sun, point, at), path.lanes, radiance);
    } else {
        absorb({way.origin, way.direction, sample.distance, at, Purpose::rain_on_flight},
               path.lanes, radiance, path.media);
        dim_to_sun(sun, point, at, path.lanes, radiance);
    }
    add(path, radiance, share * sample.metres);
}

/// What each rain sends of the sun's light becomes what it sends of the light that a mirror leaves,
/// polarised as that is.
void CameraWalk::mirror_in_rain(const RainSun& sun, const Way& way, const ReflectanceLanes& shares,
                                const LaneSet& lanes, std::span<RainLight::RainLanes> rains) const {
    const double cosine = dot(way.direction, sun.towards);
    std::array<Intensities, kMaxLanes> phase;
    for (std::size_t i = 0; i < rains.size(); ++i) {
        prepared_.weather->rains()[i].drops->phase_lanes(
            cosine, sun.discs[i], lanes.lambdas(),
            std::span(phase).first(std::size_t(lanes.count)));
        for (int k = 0; k < lanes.count; ++k) {
            const Intensities p = phase[std::size_t(k)];
            const Reflectance<double> light =
                sun.mirror->turned(shares[std::size_t(k)], {-way.direction});
            const double mirrored =
                light.perpendicular * p.perpendicular + light.parallel * p.parallel;
            const double all = p.perpendicular + p.parallel;
            rains[i].source[k] *= all > 0.0 ? mirrored / all : 0.0;
        }
    }
}

/// From `point` to where its light was mirrored.
Way CameraWalk::way_to_mirror(const RainSun& sun, Vec3 point, std::uint32_t at) {
    const Vec3 mirror = sun.mirror->place({point}, {sun.towards}).v;
    return shadow_way(point, sun.towards, length(mirror - point), at);
}

/// By what the weather leaves of the sun's light on its way to `point`.
void CameraWalk::dim_to_sun(const RainSun& sun, Vec3 point, std::uint32_t at, const LaneSet& lanes,
                            LaneValues& radiance) {
    if (!sun.mirror) {
        dim(shadow_way(point, sun.towards, kInfinity, at), lanes, radiance);
        return;
    }
    const Way to_mirror = way_to_mirror(sun, point, at);
    dim(to_mirror, lanes, radiance);
    const Vec3 mirror = point + to_mirror.direction * to_mirror.length;
    const Vec3 to_sun = MirroredSun::image_of({sun.towards}).v;
    dim(shadow_way(mirror, to_sun, kInfinity, at + kBehindMirror), lanes, radiance);
}

/// All other lights: one point of the flight, as rain dims it, and one direction from there.
void CameraWalk::sky_in_rain(const SharedPath& path, const Way& way) {
    const Weather& weather = *prepared_.weather;
    auto& [pieces, light, lanes] = rain_memory();
    pieces.cut(weather, way, nullptr);
    if (pieces.empty()) return;
    const int count = path.lanes.count;
    set_extinction_of_rains(path.lanes);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const LaneValues albedo = carried(packet_weather().rain(i).albedo, path.lanes);
        for (int k = 0; k < count; ++k) lanes[i].source[k] = albedo[k] * lanes[i].extinction[k];
    }
    LaneValues haze;
    light.weigh(pieces, lanes, haze_on(path, haze), count);

    const std::uint32_t at = way.at + kOtherLights;
    const std::array<double, 2> u = key_.two(at, Purpose::rain_point);
    const std::optional<RainLight::Sample> sample = point_in_rain(path, way, u[0]);
    if (!sample) return;
    const Vec3 point = way.origin + way.direction * sample->distance;
    thread_local std::vector<double> density;
    density.assign(lanes.size(), 0.0);
    for (std::size_t i = 0; i < lanes.size(); ++i)
        if (pieces.rains(sample->piece)[i].inside) density[i] = weather.density(i, point);
    RainPoint there{way, point, at, sample->metres, sample->left, density};
    if (weather.uneven()) {
        there.left.v.fill(1.0);
        absorb({way.origin, way.direction, sample->distance, at, Purpose::rain_on_flight},
               path.lanes, there.left, path.media);
    } else {
        weather.dim_by_air({way.origin, way.direction, sample->distance, at, way.purpose},
                           path.lanes, there.left);
    }
    const std::array<double, 2> u_direction{key_.third(at, Purpose::rain_point),
                                            key_.fourth(at, Purpose::rain_point)};
    const double chance =
        prepared_.lights.any_infinite(LightSet::Asked::all_but_distant) ? kByChance : 0.0;
    if (u[1] < chance)
        sky_by_chance_in_rain(path, there, u[1] / chance, u_direction);
    else
        direct_light_in_rain(path, there, chance, (u[1] - chance) / (1.0 - chance), u_direction);
}

/// Where other lights are asked: as the rain sends what shines on all of it evenly or, as often, as
/// lamps are near.
std::optional<RainLight::Sample> CameraWalk::point_in_rain(const SharedPath& path, const Way& way,
                                                           double u) {
    const auto& [pieces, light, lanes] = rain_memory();
    LaneValues extinction;
    extinction.v.fill(0.0);
    for (const RainLight::RainLanes& rain : lanes)
        for (int k = 0; k < path.lanes.count; ++k) extinction[k] += rain.extinction[k];
    const double begin = pieces.begin(0), end = pieces.end(pieces.size() - 1);
    const DistanceDensity near =
        prepared_.haze->lamps.near_density(way.origin + way.direction * begin, way.direction,
                                           end - begin, extinction.first(path.lanes.count));
    if (near.empty()) return light.sample(u);
    std::optional<RainLight::Sample> sample = u < kByLamps
                                                  ? light.at(begin + near.sample(u / kByLamps))
                                                  : light.sample((u - kByLamps) / (1.0 - kByLamps));
    if (sample)
        sample->metres = 1.0 / (kByLamps * near.pdf(sample->distance - begin) +
                                (1.0 - kByLamps) / sample->metres);
    return sample;
}

/// Radiance, which comes from `towards`, as the path gets it from the point. False: it does not.
bool CameraWalk::scattered_in_rain(const SharedPath& path, const RainPoint& at, Vec3 towards,
                                   double distance, LaneValues& radiance) {
    if (prepared_.accelerator.occluded({at.position, towards, {}}, distance)) return false;
    absorb(shadow_way(at.position, towards, distance, at.at), path.lanes, radiance, path.media);
    const double cosine = dot(at.flight.direction, towards);
    LaneValues scattered, phase;
    scattered.v.fill(0.0);
    for (std::size_t i = 0; i < at.density.size(); ++i) {
        if (at.density[i] == 0.0) continue;
        const PacketWeather::RainLanes& rain = packet_weather().rain(i);
        phase_at(*prepared_.weather->rains()[i].drops, cosine, 0, path.lanes, phase);
        for (int k = 0; k < path.lanes.count; ++k) {
            const auto id = std::size_t(path.lanes.id[std::size_t(k)]);
            scattered[k] += at.density[i] * rain.extinction[id] * rain.albedo[id] * phase[k];
        }
    }
    for (int k = 0; k < path.lanes.count; ++k) radiance[k] *= scattered[k] * at.left[k];
    return true;
}

/// Per sr, with which sky_by_chance_in_rain takes a direction at this cosine with the flight's.
double CameraWalk::density_in_rain(const RainPoint& at, double cosine) const {
    double sum = 0.0, total = 0.0;
    for (std::size_t i = 0; i < at.density.size(); ++i) {
        if (at.density[i] == 0.0) continue;
        sum += at.density[i] * prepared_.weather->rains()[i].drops->cosine_pdf(cosine);
        total += at.density[i];
    }
    return total > 0.0 ? sum / total : 0.0;
}

/// One light, asked as at a surface; what is infinitely far may be found by chance, too.
/// @param chance  with which that was tried instead.
void CameraWalk::direct_light_in_rain(const SharedPath& path, const RainPoint& at, double chance,
                                      double u_choice, std::array<double, 2> u) {
    const std::optional<LightSample> light =
        prepared_.lights.sample({at.position}, u_choice, u, LightSet::Asked::all_but_distant);
    if (!light || !(light->pdf > 0.0)) return;
    double pdf = (1.0 - chance) * light->pdf;
    if (light->source == LightSample::Source::infinite)
        pdf += chance * density_in_rain(at, dot(at.flight.direction, light->direction));
    LaneValues radiance;
    prepared_.lights.radiance(*light, path.lanes, light_colours(), radiance);
    if (scattered_in_rain(path, at, light->direction, light->distance, radiance))
        add(path, radiance, at.metres / pdf);
}

/// What is infinitely far, in a direction by the phase function of the drops that are there.
void CameraWalk::sky_by_chance_in_rain(const SharedPath& path, const RainPoint& at, double u_rain,
                                       std::array<double, 2> u) {
    double total = 0.0;
    for (const double density : at.density) total += density;
    if (!(total > 0.0)) return;
    std::size_t rain = 0;
    for (double target = u_rain * total; rain + 1 < at.density.size(); ++rain) {
        target -= at.density[rain];
        if (target < 0.0) break;
    }
    const double cosine = prepared_.weather->rains()[rain].drops->sample_cosine(u[0]);
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const auto [t, b] = tangents_of(at.flight.direction);
    const double azimuth = 2.0 * std::numbers::pi * u[1];
    const Vec3 towards =
        at.flight.direction * cosine + (t * std::cos(azimuth) + b * std::sin(azimuth)) * sine;
    const LightSet& lights = prepared_.lights;
    const double by_drops = kByChance * density_in_rain(at, cosine);
    LaneValues radiance, one;
    radiance.v.fill(0.0);
    for (int i = 0; i < lights.infinite_count(); ++i) {
        if (lights.infinite()[std::size_t(i)].distant() ||
            !lights.infinite_radiance(i, towards, path.lanes, light_colours(), one))
            continue;
        const double pdf =
            by_drops + (1.0 - kByChance) * lights.pdf_of_infinite({at.position}, i, towards,
                                                                  LightSet::Asked::all_but_distant);
        for (int k = 0; k < path.lanes.count; ++k) radiance[k] += one[k] / pdf;
    }
    if (scattered_in_rain(path, at, towards, kInfinity, radiance)) add(path, radiance, at.metres);
}

}  // namespace dewbow::walk
