// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/rain_light.h"

#include <algorithm>
#include <cmath>

#include "dewbow/sky/rain_law.h"

namespace dewbow {

namespace {

constexpr double kOneBelow = 1.0 - 0x1p-53;  // the largest double below 1

}  // namespace

void RainLight::weigh(const FlightPieces& cuts, std::span<const RainLanes> rains,
                      std::span<const double> haze, int lanes) {
    lanes_ = lanes;
    total_ = 0.0;
    pieces_.resize(cuts.size());
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        Piece& piece = pieces_[i];
        piece.begin = cuts.begin(i), piece.end = cuts.end(i);
        for (int k = 0; k < lanes; ++k) {
            const double by_haze = haze.empty() ? 0.0 : haze[std::size_t(k)];
            piece.source[k] = 0.0, piece.depth[k] = by_haze * piece.begin, piece.rate[k] = by_haze;
        }
        const std::span<const FlightPieces::There> there = cuts.rains(i);
        for (std::size_t r = 0; r < rains.size(); ++r) {
            const double length = there[r].to_eye + there[r].to_light;
            if (!there[r].inside && length == 0.0 && there[r].rate == 0.0) continue;
            for (int k = 0; k < lanes; ++k) {
                const double extinction = rains[r].extinction[k];
                if (extinction == 0.0) continue;
                piece.depth[k] += extinction * length;
                piece.rate[k] += extinction * there[r].rate;
                if (there[r].inside) piece.source[k] += rains[r].source[k];
            }
        }
        for (int k = 0; k < lanes; ++k) {
            piece.sent[k] =
                piece.source[k] == 0.0
                    ? 0.0
                    : piece.source[k] * rain_law::rain_piece(piece.depth[k], piece.rate[k],
                                                             piece.end - piece.begin);
            total_ += piece.sent[k];
        }
    }
}

double RainLight::integral(int k) const {
    double sum = 0.0;
    for (const Piece& piece : pieces_) sum += piece.sent[k];
    return sum;
}

std::optional<RainLight::Sample> RainLight::sample(double u) const {
    if (!(total_ > 0.0)) return std::nullopt;
    double target = u * total_;
    // Rounding may leave a rest: then the last that sends anything.
    std::optional<std::pair<std::size_t, int>> chosen;
    for (std::size_t i = 0; i < pieces_.size() && target >= 0.0; ++i) {
        for (int k = 0; k < lanes_ && target >= 0.0; ++k) {
            if (!(pieces_[i].sent[k] > 0.0)) continue;
            chosen = {i, k};
            target -= pieces_[i].sent[k];
        }
    }
    const auto [i, k] = *chosen;
    const Piece& piece = pieces_[i];
    const double share = std::clamp(target / piece.sent[k] + 1.0, 0.0, kOneBelow);
    const double length = piece.end - piece.begin;
    const Sample sample =
        at(i, piece.begin + rain_law::rain_piece_place(piece.rate[k], length, share));
    return sample.metres > 0.0 ? std::optional(sample) : std::nullopt;
}

std::optional<RainLight::Sample> RainLight::at(double distance) const {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (distance < pieces_[i].begin || distance >= pieces_[i].end) continue;
        const Sample sample = at(i, distance);
        return sample.metres > 0.0 ? std::optional(sample) : std::nullopt;
    }
    return std::nullopt;
}

RainLight::Sample RainLight::at(std::size_t i, double distance) const {
    const Piece& piece = pieces_[i];
    Sample sample{i, distance, piece.source, {}, 0.0};
    double sum = 0.0;
    for (int k = 0; k < lanes_; ++k) {
        const double depth = piece.depth[k] + piece.rate[k] * (distance - piece.begin);
        sample.left[k] = rain_law::rain_transmittance(std::max(0.0, depth));
        sum += sample.source[k] * sample.left[k];
    }
    if (sum > 0.0) sample.metres = total_ / sum;
    return sample;
}

}  // namespace dewbow
