// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files: read whole within a limit, written whole or not at all.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "dewbow/base/bytes.h"

namespace dewbow {

/// Largest file that is read into memory: 4 GiB.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;

/// The bytes of a regular file. Throws InputError (does not exist, a folder, not a regular file,
/// not readable, larger than `max_bytes`); the size is checked before memory is taken.
std::string read_file(const std::filesystem::path& path, std::uint64_t max_bytes = kMaxFileBytes);

/// Writes `bytes` beside `path`, flushes them to the disk and renames, so that a reader finds the
/// old file or the new one and never a part. A symbolic link is followed and stays; the mode of the
/// old file stays; a write-protected file is refused. A device or FIFO is written directly, waiting
/// for a FIFO's reader. Throws InputError naming path and reason; then the old file is as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same for bytes that `writer` hands to the sink in pieces. What it throws leaves the old file
/// as it was, too.
void write_file_atomically(const std::filesystem::path& path,
                           const std::function<void(const ByteSink&)>& writer);

/// Reads a regular file in pieces. Throws InputError as read_file does.
class FileSource : public ByteSource {
public:
    explicit FileSource(const std::filesystem::path& path);
    ~FileSource() override;
    void read(char* to, std::size_t size) override;
    std::uint64_t left() const override { return left_; }

private:
    class File;
    std::unique_ptr<File> file_;
    std::uint64_t left_ = 0;
};

/// Throws the InputError that write_file_atomically would throw, as far as that can be known
/// beforehand (missing or read-only folder, path is a folder), so that a render does not fail only
/// at its end.
void check_writable(const std::filesystem::path& path);

/// The file that write_file_atomically would replace, after symbolic links; empty for a device or a
/// FIFO, which keeps its place. Throws as check_writable.
std::filesystem::path replaced_file(const std::filesystem::path& path);

/// The file that `reference`, written in a file of folder `folder`, names: an absolute path without
/// symbolic links, which need not exist. References stay inside the folder: an absolute path, a
/// scheme, a backslash, NUL, `..` that leads out, or a symbolic link out throws InputError. Percent
/// signs mean themselves here: decode before.
std::filesystem::path resolve_inside(const std::filesystem::path& folder,
                                     std::string_view reference);

}  // namespace dewbow
