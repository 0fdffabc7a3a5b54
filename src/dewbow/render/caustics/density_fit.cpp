// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/density_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dewbow::caustics {

namespace {

/// Slabs along an axis in which observations are counted to find out what a cut is worth. More than
/// two see a hump in the middle of a box.
constexpr int kSlabs = 4;
/// The same along two axes at once: a ridge along their diagonal, as a slit makes of place and
/// direction, is even along each of them.
constexpr int kPairSlabs = 4;
constexpr int kMostCells = 16;
/// A box with fewer observations is not cut.
constexpr std::size_t kLeastObservations = 6;
/// A box is cut if that lowers the root of the second moment by this share of the whole at least.
constexpr double kLeastGain = 2e-5;
/// So many times the gain that chance alone would show in observations of an even box.
constexpr double kChance = 1.5;
/// A box's mass is held to that of the box around it as if so many observations were of the latter.
constexpr double kHeldBy = 2.0;
/// Masses are numbers of this size, so that even 2³¹ of them add up below 2⁶⁴.
constexpr double kMassUnits = 0x1p32;

struct Room {
    AimPoint low{}, high{1.0, 1.0, 1.0, 1.0, 1.0};
    double volume = 1.0;
};

struct Cut {
    std::size_t axis;
    double at;
};

class Grower {
public:
    explicit Grower(std::span<const double> light_edges) : light_edges_(light_edges) {}

    LearntDensity grow(std::span<DensityObservation> all) {
        root_ = std::sqrt(weight_of(all));
        if (root_ > 0.0) add(all, Room{}, weight_of(all));
        return boxes_.empty() ? LearntDensity() : LearntDensity(boxes_);
    }

private:
    static double weight_of(std::span<const DensityObservation> of) {
        std::uint64_t sum = 0;
        for (const DensityObservation& o : of) sum += o.weight;
        return double(sum);
    }

    /// Where a box may be cut along `axis`.
    std::optional<double> place_of_cut(std::size_t axis, const Room& room) const {
        const double middle = 0.5 * (room.low[axis] + room.high[axis]);
        if (axis > 0) return middle;
        const auto after = std::lower_bound(light_edges_.begin(), light_edges_.end(), middle);
        std::optional<double> best;
        const auto offer = [&](double edge) {
            if (!(room.low[0] < edge && edge < room.high[0])) return;
            if (!best || std::abs(edge - middle) < std::abs(*best - middle)) best = edge;
        };
        if (after != light_edges_.begin()) offer(*(after - 1));
        if (after != light_edges_.end()) offer(*after);
        return best;
    }

    /// By how much cells, `slabs` along each of two axes, would lower √(V ∫ f²), less what chance
    /// would. The same axis twice: slabs along it.
    static double gain(std::span<const DensityObservation> of, const Room& room, std::size_t axis_a,
                       std::size_t axis_b, int slabs) {
        std::array<std::uint64_t, kMostCells> cells{};
        std::uint64_t whole = 0;
        unsigned __int128 squares = 0;
        const auto slab_of = [&](const DensityObservation& o, std::size_t axis) {
            const double share = (o.at[axis] - room.low[axis]) / (room.high[axis] - room.low[axis]);
            return std::clamp(int(share * slabs), 0, slabs - 1);
        };
        const bool pair = axis_a != axis_b;
        for (const DensityObservation& o : of) {
            const int cell = slab_of(o, axis_a) + (pair ? slabs * slab_of(o, axis_b) : 0);
            cells[std::size_t(cell)] += o.weight;
            whole += o.weight;
            squares += std::uint64_t(o.weight) * o.weight;
        }
        const double count = pair ? slabs * slabs : slabs;
        double parts = 0.0;
        for (const std::uint64_t cell : cells) parts += std::sqrt(double(cell) / count);
        const double root = std::sqrt(double(whole));
        // Of n equal observations a share s varies by s/n, and the root bends by −1/(4 s^1.5).
        const double equal_ones = double(whole) * double(whole) / double(squares);
        const double by_chance = root * (count - 1.0) / (8.0 * equal_ones);
        return std::sqrt(room.volume) * (root - parts - kChance * by_chance);
    }

    std::optional<Cut> best_cut(std::span<const DensityObservation> of, const Room& room) const {
        if (of.size() < kLeastObservations) return std::nullopt;
        std::optional<Cut> best;
        double most = kLeastGain * root_;
        for (std::size_t axis = 0; axis < kAimDimensions; ++axis) {
            const std::optional<double> at = place_of_cut(axis, room);
            if (!at) continue;
            if (const double g = gain(of, room, axis, axis, kSlabs); g > most)
                most = g, best = Cut{axis, *at};
        }
        if (best) return best;
        for (std::size_t a = 0; a < kAimDimensions; ++a) {
            for (std::size_t b = a + 1; b < kAimDimensions; ++b) {
                const double g = gain(of, room, a, b, kPairSlabs);
                if (!(g > most)) continue;
                const std::size_t longer =
                    room.high[b] - room.low[b] > room.high[a] - room.low[a] ? b : a;
                const std::optional<double> at = place_of_cut(longer, room);
                if (at) most = g, best = Cut{longer, *at};
            }
        }
        return best;
    }

    /// @param weight  what the box is taken to hold.
    void add(std::span<DensityObservation> of, const Room& room, double weight) {
        const std::size_t here = boxes_.size();
        boxes_.emplace_back();
        const std::optional<Cut> cut = best_cut(of, room);
        if (!cut) {
            boxes_[here].mass = std::uint64_t(std::sqrt(weight * room.volume) / root_ * kMassUnits);
            return;
        }
        const auto middle = std::partition(of.begin(), of.end(), [&](const DensityObservation& o) {
            return o.at[cut->axis] < cut->at;
        });
        Room below = room, above = room;
        below.high[cut->axis] = above.low[cut->axis] = cut->at;
        const double share =
            (cut->at - room.low[cut->axis]) / (room.high[cut->axis] - room.low[cut->axis]);
        below.volume *= share, above.volume *= 1.0 - share;

        boxes_[here].axis = int(cut->axis);
        boxes_[here].cut = cut->at;
        const auto first = std::size_t(middle - of.begin());
        const double n = double(of.size());
        const auto held = [&](std::span<const DensityObservation> part, double volume_share) {
            return (n * weight_of(part) + kHeldBy * weight * volume_share) / (n + kHeldBy);
        };
        const double below_weight = held(of.first(first), share);
        const double above_weight = held(of.subspan(first), 1.0 - share);
        add(of.first(first), below, below_weight);
        boxes_[here].second = std::uint32_t(boxes_.size());
        add(of.subspan(first), above, above_weight);
    }

    std::span<const double> light_edges_;
    double root_ = 0.0;
    std::vector<LearntDensity::Box> boxes_;
};

}  // namespace

LearntDensity fit_density(std::span<DensityObservation> observations,
                          std::span<const double> light_edges) {
    return Grower(light_edges).grow(observations);
}

}  // namespace dewbow::caustics
