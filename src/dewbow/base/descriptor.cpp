// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>

namespace dewbow {

namespace {

// Linux moves at most 0x7ffff000 bytes by one call.
constexpr std::size_t kMostBytesPerCall = std::size_t{1} << 30;

}  // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) ::close(number_);
}

int Descriptor::close() {
    const int result = ::close(std::exchange(number_, -1));
    // Linux has given the descriptor back even then.
    return result == 0 || errno == EINTR ? 0 : errno;
}

Descriptor open_retrying(const std::filesystem::path& path, int flags, unsigned mode) {
    return Descriptor(
        not_interrupted([&] { return ::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, mode); }));
}

int write_all(const Descriptor& file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t put = not_interrupted([&] {
            return ::write(file.number(), bytes.data(), std::min(bytes.size(), kMostBytesPerCall));
        });
        if (put < 0) return errno;
        if (put == 0) return EIO;
        bytes.remove_prefix(static_cast<std::size_t>(put));
    }
    return 0;
}

}  // namespace dewbow
