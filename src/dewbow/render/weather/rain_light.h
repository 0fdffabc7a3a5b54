// SPDX-License-Identifier: Apache-2.0
#pragma once

// The law of rain's light (sky/rain_law.h) on a flight, for a packet of wavelengths: a sum of
// closed forms over the flight's pieces, and one distance in proportion to it.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/render/lanes.h"
#include "dewbow/render/weather/flight_pieces.h"

namespace dewbow {

/// Memory for one flight at a time.
class RainLight {
public:
    /// What one rain does to the lanes, where it is as dense as it mostly is.
    struct RainLanes {
        LaneValues source;  ///< of light that is not dimmed, what a metre sends along the flight
        LaneValues extinction;  ///< m⁻¹
    };
    /// @param rains  one for each of the scene's.   @param haze  extinction along the flight
    /// besides them, m⁻¹, one a lane; empty: none.
    void weigh(const FlightPieces& pieces, std::span<const RainLanes> rains,
               std::span<const double> haze, int lanes);

    /// The sum over all lanes of what the whole flight sends.
    double total() const { return total_; }
    /// What it sends at lane k.
    double integral(int k) const;

    struct Sample {
        std::size_t piece;
        double distance;    ///< m from the flight's origin
        LaneValues source;  ///< what a metre there sends, if nothing is lost
        LaneValues left;    ///< the share of it that is not, on both ways
        /// By which the product of both is multiplied to be an estimate of integral(), m: the
        /// distance is taken in proportion to the lanes' sum. Where lanes are alike the estimate is
        /// the integral itself.
        double metres;
    };
    /// @param u  in [0, 1). Nothing: nothing is sent.
    std::optional<Sample> sample(double u) const;
    /// The same of a distance that was taken otherwise: nothing is sent from there, or at a density
    /// of 1 / metres by sample().
    std::optional<Sample> at(double distance) const;

private:
    struct Piece {
        double begin, end;
        LaneValues source, depth, rate;  ///< optical depth at its begin, and its growth, m⁻¹
        LaneValues sent;                 ///< of the whole piece
    };
    Sample at(std::size_t piece, double distance) const;

    int lanes_ = 0;
    std::vector<Piece> pieces_;
    double total_ = 0.0;
};

}  // namespace dewbow
