// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/flight_pieces.h"

#include <algorithm>
#include <limits>

namespace dewbow {

void FlightPieces::cut(const Weather& weather, const Way& flight, const RainSun* sun) {
    rains_ = weather.rains().size();
    edges_.clear(), there_.clear();
    inside_.resize(rains_), to_light_.resize(rains_);
    LineInterval lit{0.0, flight.length}, whole{std::numeric_limits<double>::infinity(), 0.0};
    if (sun && sun->mirror) {
        const auto above = sun->mirror->above({flight.origin}, {flight.direction}, lit);
        if (!above) return;
        lit = *above;
    }
    for (std::size_t i = 0; i < rains_; ++i) {
        inside_[i].clear(), to_light_[i].clear();
        weather.cut(i, flight, inside_[i]);
        for (const LineInterval& all : inside_[i]) {
            const LineInterval in{std::max(all.begin, lit.begin), std::min(all.end, lit.end)};
            if (!(in.begin < in.end)) continue;
            whole = {std::min(whole.begin, in.begin), std::max(whole.end, in.end)};
            edges_.insert(edges_.end(), {in.begin, in.end});
        }
    }
    if (edges_.empty()) return;
    if (sun) {
        for (std::size_t i = 0; i < rains_; ++i) {
            weather.lengths_towards(i, flight, whole, *sun, to_light_[i]);
            for (const LengthPiece& piece : to_light_[i]) edges_.push_back(piece.begin);
        }
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    for (std::size_t piece = 0; piece + 1 < edges_.size(); ++piece)
        for (std::size_t i = 0; i < rains_; ++i)
            there_.push_back(there(i, edges_[piece], edges_[piece + 1]));
}

FlightPieces::There FlightPieces::there(std::size_t rain, double begin, double end) const {
    There there{false, 0.0, 0.0, 0.0};
    for (const LineInterval& in : inside_[rain]) {
        there.inside = there.inside || (in.begin <= begin && end <= in.end);
        there.to_eye += std::clamp(begin, in.begin, in.end) - in.begin;
    }
    there.rate = there.inside ? 1.0 : 0.0;
    for (const LengthPiece& piece : to_light_[rain]) {
        if (begin < piece.begin || begin >= piece.end) continue;
        there.to_light = std::max(0.0, piece.length + piece.slope * (begin - piece.begin));
        there.rate += piece.slope;
    }
    return there;
}

}  // namespace dewbow
