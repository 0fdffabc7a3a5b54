// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <new>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "interrupt.h"

namespace {

using namespace dewbow;

struct Run {
    int operator()(const ShowText& show) const { return print_data(show.text), kDone; }
    int operator()(const RenderCommand& command) const { return run_render(command); }
    int operator()(const SceneCheckCommand& command) const { return run_scene_check(command); }
    int operator()(const GlassCommand& command) const {
        return std::visit([](const auto& subcommand) { return run(subcommand); }, command);
    }
    int operator()(const RainbowCommand& command) const { return run(command); }
    int operator()(const SpectrumCommand& command) const { return run(command); }
    int operator()(const MergeCommand& command) const { return run(command); }
};

/// Never throws.
int fail(int code, const char* what) noexcept {
    try {
        print_error(what);
    } catch (...) {
        // There is no memory even for the message; the exit code still tells.
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        prepare_signals();
        return std::visit(Run{}, parse_command_line(argc, argv));
    } catch (const UsageError& error) {
        return fail(kUsedWrongly, error.what());
    } catch (const InputError& error) {
        return fail(kFailed, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kFailed, "out of memory");
    } catch (const std::exception& error) {
        return fail(kFailed, error.what());
    } catch (...) {
        return fail(kFailed, "an error of unknown kind");
    }
}
