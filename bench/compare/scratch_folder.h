// SPDX-License-Identifier: Apache-2.0
#pragma once

// A folder that is gone again with the object.

#include <filesystem>

namespace dewbow::bench {

class ScratchFolder {
public:
    /// In the system's folder for temporary files. Throws InputError.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

}  // namespace dewbow::bench
