// SPDX-License-Identifier: Apache-2.0
#pragma once

// `mpirun -n N dewbow render …`: what each rank does. Only rank 0 writes and prints.

#include <functional>

#include "command.h"
#include "dewbow/render/farm/team.h"
#include "ranks.h"

namespace dewbow {

/// Calls `render`, and parts from the other ranks however that ends. Returns the exit code, or ends
/// the program on all ranks if one is lost.
int render_as_rank_0(Ranks& ranks, const std::function<int(Team&)>& render);

/// What goes wrong here is told to rank 0. mpirun takes other exit codes than 0 for a reason to end
/// all ranks, so this is none.
int work_as_other_rank(const RenderCommand& command, Ranks& ranks);

}  // namespace dewbow
