// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/check.h"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace dewbow {

namespace {

std::string& replay_command() {
    static std::string command;
    return command;
}

}  // namespace

ReplayContext& replay_context() {
    thread_local ReplayContext context;
    return context;
}

void set_replay_command(std::string command) { replay_command() = std::move(command); }

std::string describe(const ReplayContext& context) {
    if (context.pixel_x < 0 || context.pixel_y < 0) return {};
    const std::string pixel =
        std::to_string(context.pixel_x) + "," + std::to_string(context.pixel_y);
    const std::string seed = std::to_string(context.seed);
    std::string what = "pixel " + pixel;
    std::string flags = " --pixel " + pixel;
    if (context.sample >= 0) {
        const std::string sample = std::to_string(context.sample);
        what += " sample " + sample;
        flags += " --sample " + sample;
    }
    what += " seed " + seed;
    flags += " --seed " + seed;
    if (replay_command().empty()) return what;
    return what + "; replay with: " + replay_command() + flags;
}

namespace detail {

void check_failed(std::string_view condition, std::string_view file, int line,
                  std::string_view message) {
    std::string text(file);
    text += ':';
    text += std::to_string(line);
    text += ": check failed: ";
    text += message;
    text += " [";
    text += condition;
    text += "]\n";
    const std::string context = describe(replay_context());
    if (!context.empty()) text += "  at " + context + "\n";
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
    std::abort();
}

}  // namespace detail

}  // namespace dewbow
