// SPDX-License-Identifier: Apache-2.0
#pragma once

// How large a picture is taken from a file: asked before memory is, by every decoder.

#include <cstddef>
#include <cstdint>
#include <string>

namespace dewbow {

inline constexpr int kMaxImageSide = 1 << 16;
inline constexpr std::int64_t kMaxImagePixels = std::int64_t{1} << 28;
inline constexpr int kMaxImageChannels = 1024;
/// Pixels times channels: 4 GiB of floats.
inline constexpr std::int64_t kMaxImageValues = std::int64_t{1} << 30;
/// Values that any file may claim, however short: 64 Mi, which are 256 MiB of floats.
inline constexpr std::int64_t kFreeImageValues = std::int64_t{1} << 26;
/// Values a byte of file beyond those: above what a picture of one colour reaches in ZIP (about 500
/// halves a byte) or DWAB (about 1250).
inline constexpr std::int64_t kMaxValuesPerByte = 4096;

/// Throws InputError naming `name` unless a picture of this size may be decoded from a file of
/// `file_bytes`.
void check_image_size(const std::string& name, std::int64_t width, std::int64_t height,
                      std::int64_t channels, std::size_t file_bytes);

}  // namespace dewbow
