// SPDX-License-Identifier: Apache-2.0
#pragma once

// A file that is made whole before it takes its name.

#include <filesystem>
#include <string>
#include <string_view>

#include "dewbow/base/descriptor.h"
#include "dewbow/base/process_identity.h"

namespace dewbow {

/// A new file in a folder, removed again unless it takes a name. Functions that say so return 0 or
/// the number of the system's error.
class TemporaryFile {
public:
    /// Check is_open: errno tells why not.
    explicit TemporaryFile(const std::filesystem::path& folder);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    bool is_open() const { return file_.is_open(); }
    Descriptor& file() { return file_; }
    /// 0 or an error. Interrupted and short writes are gone on with.
    int write(std::string_view bytes);
    /// 0 or an error. The target's own file, if there is one, is replaced in one step.
    int replace(const std::filesystem::path& target);
    /// 0 or an error: EEXIST if there is a file of this name.
    int take_new_name(const std::filesystem::path& target);

private:
    Descriptor create(const std::filesystem::path& folder);

    std::filesystem::path path_;  // before file_, whose construction sets it
    Descriptor file_;
};

/// Removes what a process that was killed has left in `folder`.
void remove_temporary_files(const std::filesystem::path& folder, const ProcessIdentity& process);

}  // namespace dewbow
