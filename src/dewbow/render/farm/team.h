// SPDX-License-Identifier: Apache-2.0
#pragma once

// All ranks of a render, as rank 0 sees them: it deals units, adds up sums, and renders too.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dewbow/render/estimator.h"
#include "dewbow/render/farm/transport.h"
#include "dewbow/render/live_state.h"

namespace dewbow {

/// How long ranks are waited for at the end, in s: one that renders looks for letters between
/// units.
inline constexpr double kLongestParting = 3.0;

struct TeamOptions {
    int threads = 1;  ///< of this rank; 0: it only coordinates
    /// Told what users should know, on the thread that calls the team.
    std::function<void(const std::string&)> warn = [](const std::string&) {};
    double longest_parting = kLongestParting;
};

struct TeamReport {
    std::vector<std::uint64_t> units_of_rank;
    std::vector<int> lost_ranks;                  ///< that did not answer in the end
    std::uint64_t result_bytes = 0, results = 0;  ///< of other ranks
    std::size_t leases_dealt_again = 0;
    double coordinating_seconds = 0.0;  ///< of CPU, for letters and others' sums
    double rendering_seconds = 0.0;     ///< of all ranks
};

class Team {
public:
    /// @param transport  of rank 0
    Team(Transport& transport, TeamOptions options);
    ~Team();

    /// Renders the open units of passes before `end_pass` with all ranks that work on the render
    /// that `state` is of.
    /// @param live  of `state`
    /// @param finished  told how many more units are finished, with no two calls at the same time
    /// @param stopped  from when on it is true no unit is begun
    void render(const Estimator& estimator, const RenderState& state, LiveState& live,
                std::size_t end_pass, const std::function<void(std::size_t)>& finished,
                const std::function<bool()>& stopped);

    /// Tells all ranks that it is enough; what they bring until they leave is added. To be called
    /// once, while the state is there, or before there is one.
    void part();
    /// Whether every rank was there to part, so that MPI can be closed.
    bool all_have_left() const;

    const TeamReport& report() const;

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace dewbow
