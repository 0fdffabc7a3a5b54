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
    const std::size_t left = (pass_limit_ - block_first_) * plan_.tiles() - next_tile_;
    return std::max<std::size_t>(left / (kRounds * all_threads()), 1);
}

void Dealer::begin_block() {
    block_first_ = block_end_;
    next_tile_ = 0;
    const std::size_t doubled = std::clamp<std::size_t>(block_first_, 1, kMostPasses);
    block_end_ = std::min(block_first_ + std::min(doubled, most_units_a_thread()), pass_limit_);
}

std::vector<UnitRun> Dealer::take_open(std::size_t tiles) {
    std::vector<UnitRun> runs;
    for (std::size_t taken = 0; taken < tiles && next_tile_ < plan_.tiles(); ++next_tile_) {
        const std::size_t before = runs.size();
        for (std::size_t pass = block_first_; pass < block_end_; ++pass) {
            if (plan_.finished(pass, next_tile_)) continue;
            if (runs.size() > before && runs.back().end_pass == pass)
                ++runs.back().end_pass;
            else
                runs.push_back({next_tile_, pass, pass + 1});
        }
        if (runs.size() > before) ++taken;
    }
    return runs;
}

std::optional<Lease> Dealer::deal(int rank, double now) {
    const auto threads = threads_.find(rank);
    if (threads == threads_.end()) return std::nullopt;
    for (;;) {
        if (next_tile_ == plan_.tiles() || block_first_ == block_end_) {
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
