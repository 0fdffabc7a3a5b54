// SPDX-License-Identifier: Apache-2.0
#pragma once

// Contracts that hold unless the program is wrong. A broken one prints what was being computed and
// the command that computes just that again, then aborts.

#include <cstdint>
#include <string>
#include <string_view>

namespace dewbow {

/// What the current thread is computing: set by render loops, printed by a failed check and kept
/// with an invalid sample.
struct ReplayContext {
    int pixel_x = -1, pixel_y = -1;
    std::int64_t sample = -1;
    std::uint64_t seed = 0;
};
ReplayContext& replay_context();

/// The command line of this program without `--crop`, `--sample` and `--threads`; set once in main.
void set_replay_command(std::string command);

/// "pixel 12,7 sample 3 seed 0; replay with: dewbow render scene.toml --pixel 12,7 --sample 3
/// --seed 0", or empty if nothing is being rendered.
std::string describe(const ReplayContext& context);

namespace detail {
[[noreturn]] void check_failed(std::string_view condition, std::string_view file, int line,
                               std::string_view message);
}

}  // namespace dewbow

/// Always on. `DEWBOW_CHECK(n > 0, "a mesh has at least one triangle")`.
#define DEWBOW_CHECK(condition, message) \
    (static_cast<bool>(condition)        \
         ? void(0)                       \
         : ::dewbow::detail::check_failed(#condition, __FILE__, __LINE__, message))
