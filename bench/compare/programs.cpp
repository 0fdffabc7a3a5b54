// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdlib>
#include <sstream>

#include "dewbow/base/error.h"

#include "contestant.h"

namespace dewbow::bench {

std::optional<std::filesystem::path> Programs::find(const std::string& name) const {
    namespace fs = std::filesystem;
    const auto is_program = [](const fs::path& path) {
        return fs::is_regular_file(path) && access(path.c_str(), X_OK) == 0;
    };
    if (const auto named = named_.find(name); named != named_.end()) {
        if (!is_program(named->second))
            throw InputError("'" + named->second.string() + "' is no program (for " + name + ")");
        return fs::absolute(named->second);
    }
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (is_program(fs::path(folder) / name)) return fs::absolute(fs::path(folder) / name);
    return std::nullopt;
}

}  // namespace dewbow::bench
