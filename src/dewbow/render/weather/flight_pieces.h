// SPDX-License-Identifier: Apache-2.0
#pragma once

// A flight through rain, cut where anything about it changes: where it comes into a rain or out of
// one, and where the way that light has come through a rain changes its slope.

#include <span>
#include <vector>

#include "dewbow/render/weather/weather.h"

namespace dewbow {

/// Memory for the cuts of one flight at a time.
class FlightPieces {
public:
    /// One rain on one piece.
    struct There {
        bool inside;      ///< the piece lies in it
        double to_eye;    ///< m of it between the flight's origin and the piece's begin
        double to_light;  ///< m of it on the way from the piece's begin to the light
        double rate;      ///< by how much both together grow a metre
    };

    /// Between the first and the last point of the flight that any rain holds, and that may be lit.
    /// @param sun  nullptr: light comes to each point undimmed.
    void cut(const Weather& weather, const Way& flight, const RainSun* sun);

    bool empty() const { return edges_.size() < 2; }
    std::size_t size() const { return empty() ? 0 : edges_.size() - 1; }
    double begin(std::size_t piece) const { return edges_[piece]; }
    double end(std::size_t piece) const { return edges_[piece + 1]; }
    /// The scene's rains there, one after the other.
    std::span<const There> rains(std::size_t piece) const {
        return std::span(there_).subspan(piece * rains_, rains_);
    }

private:
    There there(std::size_t rain, double begin, double end) const;

    std::size_t rains_ = 0;
    std::vector<double> edges_;
    std::vector<There> there_;                        ///< [piece][rain]
    std::vector<std::vector<LineInterval>> inside_;   ///< [rain]
    std::vector<std::vector<LengthPiece>> to_light_;  ///< [rain]
};

}  // namespace dewbow
