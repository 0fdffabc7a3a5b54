// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums of what light paths bring to pixels: integers, so that the order of adding does not matter.
// Memory is taken in blocks of pixels, where light has arrived. Many threads may work on different
// blocks at once; LiveState sees to it that they do.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/render/splat_list.h"

namespace dewbow {

class SplatSums {
public:
    /// Pixels of a block: 16 kB, and 2 kB more for each bin.
    static constexpr std::size_t kBlockPixels = 256;

    /// Quanta: XYZ 2⁻⁴⁰ of the film's reference (128 bits). One splat is about as many times
    /// brighter than its pixel as the picture has pixels, P (rounded up to a power of two); so
    /// those of Y² are 2⁻⁶⁰ of (P references)² (128 bits), and those of bins 2⁻³⁰ of P references
    /// (64 bits). Splats are not negative, and sums stop at their largest value.
    explicit SplatSums(const FilmLayout& layout);

    /// Bytes that one pixel takes where light has arrived.
    static std::size_t bytes_per_pixel(int spectral_bins);

    /// What arrived at one pixel. The numbers are sums over splats, not yet over light paths.
    struct Arrived {
        Colour<Xyz> xyz;
        double y_squared = 0.0;
    };
    Arrived at(std::size_t pixel) const;
    double bin(std::size_t pixel, int bin) const;  ///< W m⁻² sr⁻¹ nm⁻¹

    static std::size_t block_of(std::size_t pixel) { return pixel / kBlockPixels; }
    std::size_t blocks() const;  ///< touched or not
    bool touched(std::size_t block) const { return !blocks_.empty() && !blocks_[block].empty(); }
    std::size_t touched_blocks() const;

    /// Takes the memory that says where blocks are (0.4 bytes a pixel), so that different blocks
    /// may be added to at once.
    void prepare();
    /// Adds splats. Cost: about 20 ns each.
    void add(std::span<const Splat> splats, std::span<const BinSplat> bins);
    void add(const SplatSums& other);  ///< of the same layout

    /// From now on what is added to blocks that are not kept yet waits beside them, so that keep()
    /// finds all blocks as they are at this moment. What is waiting counts for at() and bin().
    void freeze();
    /// Appends the block as it was when frozen, if it was touched then, and adds what was waiting.
    void keep(std::size_t block, std::string* to);
    /// All blocks are kept.
    void thaw();

    /// Of a block that is touched: the sums of its pixels, in this machine's byte order.
    void append_block(std::size_t block, std::string& to) const;
    std::size_t block_bytes(std::size_t block) const;
    /// Adds what append_block made of the same block. Throws InputError if a sum is negative.
    void add_block(std::size_t block, std::string_view bytes);

    /// Calls visit(word) for all sums that are not zero, and where they are: equal sums, equal
    /// words.
    template <class Visit>
    void for_each_word(Visit visit) const;

private:
    struct Sums {
        std::array<__int128, 3> xyz{};
        __int128 y_squared = 0;
        bool operator==(const Sums&) const = default;
    };
    struct Block {
        std::vector<Sums> pixels;
        std::vector<std::int64_t> bins;  // [pixel][bin]
        bool empty() const { return pixels.empty(); }
    };

    std::size_t pixels_of(std::size_t block) const;
    Block& block_to_add_to(std::size_t block);
    void take_memory(Block& block, std::size_t number) const;
    void add(Block& to, const Block& from) const;

    std::size_t pixels_;
    std::size_t spectral_bins_;
    double xyz_quantum_, y_squared_quantum_, bin_quantum_;
    std::vector<Block> blocks_;
    std::vector<Block> waiting_;  // as many, while frozen
    std::vector<char> kept_;      // as many, while frozen
};

template <class Visit>
void SplatSums::for_each_word(Visit visit) const {
    const auto visit_wide = [&](__int128 sum) {
        visit(static_cast<std::uint64_t>(sum));
        visit(static_cast<std::uint64_t>(sum >> 64));
    };
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Block& block = blocks_[b];
        for (std::size_t i = 0; i < block.pixels.size(); ++i) {
            if (block.pixels[i] == Sums{}) continue;
            visit(b * kBlockPixels + i);
            for (const __int128 sum : block.pixels[i].xyz) visit_wide(sum);
            visit_wide(block.pixels[i].y_squared);
            for (std::size_t bin = 0; bin < spectral_bins_; ++bin)
                visit(static_cast<std::uint64_t>(block.bins[i * spectral_bins_ + bin]));
        }
    }
}

}  // namespace dewbow
