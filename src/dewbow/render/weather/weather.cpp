// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/weather.h"

#include <algorithm>
#include <cmath>

#include "dewbow/render/infinite_light.h"
#include "dewbow/render/weather/uneven_rain.h"
#include "dewbow/sky/drop_cloud.h"
#include "dewbow/sky/length_pieces.h"

namespace dewbow {

namespace {

/// Rain that is nowhere dense still asks for some points.
constexpr double kLeastUsualDensity = 0.01;
/// Of chaos(): its mean.
constexpr double kMeanChaos = 0.5;

double usual(const std::optional<Chaos>& chaos) {
    if (!chaos) return 1.0;
    return std::clamp(chaos->bias + chaos->gain * kMeanChaos, kLeastUsualDensity, 1.0);
}

RainSun rain_sun(const DistantLight& light, int index, std::span<const Rain> rains) {
    RainSun sun{-light.direction.v, light.irradiance, index, {}};
    for (const Rain& rain : rains)
        sun.discs.push_back(rain.drops->disc_of({light.angular_radius, 0.0}));
    return sun;
}

}  // namespace

bool Weather::is_there(const Scene& scene) { return scene.aerial || !scene.rains.empty(); }

Weather::Weather(const Scene& scene) : air_(scene.aerial.get()), rains_(scene.rains) {
    for (const Rain& rain : rains_) {
        inside_.emplace_back(rain);
        usual_density_.push_back(usual(rain.chaos));
        uneven_ = uneven_ || rain.chaos;
    }
    int index = 0;
    for (const Light& light : scene.lights) {
        if (const auto* distant = std::get_if<DistantLight>(&light))
            suns_.push_back(rain_sun(*distant, index, rains_));
        index += InfiniteLight::holds(light);
    }
    if (!scene.render.rain.multiple()) add_images(scene);
}

void Weather::add_images(const Scene& scene) {
    const std::vector<RainSun> suns = suns_;
    for (const double height_m : level_mirrors(scene)) {
        for (RainSun sun : suns) {
            if (!(sun.towards.y > 0.0)) continue;
            sun.mirror.emplace(Dir<World>{sun.towards}, height_m);
            sun.towards = sun.mirror->direction().v;
            suns_.push_back(std::move(sun));
        }
    }
}

double Weather::density(std::size_t rain, Vec3 point) const {
    return rains_[rain].chaos ? chaos_density(point, *rains_[rain].chaos) : 1.0;
}

void Weather::cut(std::size_t rain, const Way& way, std::vector<LineInterval>& inside) const {
    inside_[rain].cut({way.origin}, {way.direction}, way.length, inside);
}

void Weather::lengths_towards(std::size_t rain, const Way& way, LineInterval on, const RainSun& sun,
                              std::vector<LengthPiece>& pieces) const {
    const Point<World> origin{way.origin};
    const Dir<World> direction{way.direction};
    if (sun.mirror) {
        sun.mirror->lengths(inside_[rain], origin, direction, on, pieces);
    } else {
        inside_[rain].lengths_towards(origin, direction, on, {sun.towards}, pieces);
        drop_endless(pieces);
    }
}

double Weather::length_that_dims(std::size_t rain, const Way& way) const {
    const double length = inside_[rain].length_inside({way.origin}, {way.direction}, way.length);
    return std::isfinite(length) || way.seen ? length : 0.0;
}

void Weather::dim_by_air(const Way& way, const LaneSet& lanes, LaneValues& values) const {
    if (!air_ || !std::isfinite(way.length)) return;
    LaneValues airlight;
    air_->eval_lanes(way.origin.y, {way.direction}, way.length, lanes.lambdas(),
                     values.first(lanes.count), airlight.first(lanes.count));
}

LaneValues Weather::airlight(const Way& way, const LaneSet& lanes) const {
    LaneValues transmittance, airlight;
    transmittance.v.fill(1.0);
    air_->eval_lanes(way.origin.y, {way.direction}, way.length, lanes.lambdas(),
                     transmittance.first(lanes.count), airlight.first(lanes.count));
    return airlight;
}

void Weather::dim_by_rain(const Way& way, PacketWeather& packet, const LaneSet& lanes,
                          const SampleKey& key, LaneValues& values) const {
    for (std::size_t i = 0; i < rains_.size(); ++i) {
        if (rains_[i].chaos) {
            dim_uneven(i, way, packet.rain(i), lanes, key, values);
            continue;
        }
        const double length = length_that_dims(i, way);
        if (length == 0.0) continue;
        const PacketWeather::RainLanes& rain = packet.rain(i);
        for (int k = 0; k < lanes.count; ++k) {
            const double extinction = rain.extinction[std::size_t(lanes.id[std::size_t(k)])];
            if (extinction > 0.0) values[k] *= std::exp(-extinction * length);
        }
    }
}

void Weather::dim_uneven(std::size_t rain, const Way& way, const PacketWeather::RainLanes& drops,
                         const LaneSet& lanes, const SampleKey& key, LaneValues& values) const {
    thread_local std::vector<LineInterval> inside;
    inside.clear();
    cut(rain, way, inside);
    if (!way.seen && !inside.empty() && std::isinf(inside.back().end)) return;
    LaneValues extinction;
    for (int k = 0; k < lanes.count; ++k)
        extinction[k] = drops.extinction[std::size_t(lanes.id[std::size_t(k)])];
    // Each rain has numbers of its own.
    RandomSteps steps(key, way.at + std::uint32_t(rain + 1) * 0xc2b2ae35u, way.purpose);
    for (const LineInterval& part : inside)
        dim_by_uneven_rain(
            part, extinction.first(lanes.count), usual_density_[rain],
            [&](double s) { return density(rain, way.origin + way.direction * s); }, steps, values);
}

}  // namespace dewbow
