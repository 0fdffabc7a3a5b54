// SPDX-License-Identifier: Apache-2.0
#include "scratch_folder.h"

#include <cstdlib>
#include <string>

#include "dewbow/base/error.h"

namespace dewbow::bench {

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "dewbow-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw InputError("cannot make a folder like '" + name + "'");
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace dewbow::bench
