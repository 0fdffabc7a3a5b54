// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/farm/dealer.h"

#include <algorithm>

namespace dewbow {

namespace {

/// How many leases each thread is to get out of what is left: with more, ranks end closer together;
/// with fewer, there is less to send.
constexpr std::size_t kRounds = 4;
/// Tiles of a lease for each thread of the rank: with several, a slow one holds up the others less.
constexpr std::size_t kTilesPerThread = 4;
/// An interrupted picture loses no more passes than these, and none of its tiles is far ahead.
constexpr std::size_t kMostPasses = 256;
/// A lease that two ranks have is dealt to a third only after this time, in s.
constexpr double kPatience = 5.0;
constexpr std::size_t kHolders = 2;

}  // namespace

std::size_t Dealer::all_threads() const {
    std::size_t sum = 0;
    for (const auto& [rank, threads] : threads_) sum += static_cast<std::size_t>(threads);
    return std::max<std::size_t>(sum, 1);
}

std::size_t Dealer::most_units_a_thread() const {
    const std::size_t left = (pass_limit_ - block_first_) * plan_.units_per_pass() - next_place_;
    return std::max<std::size_t>(left / (kRounds * all_threads()), 1);
}

void Dealer::begin_block() {
    block_first_ = block_end_;
    next_place_ = 0;
    const std::size_t doubled = std::clamp<std::size_t>(block_first_, 1, kMostPasses);
    block_end_ = std::min(block_first_ + std::min(doubled, most_units_a_thread()), pass_limit_);
}

std::size_t Dealer::places() const {
    return plan_.tiles() + plan_.light_units() * (block_end_ - block_first_);
}

/// The open units at `place`: runs of passes of a tile, or one light unit.
void Dealer::append_open(std::size_t place, std::vector<UnitRun>& runs) const {
    const bool light = plan_.is_light(place);
    const std::size_t past_tiles = light ? place - plan_.tiles() : 0;
    const std::size_t number = light ? plan_.tiles() + past_tiles % plan_.light_units() : place;
    const std::size_t first =
        light ? block_first_ + past_tiles / plan_.light_units() : block_first_;
    const std::size_t end = light ? first + 1 : block_end_, before = runs.size();
    for (std::size_t pass = first; pass < end; ++pass) {
        if (plan_.finished(pass, number)) continue;
        if (runs.size() > before && runs.back().end_pass == pass)
            ++runs.back().end_pass;
        else
            runs.push_back({number, pass, pass + 1});
    }
}

std::vector<UnitRun> Dealer::take_open(std::size_t places_to_take) {
    std::vector<UnitRun> runs;
    for (std::size_t taken = 0; taken < places_to_take && next_place_ < places(); ++next_place_) {
        const std::size_t before = runs.size();
        append_open(next_place_, runs);
        if (runs.size() > before) ++taken;
    }
    return runs;
}

std::optional<Lease> Dealer::deal(int rank, double now) {
    const auto threads = threads_.find(rank);
    if (threads == threads_.end()) return std::nullopt;
    for (;;) {
        if (next_place_ == places() || block_first_ == block_end_) {
            if (block_end_ >= pass_limit_) return deal_again(rank, now);
            begin_block();
        }
        const std::size_t depth = block_end_ - block_first_;
        const std::size_t tiles =
            std::clamp<std::size_t>(most_units_a_thread() / depth, 1, kTilesPerThread);
        std::vector<UnitRun> runs = take_open(tiles * static_cast<std::size_t>(threads->second));
        if (runs.empty()) continue;
        Out out{{next_number_++, std::move(runs)}, {rank}, now};
        return out_.emplace(out.lease.number, std::move(out)).first->second.lease;
    }
}

std::optional<Lease> Dealer::deal_again(int rank, double now) {
    Out* best = nullptr;
    for (auto& [number, out] : out_) {
        if (out.holders.contains(rank)) continue;
        if (out.holders.size() >= kHolders && now - out.last_dealt < kPatience) continue;
        if (!best || out.holders.size() < best->holders.size()) best = &out;
    }
    if (!best) return std::nullopt;
    best->holders.insert(rank);
    best->last_dealt = now;
    ++dealt_again_;
    return best->lease;
}

}  // namespace dewbow
