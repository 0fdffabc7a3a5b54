// SPDX-License-Identifier: Apache-2.0
#include "job.h"

#include <fmt/format.h>

#include <thread>

#include "dewbow/render/state.h"

namespace dewbow::faults {

namespace fs = std::filesystem;

Words Job::words(int threads, const Words& more) const {
    return Words{"render", kTinyScene, "--size", "48x48", "--quiet", "-o", kOutput} +
           Words{"--spp", fmt::format("{}", samples_per_pixel)} +
           Words{"--threads", fmt::format("{}", threads)} +
           Words{"--checkpoint-every", fmt::format("{:f}s", checkpoint_every.count())} + more;
}

std::size_t finished_units(const Folder& folder) {
    const fs::path state = folder.path() / kState;
    return fs::exists(state) ? load_state(state).plan.finished_units() : 0;
}

Words resume(const Folder& folder) {
    return fs::exists(folder.path() / kState) ? Words{"--resume"} : Words{};
}

Outcome interrupt(const Job& job, const Folder& folder, int signal) {
    Program program(DEWBOW_BINARY, job.words(2, {"--json"}), folder.path());
    while (program.runs() && !fs::exists(folder.path() / kState))
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.send(signal);
    return program.wait();
}

}  // namespace dewbow::faults
