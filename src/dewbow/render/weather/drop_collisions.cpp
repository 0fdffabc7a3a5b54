// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/drop_collisions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/render/surface/local_frame.h"
#include "dewbow/sky/drop_cloud.h"
#include "dewbow/sky/rain_law.h"

namespace dewbow {

using rain_law::rain_opacity;

namespace {

/// Of DropCloud::discs(): light that drops have scattered comes along a ray.
constexpr std::size_t kPointSource = 0;

}  // namespace

void DropCollisions::look(const Weather& weather, PacketWeather& packet, const LaneSet& lanes,
                          const Way& way) {
    crossings_.clear(), ends_.clear(), stretches_.clear();
    probability_ = 0.0;
    for (std::size_t rain = 0; rain < weather.rains().size(); ++rain) {
        inside_.clear();
        weather.cut(rain, way, inside_);
        for (const LineInterval& inside : inside_) {
            crossings_.push_back({inside, rain, &packet.rain(rain)});
            ends_.push_back(inside.begin), ends_.push_back(inside.end);
        }
    }
    if (crossings_.empty()) return;
    weather_ = &weather, origin_ = way.origin, direction_ = way.direction, lanes_ = lanes;
    const int count = lanes.count;
    std::sort(ends_.begin(), ends_.end());
    LaneValues depth;
    depth.v.fill(0.0);
    for (std::size_t i = 0; i + 1 < ends_.size(); ++i) {
        if (!(ends_[i] < ends_[i + 1])) continue;
        Stretch stretch{ends_[i], ends_[i + 1], {}, depth};
        stretch.extinction.v.fill(0.0);
        for (const Crossing& rain : crossings_)
            if (rain.inside.begin <= stretch.begin && stretch.end <= rain.inside.end)
                for (int k = 0; k < count; ++k)
                    stretch.extinction[k] +=
                        rain.lanes->extinction[std::size_t(lanes.id[std::size_t(k)])];
        for (int k = 0; k < count; ++k)
            if (stretch.extinction[k] > 0.0)
                depth[k] += stretch.extinction[k] * (stretch.end - stretch.begin);
        stretches_.push_back(stretch);
    }
    for (int k = 0; k < count; ++k) {
        opacity_[k] = rain_opacity(depth[k]);
        probability_ += opacity_[k] / count;
    }
}

/// Where the optical depth of a lane reaches `depth`, less than that of the whole way.
double DropCollisions::distance_at(int lane, double depth) const {
    auto there = stretches_.begin();
    for (auto next = there; next != stretches_.end() && next->depth[lane] <= depth; ++next)
        if (next->extinction[lane] > 0.0) there = next;
    return std::min(there->end,
                    there->begin + (depth - there->depth[lane]) / there->extinction[lane]);
}

const DropCollisions::Stretch& DropCollisions::stretch_at(double distance) const {
    const auto next =
        std::upper_bound(stretches_.begin() + 1, stretches_.end(), distance,
                         [](double at, const Stretch& stretch) { return at < stretch.begin; });
    return *std::prev(next);
}

DropCollisions::Place DropCollisions::sample(double u) const {
    // A lane by its share of the probability; what is left of u is of that lane alone.
    const int count = lanes_.count;
    double opacity = u * probability_ * count;
    int lane = 0;
    while (lane + 1 < count && opacity >= opacity_[lane]) opacity -= opacity_[lane++];
    const double most = std::min(opacity_[lane], std::nextafter(1.0, 0.0));
    Place place{distance_at(lane, -std::log1p(-std::min(opacity, most))), 0.0};
    const Stretch& there = stretch_at(place.distance);
    const double inside = place.distance - there.begin;
    for (int k = 0; k < count; ++k)
        place.pdf += there.extinction[k] *
                     std::exp(-(there.depth[k] + there.extinction[k] * inside)) /
                     (probability_ * count);
    return place;
}

const DropCloud& DropCollisions::drops(const Crossing& crossing) const {
    return *weather_->rains()[crossing.rain].drops;
}

/// m⁻¹, where the density is 1.
double DropCollisions::scattering(const Crossing& crossing, int lane) const {
    const auto id = std::size_t(lanes_.id[std::size_t(lane)]);
    return crossing.lanes->extinction[id] * crossing.lanes->albedo[id];
}

/// The sum over the lanes.
double DropCollisions::brightness(const Crossing& crossing) const {
    double sum = 0.0;
    for (int k = 0; k < lanes_.count; ++k) sum += scattering(crossing, k);
    return sum;
}

template <class F>
void DropCollisions::for_each_at(double distance, F&& f) const {
    for (const Crossing& crossing : crossings_) {
        if (distance < crossing.inside.begin || distance > crossing.inside.end) continue;
        f(crossing, weather_->density(crossing.rain, origin_ + direction_ * distance));
    }
}

void DropCollisions::scattered(double distance, double cosine, LaneValues& out) const {
    out.v.fill(0.0);
    for_each_at(distance, [&](const Crossing& crossing, double density) {
        std::array<Intensities, kMaxLanes> phase;
        drops(crossing).phase_lanes(cosine, kPointSource, lanes_.lambdas(),
                                    std::span(phase).first(std::size_t(lanes_.count)));
        for (int k = 0; k < lanes_.count; ++k)
            out[k] += density * scattering(crossing, k) * phase[std::size_t(k)].unpolarised();
    });
}

std::optional<DropCollisions::Turn> DropCollisions::turn(double distance, double u_rain,
                                                         std::array<double, 2> u) const {
    double total = 0.0, cosine = 1.0;
    for_each_at(distance, [&](const Crossing& crossing, double density) {
        total += density * brightness(crossing);
    });
    if (!(total > 0.0)) return {};
    double target = u_rain * total;
    for_each_at(distance, [&](const Crossing& crossing, double density) {
        const double part = density * brightness(crossing);
        if (target >= 0.0 && part > 0.0) cosine = drops(crossing).sample_cosine(u[0]);
        target -= part;
    });
    Turn turn;
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const double azimuth = 2.0 * std::numbers::pi * u[1];
    turn.direction =
        normalised(LocalFrame(direction_)
                       .to_world({sine * std::cos(azimuth), sine * std::sin(azimuth), cosine}));
    // Which rain was chosen is forgotten: the density is that of all of them.
    turn.pdf = 0.0;
    for_each_at(distance, [&](const Crossing& crossing, double density) {
        turn.pdf += density * brightness(crossing) / total * drops(crossing).cosine_pdf(cosine);
    });
    scattered(distance, cosine, turn.scattered);
    return turn;
}

}  // namespace dewbow
