// SPDX-License-Identifier: Apache-2.0
#include "memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string_view>

#include "dewbow/base/error.h"
#include "dewbow/base/parse_number.h"

namespace dewbow {

namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// "1.5 GB"
std::string in_bytes(std::uint64_t bytes) {
    constexpr std::string_view kUnits[] = {"kB", "MB", "GB", "TB"};
    double value = static_cast<double>(bytes) / 1000.0;
    std::size_t unit = 0;
    for (; value >= 1000.0 && unit + 1 < std::size(kUnits); ++unit) value /= 1000.0;
    return fmt::format("{:.1f} {}", value, kUnits[unit]);
}

/// The number before "kB" in the line of /proc/meminfo that begins with `key`.
std::uint64_t meminfo_bytes(std::string_view key) {
    std::uint64_t bytes = kUnlimited;
    std::FILE* file = std::fopen("/proc/meminfo", "r");
    if (!file) return bytes;
    char line[256];
    while (std::fgets(line, sizeof line, file)) {
        std::string_view text(line);
        if (!text.starts_with(key)) continue;
        text.remove_prefix(key.size());
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        if (const auto value = parse_number<std::uint64_t>(text.substr(0, text.find(' '))))
            bytes = *value * 1024;
    }
    std::fclose(file);
    return bytes;
}

std::uint64_t physical_memory() {
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0) return kUnlimited;
    return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

std::uint64_t address_space_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnlimited;
    return limit.rlim_cur;
}

}  // namespace

std::uint64_t available_memory() {
    return std::min({meminfo_bytes("MemAvailable:"), physical_memory(), address_space_limit()});
}

std::uint64_t picture_memory(const PixelRect& crop, int spectral_bins, bool light_paths) {
    // Floats of the picture's layers, and about as much again while they are encoded.
    const std::uint64_t layers = light_paths ? 14 : 11;
    const std::uint64_t image =
        2 * sizeof(float) * (layers + static_cast<std::uint64_t>(spectral_bins));
    // What light paths bring, and as much again that waits while a state is written.
    const std::uint64_t splats = light_paths ? 2 * SplatSums::bytes_per_pixel(spectral_bins) : 0;
    return (FilmSums::bytes_per_pixel(spectral_bins) + splats + image) *
           static_cast<std::uint64_t>(crop.width()) * static_cast<std::uint64_t>(crop.height());
}

void check_memory(const PixelRect& crop, int spectral_bins, bool light_paths) {
    const std::uint64_t needed = picture_memory(crop, spectral_bins, light_paths);
    const std::uint64_t available = available_memory();
    if (needed <= available) return;
    throw InputError(
        fmt::format("a picture of {}x{} pixels{} takes {} of memory, and {} are free", crop.width(),
                    crop.height(),
                    spectral_bins > 0 ? fmt::format(" with {} spectral bins", spectral_bins) : "",
                    in_bytes(needed), in_bytes(available)),
        "make it smaller with --size, or render parts of it with --crop");
}

}  // namespace dewbow
