// SPDX-License-Identifier: Apache-2.0
#pragma once

// A render's state while workers add to it, and another thread writes it.

#include <array>
#include <functional>
#include <mutex>
#include <shared_mutex>

#include "dewbow/render/state.h"

namespace dewbow {

/// Workers render each unit into a film of their own and hand it in whole, under the lock of its
/// tile. A writer goes through the tiles: under the same lock it copies one tile's pixels and
/// stops taking note of its units, so that what is written is a film and exactly the units that it
/// holds, though tiles are from different moments. Nobody waits for longer than one tile is copied
/// or added (about 10 µs without bins), whatever the disk does, and no second film is needed.
///
/// Light units may touch every pixel. They are handed in as lists of splats, and added under the
/// locks of the blocks that they touch, one after the other. A writer comes to them last: it
/// freezes the sums of splats, so that what is handed in from then on waits beside the blocks that
/// are not written yet, and counts as unfinished in what is written.
class LiveState {
public:
    explicit LiveState(RenderState& state);

    /// Whether that unit has been handed in.
    bool finished(std::size_t pass, std::size_t number) const;
    std::size_t finished_units() const;
    /// Sums of units that are finished: passes [first_pass, end_pass) of one tile. Any thread.
    void hand_in(std::size_t first_pass, std::size_t end_pass, std::size_t tile,
                 const FilmSums& part);
    /// The same of one light unit.
    void hand_in(std::size_t first_pass, std::size_t end_pass, std::size_t number,
                 const SplatList& splats);

    /// Lets `reader` look at the film. Nothing is handed in meanwhile.
    void read(const std::function<void(const FilmSums&)>& reader) const;

    /// What write_state writes, with `seconds` as the state's time. One thread at a time. What the
    /// sink throws passes through.
    void write(const ByteSink& sink, double seconds);

private:
    /// A plan being written: with what was handed in of tiles that were not copied yet.
    struct Snapshot {
        UnitPlan plan;
        InvalidSamples invalid;
        std::vector<bool> copied;  // by tile
        bool splats_frozen = false;
    };
    static constexpr std::size_t kLocks = 64;
    std::mutex& lock_of(std::size_t tile) { return tile_locks_[tile % kLocks]; }

    void write_tiles(StateWriter& writer);
    void write_splats(StateWriter& writer);
    void keep_block(std::size_t block, std::string* to);
    void end_snapshot();

    RenderState& state_;
    std::array<std::mutex, kLocks> tile_locks_;  // guard pixels; taken before plan_lock_
    // Who hands in splats shares the gate, so that between adding them and taking note of their
    // unit nothing freezes or thaws. Block b is guarded by stripe lock b % kLocks.
    std::shared_mutex splat_gate_;
    std::array<std::mutex, kLocks> stripe_locks_;
    mutable std::mutex reading_;    // of all pixels: the writer must not move what waits
    mutable std::mutex plan_lock_;  // guards the plan, invalid samples and the snapshot
    std::optional<Snapshot> snapshot_;
};

}  // namespace dewbow
