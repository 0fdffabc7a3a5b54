// SPDX-License-Identifier: Apache-2.0
#pragma once

// A lease is rendered, and its sums are added to a state.

#include <functional>

#include "dewbow/render/estimator.h"
#include "dewbow/render/farm/message.h"
#include "dewbow/render/live_state.h"

namespace dewbow {

/// Renders the runs of `lease`, many at once.
/// @param plan  says what the units are.  @param layout  of the whole film.
/// @param stopped  asked before each unit, from any thread; from when on it is true no unit is
/// begun, and the result holds what is finished.
message::Result render_lease(const Lease& lease, const Estimator& estimator, const UnitPlan& plan,
                             const FilmLayout& layout, const std::function<bool()>& stopped);

/// Throws InputError unless the pieces are of open units of `plan`, each once, with as many pixels
/// as they must have, and splats that can be.
void check_pieces(const message::Result& result, const UnitPlan& plan, const FilmLayout& layout);

/// Adds pieces that check_pieces has let pass. Returns how many units they are.
std::size_t add_pieces(const message::Result& result, const UnitPlan& plan,
                       const FilmLayout& layout, LiveState& to);

}  // namespace dewbow
