// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/splat_sums.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/render/saturating.h"

namespace dewbow {

namespace {

using Wide = __int128;

constexpr int kXyzBits = 40, kSquareBits = 60, kBinBits = 30;
/// 2²⁴ splats of this many quanta fit into 127 bits.
constexpr double kMostQuanta = 0x1p102;
constexpr double kMostSmallQuanta = 0x1p62;
constexpr double kMostSquareQuanta = 0x1p126;

/// To the nearest integer, ties to even, if |quanta| <= 2⁶². From 2⁵³ on a double is one anyway.
Wide round_wide(double quanta) {
    if (quanta < kMostSmallQuanta) return std::llrint(quanta);
    return static_cast<Wide>(quanta);
}

/// Pixels of the whole picture, up to the next power of two.
double splat_scale(const FilmLayout& layout) {
    const auto pixels =
        static_cast<std::uint64_t>(layout.width) * static_cast<std::uint64_t>(layout.height);
    return static_cast<double>(std::bit_ceil(pixels));
}

}  // namespace

SplatSums::SplatSums(const FilmLayout& layout)
    : pixels_(static_cast<std::size_t>(layout.crop.area())),
      spectral_bins_(static_cast<std::size_t>(layout.spectral_bins)) {
    const double reference = std::ldexp(1.0, layout.reference_exponent);
    const double bright = reference * splat_scale(layout);
    xyz_quantum_ = std::ldexp(reference, -kXyzBits);
    y_squared_quantum_ = std::ldexp(bright * bright, -kSquareBits);
    bin_quantum_ = std::ldexp(bright, -kBinBits);
}

std::size_t SplatSums::bytes_per_pixel(int spectral_bins) {
    return sizeof(Sums) + sizeof(std::int64_t) * static_cast<std::size_t>(spectral_bins);
}

std::size_t SplatSums::blocks() const { return (pixels_ + kBlockPixels - 1) / kBlockPixels; }

std::size_t SplatSums::touched_blocks() const {
    return static_cast<std::size_t>(
        std::count_if(blocks_.begin(), blocks_.end(), [](const Block& b) { return !b.empty(); }));
}

std::size_t SplatSums::pixels_of(std::size_t block) const {
    return std::min(kBlockPixels, pixels_ - block * kBlockPixels);
}

SplatSums::Arrived SplatSums::at(std::size_t pixel) const {
    Arrived arrived;
    for (const std::vector<Block>* blocks : {&blocks_, &waiting_}) {
        if (blocks->empty() || (*blocks)[block_of(pixel)].empty()) continue;
        const Sums& sums = (*blocks)[block_of(pixel)].pixels[pixel % kBlockPixels];
        for (std::size_t c = 0; c < 3; ++c)
            arrived.xyz[c] += static_cast<double>(sums.xyz[c]) * xyz_quantum_;
        arrived.y_squared += static_cast<double>(sums.y_squared) * y_squared_quantum_;
    }
    return arrived;
}

double SplatSums::bin(std::size_t pixel, int bin) const {
    double sum = 0.0;
    const std::size_t place =
        (pixel % kBlockPixels) * spectral_bins_ + static_cast<std::size_t>(bin);
    for (const std::vector<Block>* blocks : {&blocks_, &waiting_}) {
        if (blocks->empty() || (*blocks)[block_of(pixel)].empty()) continue;
        sum += static_cast<double>((*blocks)[block_of(pixel)].bins[place]) * bin_quantum_;
    }
    return sum;
}

void SplatSums::prepare() { blocks_.resize(blocks()); }

void SplatSums::take_memory(Block& block, std::size_t number) const {
    if (!block.empty()) return;
    block.pixels.resize(pixels_of(number));
    block.bins.resize(pixels_of(number) * spectral_bins_);
}

SplatSums::Block& SplatSums::block_to_add_to(std::size_t number) {
    const bool waits = !waiting_.empty() && !kept_[number];
    Block& block = waits ? waiting_[number] : blocks_[number];
    take_memory(block, number);
    return block;
}

void SplatSums::add(std::span<const Splat> splats, std::span<const BinSplat> bins) {
    for (const Splat& splat : splats) {
        Sums& sums = block_to_add_to(block_of(splat.pixel)).pixels[splat.pixel % kBlockPixels];
        for (std::size_t c = 0; c < 3; ++c)
            add_saturating(
                sums.xyz[c],
                round_wide(std::min(double{splat.xyz[c]} * (1.0 / xyz_quantum_), kMostQuanta)));
        const double square =
            double{splat.xyz[1]} * double{splat.xyz[1]} * (1.0 / y_squared_quantum_);
        add_saturating(sums.y_squared, round_wide(std::min(square, kMostSquareQuanta)));
    }
    for (const BinSplat& splat : bins) {
        Block& block = block_to_add_to(block_of(splat.pixel));
        const double quanta = double{splat.radiance} * (1.0 / bin_quantum_);
        add_saturating(block.bins[(splat.pixel % kBlockPixels) * spectral_bins_ + splat.bin],
                       std::llrint(std::min(quanta, kMostSmallQuanta)));
    }
}

void SplatSums::add(Block& to, const Block& from) const {
    for (std::size_t i = 0; i < from.pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            add_saturating(to.pixels[i].xyz[c], from.pixels[i].xyz[c]);
        add_saturating(to.pixels[i].y_squared, from.pixels[i].y_squared);
    }
    for (std::size_t i = 0; i < from.bins.size(); ++i) add_saturating(to.bins[i], from.bins[i]);
}

void SplatSums::add(const SplatSums& other) {
    DEWBOW_CHECK(other.pixels_ == pixels_ && other.spectral_bins_ == spectral_bins_ &&
                     other.xyz_quantum_ == xyz_quantum_ && other.waiting_.empty(),
                 "sums of splats that are added have one layout");
    if (other.blocks_.empty()) return;
    prepare();
    for (std::size_t number = 0; number < blocks_.size(); ++number)
        if (other.touched(number)) add(block_to_add_to(number), other.blocks_[number]);
}

void SplatSums::freeze() {
    prepare();
    waiting_.resize(blocks_.size());
    kept_.assign(blocks_.size(), 0);
}

void SplatSums::keep(std::size_t number, std::string* to) {
    if (to && touched(number)) append_block(number, *to);
    kept_[number] = 1;
    if (waiting_[number].empty()) return;
    Block waiting = std::move(waiting_[number]);
    waiting_[number] = {};
    if (touched(number))
        add(blocks_[number], waiting);
    else
        blocks_[number] = std::move(waiting);
}

void SplatSums::thaw() {
    waiting_.clear();
    kept_.clear();
}

std::size_t SplatSums::block_bytes(std::size_t block) const {
    return pixels_of(block) * bytes_per_pixel(static_cast<int>(spectral_bins_));
}

void SplatSums::append_block(std::size_t number, std::string& to) const {
    static_assert(std::is_trivially_copyable_v<Sums> && sizeof(Sums) == 64, "without gaps");
    const Block& block = blocks_[number];
    const auto append = [&to](const auto& values) {
        to.append(reinterpret_cast<const char*>(values.data()),
                  values.size() * sizeof(values.front()));
    };
    append(block.pixels);
    if (!block.bins.empty()) append(block.bins);
}

void SplatSums::add_block(std::size_t number, std::string_view bytes) {
    DEWBOW_CHECK(bytes.size() == block_bytes(number), "there are as many bytes as the block takes");
    Block block;
    take_memory(block, number);
    const std::size_t front = block.pixels.size() * sizeof(Sums);
    std::memcpy(block.pixels.data(), bytes.data(), front);
    if (!block.bins.empty())
        std::memcpy(block.bins.data(), bytes.data() + front, bytes.size() - front);
    bool possible = true;
    for (const Sums& sums : block.pixels) {
        for (const Wide sum : sums.xyz) possible = possible && sum >= 0;
        possible = possible && sums.y_squared >= 0;
    }
    for (const std::int64_t sum : block.bins) possible = possible && sum >= 0;
    if (!possible) throw InputError("damaged: light paths bring no negative light");
    prepare();
    add(block_to_add_to(number), block);
}

}  // namespace dewbow
