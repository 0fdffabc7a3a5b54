// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render's state while workers add to it, and another thread writes it.

#include <array>
#include <mutex>

#include "dewbow/render/state.h"

namespace dewbow {

/// Workers render each unit into a film of their own and hand it in whole, under the lock of its
/// tile. A writer goes through the tiles: under the same lock it copies one tile's pixels and
/// stops taking note of its units, so that what is written is a film and exactly the units that it
/// holds, though tiles are from different moments. Nobody waits for longer than one tile is copied
/// or added (about 10 µs without bins), whatever the disk does, and no second film is needed.
class LiveState {
public:
    explicit LiveState(RenderState& state) : state_(state) {}

    /// Whether that unit has been handed in.
    bool finished(std::size_t pass, std::size_t tile) const;
    std::size_t finished_units() const;
    /// Sums of units that are finished: passes [first_pass, end_pass) of one tile. Any thread.
    void hand_in(std::size_t first_pass, std::size_t end_pass, std::size_t tile,
                 const FilmSums& part);

    /// What write_state writes, with `seconds` as the state's time. One thread at a time. What the
    /// sink throws passes through.
    void write(const ByteSink& sink, double seconds);

private:
    /// A plan being written: with what was handed in of tiles that were not copied yet.
    struct Snapshot {
        UnitPlan plan;
        InvalidSamples invalid;
        std::vector<bool> copied;  // by tile
    };
    static constexpr std::size_t kTileLocks = 64;
    std::mutex& lock_of(std::size_t tile) { return tile_locks_[tile % kTileLocks]; }

    RenderState& state_;
    std::array<std::mutex, kTileLocks> tile_locks_;  // guard pixels; taken before plan_lock_
    mutable std::mutex plan_lock_;  // guards the plan, invalid samples and the snapshot
    std::optional<Snapshot> snapshot_;
};

}  // namespace dewbow
