// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rank 0: it deals units, adds up sums, and renders too.

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "dewbow/render/estimator.h"
#include "dewbow/render/farm/transport.h"
#include "dewbow/render/unit_plan.h"

namespace dewbow {

/// How long ranks are waited for at the end, in s: one that renders looks for letters between
/// units.
inline constexpr double kLongestParting = 5.0;

struct TeamOptions {
    /// What ranks that work on this render say of it.
    std::string identity;
    /// What tells another identity from this one, in words.
    std::function<std::string(const std::string& identity, int rank)> difference;
    int threads = 1;  ///< of this rank; 0: it only coordinates
    const std::atomic<bool>* stop = nullptr;
    /// If set, passes are rendered one after the other, and this is asked at the end of each
    /// whether it was the last.
    std::function<bool(std::size_t finished_passes)> enough;
    /// Called often while nothing changes plan and film.
    std::function<void()> look = [] {};
    std::function<void(const std::string&)> warn = [](const std::string&) {};
    double longest_parting = kLongestParting;
};

struct TeamReport {
    bool all_present = true;  ///< every rank has said bye: MPI can be closed
    std::vector<std::uint64_t> units_of_rank;
    std::uint64_t result_bytes = 0, results = 0;
    std::size_t leases_dealt_again = 0;
    double coordinating_seconds = 0.0;  ///< spent on letters and sums
    double rendering_seconds = 0.0;     ///< of all ranks
};

/// Renders the open units of `plan` into `film` with all ranks, until none is left, it is enough or
/// `stop` is set. Then every rank that is there has been told to leave.
TeamReport coordinate(Transport& transport, const Estimator& estimator, UnitPlan& plan,
                      FilmSums& film, const TeamOptions& options);

/// Tells all ranks to leave, where there is nothing to render. Whether all of them were there.
bool dismiss(Transport& transport, double longest_parting = kLongestParting);

}  // namespace dewbow
