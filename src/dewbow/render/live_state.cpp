// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/live_state.h"

#include "dewbow/base/check.h"

namespace dewbow {

namespace {

/// The values of `all` by stripe, those of stripe s in [begin[s], begin[s + 1]).
template <class Value, std::size_t kStripes>
class Striped {
public:
    explicit Striped(const std::vector<Value>& all) : values_(all.size()) {
        for (const Value& value : all) ++begin_[stripe_of(value) + 1];
        for (std::size_t s = 0; s < kStripes; ++s) begin_[s + 1] += begin_[s];
        std::array<std::size_t, kStripes + 1> next = begin_;
        for (const Value& value : all) values_[next[stripe_of(value)]++] = value;
    }
    std::span<const Value> of(std::size_t stripe) const {
        return {values_.data() + begin_[stripe], begin_[stripe + 1] - begin_[stripe]};
    }

private:
    static std::size_t stripe_of(const Value& value) {
        return SplatSums::block_of(value.pixel) % kStripes;
    }
    std::array<std::size_t, kStripes + 1> begin_{};
    std::vector<Value> values_;
};

}  // namespace

LiveState::LiveState(RenderState& state) : state_(state) {
    if (state.plan.light_units() > 0) state.film.splats().prepare();
}

bool LiveState::finished(std::size_t pass, std::size_t number) const {
    const std::scoped_lock lock(plan_lock_);
    return state_.plan.finished(pass, number);
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

void LiveState::hand_in(std::size_t first_pass, std::size_t end_pass, std::size_t number,
                        const SplatList& splats) {
    const Striped<Splat, kLocks> by_stripe(splats.splats());
    const Striped<BinSplat, kLocks> bins_by_stripe(splats.bins());
    const std::shared_lock gate(splat_gate_);
    for (std::size_t i = 0; i < kLocks; ++i) {
        const std::size_t stripe = (number + i) % kLocks;  // not all begin with the same
        const std::scoped_lock lock(stripe_locks_[stripe]);
        state_.film.splats().add(by_stripe.of(stripe), bins_by_stripe.of(stripe));
    }
    const InvalidSamples invalid{0, {}, splats.invalid()};
    const std::scoped_lock lock(plan_lock_);
    state_.film.add_invalid(invalid);
    const bool in_snapshot = snapshot_ && !snapshot_->splats_frozen;
    if (in_snapshot) snapshot_->invalid.add(invalid);
    for (std::size_t pass = first_pass; pass < end_pass; ++pass) {
        state_.plan.set_finished(pass, number);
        state_.film.add_light_paths(state_.plan.light_unit(pass, number).paths());
        if (in_snapshot) snapshot_->plan.set_finished(pass, number);
    }
}

void LiveState::read(const std::function<void(const FilmSums&)>& reader) const {
    const std::scoped_lock lock(reading_);
    reader(state_.film);
}

void LiveState::write(const ByteSink& sink, double seconds) {
    struct EndOfSnapshot {
        LiveState& live;
        ~EndOfSnapshot() { live.end_snapshot(); }
    };
    {
        const std::scoped_lock lock(plan_lock_);
        DEWBOW_CHECK(!snapshot_, "one thread writes at a time");
        snapshot_.emplace(
            Snapshot{state_.plan, state_.film.invalid(), std::vector<bool>(state_.plan.tiles())});
    }
    const EndOfSnapshot end{*this};

    StateWriter writer(state_.identity, sink);
    write_tiles(writer);
    write_splats(writer);
    // All is copied: nobody adds to it any more.
    writer.finish(snapshot_->plan, snapshot_->invalid, seconds);
}

void LiveState::write_tiles(StateWriter& writer) {
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
}

void LiveState::write_splats(StateWriter& writer) {
    SplatSums& splats = state_.film.splats();
    if (state_.plan.light_units() > 0) {
        const std::scoped_lock all(splat_gate_, reading_, plan_lock_);
        splats.freeze();
        snapshot_->splats_frozen = true;
    }
    writer.begin_splats(splats.touched_blocks());
    std::string bytes;
    for (std::size_t block = 0; snapshot_->splats_frozen && block < splats.blocks(); ++block) {
        bytes.clear();
        keep_block(block, &bytes);
        if (!bytes.empty()) writer.add_block(block, bytes);
    }
}

void LiveState::keep_block(std::size_t block, std::string* to) {
    const std::scoped_lock lock(reading_, stripe_locks_[block % kLocks]);
    state_.film.splats().keep(block, to);
}

void LiveState::end_snapshot() {
    SplatSums& splats = state_.film.splats();
    if (snapshot_->splats_frozen)
        for (std::size_t block = 0; block < splats.blocks(); ++block) keep_block(block, nullptr);
    const std::scoped_lock all(splat_gate_, reading_, plan_lock_);
    splats.thaw();
    snapshot_.reset();
}

}  // namespace dewbow
