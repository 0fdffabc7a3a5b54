// SPDX-License-Identifier: Apache-2.0
#pragma once

// Signals: what the program does when it is told to stop.

#include <atomic>

namespace dewbow {

/// From now on the first SIGINT or SIGTERM sets stop_requested(), and a second one ends the program
/// at once. Writing to a closed pipe or beyond a file size limit gives errors instead of signals,
/// and standard streams that are closed become /dev/null, so that no picture gets their numbers.
void prepare_signals();

const std::atomic<bool>& stop_requested();

/// 128 + the number of the signal that came first; 0 if none did.
int interrupt_exit_code();

}  // namespace dewbow
