// SPDX-License-Identifier: Apache-2.0
#pragma once

// Ranks other than 0: they ask for leases, render them and send the sums.

#include <atomic>

#include "dewbow/render/estimator.h"
#include "dewbow/render/farm/transport.h"
#include "dewbow/render/state.h"

namespace dewbow {

/// Rank 0 says something every second; one that has been silent for this long, in s, is lost.
inline constexpr double kLongestSilence = 30.0;

/// together: every rank is there, and MPI may be closed. without_all: rank 0 is going to end the
/// program on all ranks.
enum class Parting { together, without_all, rank_0_lost };

/// Works until rank 0 says that it is enough.
/// @param identity  of the render: rank 0 works only with ranks whose render is the same.
Parting work_for_rank_0(Transport& transport, const Estimator& estimator,
                        const RenderIdentity& identity, int threads,
                        double longest_silence = kLongestSilence);

/// Tells rank 0 that this rank does no work, and waits until all may part.
/// @param reason  empty: it has done what it was asked for
Parting say_bye(Transport& transport, const std::string& reason,
                double longest_silence = kLongestSilence);

}  // namespace dewbow
