// SPDX-License-Identifier: Apache-2.0
#pragma once

// A lease is rendered, and its sums are added to a film.

#include <functional>

#include "dewbow/render/estimator.h"
#include "dewbow/render/farm/message.h"
#include "dewbow/render/unit_plan.h"

namespace dewbow {

/// Renders the runs of `lease`, many at once.
/// @param plan  says what the units are.  @param layout  of the whole film.
/// @param stopped  asked before each unit, from any thread; from when on it is true no unit is
/// begun, and the result holds what is finished.
message::Result render_lease(const Lease& lease, const Estimator& estimator, const UnitPlan& plan,
                             const FilmLayout& layout, const std::function<bool()>& stopped);

/// Adds `result` to film and plan. Throws InputError, and leaves both as they are, if it is no
/// result of open units of this plan.
void add_result(const message::Result& result, UnitPlan& plan, FilmSums& film);

}  // namespace dewbow
