// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/temporary_file.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <random>
#include <system_error>

#include "dewbow/base/hash.h"

namespace dewbow {

namespace {

namespace fs = std::filesystem;

constexpr int kNameTries = 100;

std::string hexadecimal(std::uint64_t value) {
    std::array<char, 16> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
    return {digits.data(), end};
}

/// What the names of a process's temporary files begin with: short, because the target's own name
/// may be as long as a name can be.
std::string name_beginning(const ProcessIdentity& process) {
    std::uint64_t hash = hash_combine(static_cast<std::uint64_t>(process.pid), process.start_ticks);
    for (const std::string* text : {&process.host, &process.boot, &process.pid_namespace})
        hash = hash_combine(hash, hash_of_text(*text));
    return ".dewbow-" + hexadecimal(hash) + "-";
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& folder) : file_(create(folder)) {}

TemporaryFile::~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
}

Descriptor TemporaryFile::create(const fs::path& folder) {
    const std::string beginning = name_beginning(this_process());
    std::random_device random;
    for (int i = 0; i < kNameTries; ++i) {
        const fs::path path = folder / (beginning + std::to_string(random()) + ".tmp");
        Descriptor file = open_retrying(path, O_RDWR | O_CREAT | O_EXCL, 0666);
        if (file.is_open()) path_ = path;
        if (file.is_open() || errno != EEXIST) return file;
    }
    return Descriptor(-1);
}

int TemporaryFile::write(std::string_view bytes) { return write_all(file_, bytes); }

int TemporaryFile::replace(const fs::path& target) {
    const auto rename = [&] { return ::rename(path_.c_str(), target.c_str()); };
    if (not_interrupted(rename) != 0) return errno;
    path_.clear();
    return 0;
}

int TemporaryFile::take_new_name(const fs::path& target) {
    const auto rename = [&] {
        return ::renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE);
    };
    if (not_interrupted(rename) == 0) {
        path_.clear();
        return 0;
    }
    // A file system that cannot, NFS for one, has hard links.
    if (errno != EINVAL && errno != ENOSYS) return errno;
    const auto link = [&] { return ::link(path_.c_str(), target.c_str()); };
    return not_interrupted(link) == 0 ? 0 : errno;
}

void remove_temporary_files(const fs::path& folder, const ProcessIdentity& process) {
    const std::string beginning = name_beginning(process);
    std::error_code error;
    const fs::path listed = folder.empty() ? fs::path(".") : folder;
    for (fs::directory_iterator at(listed, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with(beginning) && name.ends_with(".tmp")) ::unlink(at->path().c_str());
    }
}

}  // namespace dewbow
