// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rainbow_command.h"

namespace dewbow {

/// `dewbow rainbow --size-parameter X`: one sphere in one light, by numbers alone. Prints
/// amplitudes or intensities. Returns the program's exit code.
int run_sphere(const RainbowCommand& command);

}  // namespace dewbow
