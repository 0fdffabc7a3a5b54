// SPDX-License-Identifier: Apache-2.0
#pragma once

// One writer at a time for a file that takes minutes to make.

#include <filesystem>
#include <string>
#include <vector>

#include "dewbow/base/descriptor.h"

namespace dewbow {

class TemporaryFile;

/// While it lives, no other process gets a FileLock for the same file, under whatever symbolic
/// link.
///
/// It is a hidden file beside the one that is to be written (`.ring.exr.lock`), which names its
/// process and is gone at the end. The kernel holds the lock by flock(2) and gives it back however
/// the process ends, so that a lock file which is left behind locks nothing. On a file system
/// without flock the file's existence is the lock; one whose process has ended, as host, start of
/// the kernel, number and start of the process tell, is taken over. What a process that was killed
/// has left half written beside the lock is removed with it. Devices and FIFOs are not locked:
/// nothing there is replaced.
class FileLock {
public:
    /// Throws InputError if another process holds it, which it names, or if no lock file can be
    /// made there.
    explicit FileLock(const std::filesystem::path& path);
    ~FileLock();
    FileLock(FileLock&& other) noexcept = default;
    FileLock& operator=(FileLock&&) = delete;

    /// What the user should know: whose lock was taken over, or that the file system has no means
    /// to lock. Mostly empty.
    const std::string& remark() const { return remark_; }

private:
    bool try_to_take(const std::filesystem::path& path);
    bool try_to_take_over(const std::filesystem::path& path, TemporaryFile& mine, bool has_flock);

    std::filesystem::path lock_file_;  ///< empty: nothing to give back
    Descriptor held_{-1};              ///< of lock_file_
    std::string remark_;
};

/// A lock for each file that `paths` name; one for two names of the same file.
std::vector<FileLock> lock_files(const std::vector<std::filesystem::path>& paths);

/// Where the lock of a file lies, after symbolic links; empty for what is not locked.
std::filesystem::path lock_file_of(const std::filesystem::path& path);

}  // namespace dewbow
