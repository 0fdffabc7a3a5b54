// SPDX-License-Identifier: Apache-2.0

// Paths that drops of rain turn, for light that is scattered more than once.
//
// Lights are found at drops without them: on every flight the sun by its law and the others from a
// point of the flight. So a path that a drop has turned counts no light that it runs into next,
// and what remains is light of surfaces, and of other drops.

#include "dewbow/render/walk/packet_walk.h"

namespace dewbow::walk {

bool PacketWalk::may_meet_drops(const SharedPath& path) const {
    return settings_.rain.multiple() && start_ == Start::camera && in_weather(path.media) &&
           path.depth < settings_.max_depth && settings_.rain.may_scatter_again(path.drops);
}

/// Where a path first meets rain both ways are followed: what is turned by a drop on the flight,
/// and what goes straight on, without noise. Afterwards one of the two is chosen.
PacketWalk::Flight PacketWalk::fly_in_rain(SharedPath& path, const Hit& hit) {
    const Way way = flight(path, hit);
    DropCollisions& drops = memory_.drops;
    drops.look(*prepared_.weather, memory_.weather, path.lanes, way);
    const double probability = drops.probability();
    if (!(probability > 0.0)) return Flight::straight;
    const std::array<double, 2> u = key_.two(way.at, Purpose::drop_distance);
    const bool both = !path.in_rain;
    if (!both && u[1] >= probability) {
        for (int k = 0; k < path.lanes.count; ++k) path.beta[k] /= 1.0 - probability;
        return Flight::straight;
    }
    const DropCollisions::Place place = drops.sample(u[0]);
    path.in_rain = true;
    if (!both) {
        return turn_by_drop(path, way, place.distance, place.pdf * probability) ? Flight::turned
                                                                                : Flight::ended;
    }
    SharedPath turned = path;
    turned.branch = ++branches_;
    if (turn_by_drop(turned, way, place.distance, place.pdf)) memory_.pending.push_back(turned);
    return Flight::straight;
}

/// @param pdf  of the distance, per metre.   False: the path ends.
bool PacketWalk::turn_by_drop(SharedPath& path, const Way& way, double distance, double pdf) {
    const std::optional<DropCollisions::Turn> turn =
        memory_.drops.turn(distance, key_.third(way.at, Purpose::drop_direction),
                           key_.two(way.at, Purpose::drop_direction));
    if (!turn) return false;
    absorb({way.origin, way.direction, distance, way.at, way.purpose}, path.lanes, path.beta,
           path.media);
    for (int k = 0; k < path.lanes.count; ++k)
        path.beta[k] *= turn->scattered[k] / (pdf * turn->pdf);
    const Vec3 point = way.origin + way.direction * distance;
    path.ray = {point, turn->direction, {}};
    path.scattered = true;
    path.last = {false, turn->pdf, {point}, false, true};
    path.note = 0.0;
    path.passed = 0;
    ++path.drops;
    ++path.depth;
    const LaneMask all = (1u << path.lanes.count) - 1u;
    return roulette(path.beta, path.lanes.count, all, path.depth,
                    vertex_key(path.depth, path.branch));
}

/// Lane k of an open path on its flight. False: it does not go straight on.
bool PacketWalk::open_in_rain(OpenPath& path, int k, const Hit& hit) {
    SharedPath lane = lane_of(path, k);
    if (!may_meet_drops(lane)) return true;
    const Flight flight = fly_in_rain(lane, hit);
    path.beta[k] = lane.beta[0];
    if (flight == Flight::straight) return true;
    path.active &= ~(1u << k);
    if (flight == Flight::turned) {
        lane.branch = ++branches_;
        memory_.pending.push_back(lane);
    }
    return false;
}

}  // namespace dewbow::walk
