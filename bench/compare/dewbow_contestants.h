// SPDX-License-Identifier: Apache-2.0
#pragma once

// `dewbow render` as a contestant, once for each estimator and way of sampling.

#include "contestant.h"

namespace dewbow::bench {

std::unique_ptr<Contestant> find_path(const Programs& programs);

}  // namespace dewbow::bench
