// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/live_state.h"

#include "dewbow/base/check.h"

namespace dewbow {

bool LiveState::finished(std::size_t pass, std::size_t tile) const {
    const std::scoped_lock lock(plan_lock_);
    return state_.plan.finished(pass, tile);
}

std::size_t LiveState::finished_units() const {
    const std::scoped_lock lock(plan_lock_);
    return state_.plan.finished_units();
}

void LiveState::hand_in(std::size_t first_pass, std::size_t end_pass, std::size_t tile,
                        const FilmSums& part) {
    const std::scoped_lock pixels(lock_of(tile));
    state_.film.add_pixels(part);
    const std::scoped_lock lock(plan_lock_);
    for (std::size_t pass = first_pass; pass < end_pass; ++pass)
        state_.plan.set_finished(pass, tile);
    const InvalidSamples invalid = part.invalid();
    state_.film.add_invalid(invalid);
    if (!snapshot_ || snapshot_->copied[tile]) return;
    for (std::size_t pass = first_pass; pass < end_pass; ++pass)
        snapshot_->plan.set_finished(pass, tile);
    snapshot_->invalid.add(invalid);
}

void LiveState::write(const ByteSink& sink, double seconds) {
    struct EndOfSnapshot {
        LiveState& live;
        ~EndOfSnapshot() {
            const std::scoped_lock lock(live.plan_lock_);
            live.snapshot_.reset();
        }
    };
    {
        const std::scoped_lock lock(plan_lock_);
        DEWBOW_CHECK(!snapshot_, "one thread writes at a time");
        snapshot_.emplace(
            Snapshot{state_.plan, state_.film.invalid(), std::vector<bool>(state_.plan.tiles())});
    }
    const EndOfSnapshot end{*this};

    StateWriter writer(state_.identity, sink);
    std::string bytes;
    for (std::size_t tile = 0; tile < state_.plan.tiles(); ++tile) {
        bytes.clear();
        {
            const std::scoped_lock pixels(lock_of(tile));
            state_.film.append_pixels(state_.plan.unit(0, tile).tile, bytes);
            const std::scoped_lock lock(plan_lock_);
            snapshot_->copied[tile] = true;
        }
        writer.add_tile(bytes);
    }
    // All tiles are copied: nobody adds to it any more.
    writer.finish(snapshot_->plan, snapshot_->invalid, seconds);
}

}  // namespace dewbow
