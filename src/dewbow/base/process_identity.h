// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which process it was, and whether it still runs.

#include <cstdint>
#include <string>

namespace dewbow {

/// A process, told apart from another one that is given the same number later, on another machine
/// or in another container.
struct ProcessIdentity {
    std::string host;               ///< the machine's name
    std::string boot;               ///< names the start of its kernel; a new one after each start
    std::string pid_namespace;      ///< in which `pid` counts; containers have their own
    std::int64_t pid = 0;           ///< > 0
    std::uint64_t start_ticks = 0;  ///< when it began, in clock ticks of the kernel; 0: not known
};

ProcessIdentity this_process();

enum class Life { lives, ended, unknown };

/// Unknown for processes of other machines and other containers.
Life life_of(const ProcessIdentity& process);

}  // namespace dewbow
