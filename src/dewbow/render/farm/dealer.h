// SPDX-License-Identifier: Apache-2.0
#pragma once

// Who renders which units, and what happens to those that do not come back.

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "dewbow/render/farm/message.h"
#include "dewbow/render/unit_plan.h"

namespace dewbow {

/// Hands out the open units of a plan. The plan is cut into blocks of passes; within a block tiles
/// are dealt in their order, each with all passes of the block: the sums of many passes of a tile
/// are as many bytes as those of one. Light units follow, one by one: their splats are sent. Blocks
/// double, so that an interrupted picture is even within a factor of two, and shrink with what is
/// left, so that all end together [guided self-scheduling: Polychronopoulos and Kuck 1987].
///
/// Nobody has to notice that a rank is lost: when nothing is open and somebody is idle, the oldest
/// lease is dealt again [backup tasks: Dean and Ghemawat 2004]. Whoever brings it first counts.
class Dealer {
public:
    explicit Dealer(const UnitPlan& plan) : plan_(plan), pass_limit_(plan.passes()) {}

    void join(int rank, int threads) { threads_[rank] = threads; }
    /// Units of this pass and later ones are not dealt yet.
    void limit_passes(std::size_t end) { pass_limit_ = end; }

    /// Units for `rank`, or nothing if there are none for it now.
    /// @param now  s, from any moment on; when leases are dealt again depends on it, no bits do.
    std::optional<Lease> deal(int rank, double now);

    /// A lease whose result is still missing, or nullptr: then another rank was faster.
    const Lease* out(std::uint64_t lease) const {
        const auto place = out_.find(lease);
        return place == out_.end() ? nullptr : &place->second.lease;
    }
    /// Its result has been added; one that comes later does not count.
    void close(std::uint64_t lease) { out_.erase(lease); }
    std::size_t leases_out() const { return out_.size(); }
    /// How often a lease was dealt to one more rank.
    std::size_t dealt_again() const { return dealt_again_; }

private:
    struct Out {
        Lease lease;
        std::set<int> holders;
        double last_dealt = 0.0;
    };

    std::vector<UnitRun> take_open(std::size_t places);
    std::size_t places() const;
    void append_open(std::size_t place, std::vector<UnitRun>& runs) const;
    void begin_block();
    std::size_t most_units_a_thread() const;
    std::size_t all_threads() const;
    std::optional<Lease> deal_again(int rank, double now);

    const UnitPlan& plan_;
    std::size_t pass_limit_;
    std::map<int, int> threads_;                   // by rank
    std::size_t block_first_ = 0, block_end_ = 0;  // passes
    std::size_t next_place_ = 0;  // of the block: its tiles, then the light units of each pass
    std::map<std::uint64_t, Out> out_;  // by number: the oldest first
    std::uint64_t next_number_ = 0;
    std::size_t dealt_again_ = 0;
};

}  // namespace dewbow
