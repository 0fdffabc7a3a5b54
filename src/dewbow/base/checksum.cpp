// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/checksum.h"

#include <algorithm>
#include <cstring>

#include "dewbow/base/hash.h"

namespace dewbow {

namespace {

std::uint64_t stepped(std::uint64_t state, std::uint64_t word) {
    return mix_bits((state ^ word) + 0x9e3779b97f4a7c15ULL);
}

}  // namespace

void Checksum::step(const char* from) {
    std::uint64_t word = 0;
    std::memcpy(&word, from, kWord);
    state_ = stepped(state_, word);
}

void Checksum::add(std::string_view bytes) {
    bytes_ += bytes.size();
    if (filled_ > 0) {
        const std::size_t part = std::min(bytes.size(), kWord - filled_);
        std::memcpy(rest_.data() + filled_, bytes.data(), part);
        filled_ += part;
        bytes.remove_prefix(part);
        if (filled_ < kWord) return;
        step(rest_.data());
    }
    for (; bytes.size() >= kWord; bytes.remove_prefix(kWord)) step(bytes.data());
    std::memcpy(rest_.data(), bytes.data(), bytes.size());
    filled_ = bytes.size();
}

std::uint64_t Checksum::value() const {
    Checksum end = *this;
    std::fill(end.rest_.begin() + static_cast<std::ptrdiff_t>(filled_), end.rest_.end(), '\0');
    end.step(end.rest_.data());
    return stepped(end.state_, bytes_);
}

}  // namespace dewbow
