// SPDX-License-Identifier: Apache-2.0
#pragma once

// A program that runs to its end, and what it cost.

#include <filesystem>
#include <string>
#include <vector>

namespace dewbow::bench {

struct ChildUsage {
    double cpu_s = 0.0;  ///< user and system, of the process and those that it waited for
    double wall_s = 0.0;
    double peak_memory_MiB = 0.0;  ///< resident, of the process; looked at every 5 ms
    int exit_code = 0;             ///< 128 + the signal's number if one ended it
};

/// Runs `words` (the program's path first) in `folder`, with nothing on standard input; what it
/// says goes to `folder / "log.txt"`. Throws InputError if it cannot be started.
ChildUsage run_child(const std::vector<std::string>& words, const std::filesystem::path& folder);

/// The end of what a child in `folder` has said, for messages.
std::string log_tail(const std::filesystem::path& folder);

/// The first line that a program prints on standard output or error, for its version.
std::string first_line_of(const std::vector<std::string>& words);

}  // namespace dewbow::bench
