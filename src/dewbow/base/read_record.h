// SPDX-License-Identifier: Apache-2.0
#pragma once

// What was read: a hash of the contents of files.

#include <cstdint>
#include <string_view>

namespace dewbow {

/// While it lives, it takes note of what read_file reads, on any thread. One at a time.
class ReadRecord {
public:
    ReadRecord();
    ~ReadRecord();
    ReadRecord(const ReadRecord&) = delete;
    ReadRecord& operator=(const ReadRecord&) = delete;

    /// Of the set of contents so far: names, order and repetition do not count.
    std::uint64_t hash() const;

    /// Called by read_file.
    static void note(std::string_view contents);
};

}  // namespace dewbow
