// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/read_record.h"

#include <mutex>
#include <optional>
#include <set>

#include "dewbow/base/check.h"
#include "dewbow/base/checksum.h"
#include "dewbow/base/hash.h"

namespace dewbow {

namespace {

std::mutex mutex;
/// Checksums of contents; nothing while no record lives.
std::optional<std::set<std::uint64_t>> contents_read;

}  // namespace

ReadRecord::ReadRecord() {
    const std::scoped_lock lock(mutex);
    DEWBOW_CHECK(!contents_read, "one record lives at a time");
    contents_read.emplace();
}

ReadRecord::~ReadRecord() {
    const std::scoped_lock lock(mutex);
    contents_read.reset();
}

std::uint64_t ReadRecord::hash() const {
    const std::scoped_lock lock(mutex);
    std::uint64_t hash = 0;
    for (const std::uint64_t contents : *contents_read) hash = hash_combine(hash, contents);
    return hash;
}

void ReadRecord::note(std::string_view contents) {
    {
        const std::scoped_lock lock(mutex);
        if (!contents_read) return;
    }
    Checksum checksum;
    checksum.add(contents);
    const std::scoped_lock lock(mutex);
    if (contents_read) contents_read->insert(checksum.value());
}

}  // namespace dewbow
