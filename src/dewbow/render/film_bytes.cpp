// SPDX-License-Identifier: Apache-2.0
// Films that are added, and the bytes in which they travel.
#include <cstring>
#include <type_traits>

#include "dewbow/base/check.h"
#include "dewbow/render/film.h"
#include "dewbow/render/saturating.h"

namespace dewbow {

namespace {

bool lies_inside(const PixelRect& part, const PixelRect& whole) {
    return part.x0 >= whole.x0 && part.y0 >= whole.y0 && part.x1 <= whole.x1 && part.y1 <= whole.y1;
}

}  // namespace

/// The sums of one pixel but for its bins, which follow it.
struct FilmSums::Pixel {
    std::array<__int128, 3> xyz;
    __int128 y_squared;
    std::array<std::int64_t, 7> layers;
    std::uint32_t count, hits;
};

FilmSums::Pixel FilmSums::pixel(std::size_t index) const {
    return {xyz_[index], y_squared_[index], layers_[index], counts_[index], hits_[index]};
}

void FilmSums::add_pixel(std::size_t index, const Pixel& sums) {
    for (std::size_t c = 0; c < sums.xyz.size(); ++c) add_saturating(xyz_[index][c], sums.xyz[c]);
    add_saturating(y_squared_[index], sums.y_squared);
    for (std::size_t c = 0; c < sums.layers.size(); ++c)
        add_saturating(layers_[index][c], sums.layers[c]);
    counts_[index] += sums.count;
    hits_[index] += sums.hits;
}

void FilmSums::add(const FilmSums& other) {
    add_pixels(other);
    add_invalid(other.invalid());
    if (other.light_paths_ == 0) return;
    splats_.add(other.splats_);
    light_paths_ += other.light_paths_;
}

void FilmSums::add_splats(const SplatList& splats, std::uint64_t light_paths) {
    splats_.prepare();
    splats_.add(splats.splats(), splats.bins());
    add_invalid({0, {}, splats.invalid()});
    light_paths_ += light_paths;
}

void FilmSums::add_pixels(const FilmSums& other) {
    FilmLayout same = other.layout_;
    same.crop = layout_.crop;
    DEWBOW_CHECK(same == layout_ && lies_inside(other.crop(), crop()),
                 "films that are added have one layout, and one crop lies within the other");
    const auto bins = static_cast<std::size_t>(layout_.spectral_bins);
    std::size_t from = 0;
    for (int y = other.crop().y0; y < other.crop().y1; ++y) {
        std::size_t to = index_of(other.crop().x0, y);
        for (int x = other.crop().x0; x < other.crop().x1; ++x, ++from, ++to) {
            add_pixel(to, other.pixel(from));
            for (std::size_t bin = 0; bin < bins; ++bin)
                add_saturating(bins_sum_[to * bins + bin], other.bins_sum_[from * bins + bin]);
        }
    }
}

void FilmSums::append_pixels(const PixelRect& part, std::string& to) const {
    static_assert(std::is_trivially_copyable_v<Pixel> && sizeof(Pixel) == 128, "without gaps");
    DEWBOW_CHECK(lies_inside(part, crop()), "the part lies in the film's crop");
    const auto bins = static_cast<std::size_t>(layout_.spectral_bins);
    const auto append = [&to](const void* from, std::size_t size) {
        to.append(static_cast<const char*>(from), size);
    };
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            const std::size_t index = index_of(x, y);
            const Pixel sums = pixel(index);
            append(&sums, sizeof sums);
            if (bins > 0) append(&bins_sum_[index * bins], bins * sizeof(std::int64_t));
        }
    }
}

void FilmSums::add_pixels(const PixelRect& part, std::string_view bytes) {
    const auto bins = static_cast<std::size_t>(layout_.spectral_bins);
    DEWBOW_CHECK(lies_inside(part, crop()), "the part lies in the film's crop");
    DEWBOW_CHECK(bytes.size() == static_cast<std::size_t>(part.width()) *
                                     static_cast<std::size_t>(part.height()) *
                                     bytes_per_pixel(layout_.spectral_bins),
                 "there are as many bytes as the pixels take");
    const char* from = bytes.data();
    const auto take = [&from](auto& value) {
        std::memcpy(&value, from, sizeof value);
        from += sizeof value;
    };
    for (int y = part.y0; y < part.y1; ++y) {
        for (int x = part.x0; x < part.x1; ++x) {
            const std::size_t index = index_of(x, y);
            Pixel sums;
            take(sums);
            add_pixel(index, sums);
            for (std::size_t bin = 0; bin < bins; ++bin) {
                std::int64_t sum = 0;
                take(sum);
                add_saturating(bins_sum_[index * bins + bin], sum);
            }
        }
    }
}

}  // namespace dewbow
