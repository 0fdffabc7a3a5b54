// SPDX-License-Identifier: Apache-2.0
#pragma once

// Descriptors of the operating system's files.

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <utility>

namespace dewbow {

/// A file descriptor that closes itself.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }

    bool is_open() const { return number_ >= 0; }
    int number() const { return number_; }
    /// 0, or the number of the error: a network file system may tell only now that the disk is
    /// full.
    int close();

private:
    int number_;
};

/// What a system call gives when no signal interrupts it any more: -1 with errno, or its value.
template <class Call>
auto not_interrupted(const Call& call) {
    auto result = call();
    while (result < 0 && errno == EINTR) result = call();
    return result;
}

/// open(2), again while signals interrupt it. Not open if it cannot be; then errno tells why.
Descriptor open_retrying(const std::filesystem::path& path, int flags, unsigned mode = 0);

/// 0, or the number of the error: writes all of `bytes`, however many calls it takes.
int write_all(const Descriptor& file, std::string_view bytes);

}  // namespace dewbow
