// SPDX-License-Identifier: Apache-2.0
#pragma once

// `dewbow render` as a contestant, once for each estimator and way of sampling.

#include "contestant.h"

namespace dewbow::bench {

std::unique_ptr<Contestant> find_path(const Programs& programs);

/// Camera and light paths together, for scenes of caustics.
/// @param settings  for --set.
std::unique_ptr<Contestant> find_caustics(const Programs& programs, const std::string& name,
                                          std::vector<std::string> settings);

/// How the samples of distributed_1989 lie in their intervals.
enum class SamplesLie { fixed, jittered, correlated };
/// The paper's colours, index, transport and sum.
template <SamplesLie lie>
std::unique_ptr<Contestant> find_published_1989(const Programs& programs);
/// The same sampling with the true colours, index, reflectances and spectral transport, and no
/// limit to the sum.
template <SamplesLie lie>
std::unique_ptr<Contestant> find_corrected_1989(const Programs& programs);

}  // namespace dewbow::bench
