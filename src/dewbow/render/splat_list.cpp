// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/splat_list.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "dewbow/base/bytes.h"
#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

namespace {

constexpr double kMost = std::numeric_limits<double>::max();
/// Reference radiances of the largest splat, 2 to this power.
constexpr int kLargestExponent = 62;

void append(std::string& to, const auto& values) {
    append_value(to, std::uint64_t{values.size()});
    if (!values.empty())
        to.append(reinterpret_cast<const char*>(values.data()),
                  values.size() * sizeof(values.front()));
}

[[noreturn]] void refuse() { throw InputError("damaged: its list of splats is not possible"); }

void read(std::string_view& from, auto& values) {
    std::uint64_t count = 0;
    if (from.size() < sizeof count) refuse();
    std::memcpy(&count, from.data(), sizeof count);
    from.remove_prefix(sizeof count);
    if (count > from.size() / sizeof(values.front())) refuse();
    if (count == 0) return;
    values.resize(static_cast<std::size_t>(count));
    std::memcpy(values.data(), from.data(), values.size() * sizeof(values.front()));
    from.remove_prefix(values.size() * sizeof(values.front()));
}

/// Comparisons with NaN are false.
bool is_amount(double value, double most) { return value >= 0.0 && value <= most; }

}  // namespace

SplatLight::SplatLight(const WavelengthPacket& packet, const LaneSet& lanes,
                       const LaneValues& values)
    : packet_(packet) {
    for (int i = 0; i < lanes.count; ++i)
        radiance_[static_cast<std::size_t>(lanes.id[static_cast<std::size_t>(i)])] = values[i];
    xyz_ = film_xyz(packet, {radiance_.data(), static_cast<std::size_t>(packet.count)});
}

SplatList::SplatList(const FilmLayout& layout)
    : crop_(layout.crop),
      spectral_bins_(layout.spectral_bins),
      largest_(std::min<double>(std::ldexp(1.0, layout.reference_exponent + kLargestExponent),
                                std::numeric_limits<float>::max())) {
    DEWBOW_CHECK(crop_.area() - 1 <= std::numeric_limits<std::uint32_t>::max(),
                 "a pixel's number has 32 bits");
}

void SplatList::add(int x, int y, double weight, const SplatLight& light) {
    if (x < crop_.x0 || x >= crop_.x1 || y < crop_.y0 || y >= crop_.y1) return;
    Splat splat{
        static_cast<std::uint32_t>((y - crop_.y0) * std::int64_t{crop_.width()} + (x - crop_.x0)),
        {}};
    bool valid = true, large = false;
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = weight * light.xyz()[c];
        valid = valid && is_amount(value, kMost);
        large = large || value > largest_;
        splat.xyz[c] = static_cast<float>(std::min(value, largest_));
    }
    if (!valid || large) ++invalid_;
    if (!valid) return;
    splats_.push_back(splat);
    if (spectral_bins_ > 0) add_bins(splat.pixel, weight, light);
}

void SplatList::add_bins(std::uint32_t pixel, double weight, const SplatLight& light) {
    const WavelengthPacket& packet = light.packet();
    const double bins_per_nm = spectral_bins_ / (kLambdaMax_nm - kLambdaMin_nm);
    const double scale = weight * bins_per_nm / packet.count;
    for (std::size_t k = 0; k < static_cast<std::size_t>(packet.count); ++k) {
        if (light.radiance()[k] == 0.0) continue;
        const double value = light.radiance()[k] / packet.pdf_per_nm[k] * scale;
        const double place = (packet.lambda_nm[k] - kLambdaMin_nm) * bins_per_nm;
        const int bin = std::clamp(static_cast<int>(place), 0, spectral_bins_ - 1);
        bins_.push_back({pixel, static_cast<std::uint32_t>(bin),
                         static_cast<float>(std::min(value, largest_))});
    }
}

void SplatList::append_bytes(std::string& to) const {
    append(to, splats_);
    append(to, bins_);
}

SplatList SplatList::from_bytes(const FilmLayout& layout, std::string_view bytes) {
    SplatList list(layout);
    read(bytes, list.splats_);
    read(bytes, list.bins_);
    if (!bytes.empty()) refuse();
    const auto pixels = static_cast<std::uint64_t>(layout.crop.area());
    for (const Splat& splat : list.splats_) {
        bool possible = splat.pixel < pixels;
        for (const float value : splat.xyz) possible = possible && is_amount(value, list.largest_);
        if (!possible) refuse();
    }
    for (const BinSplat& splat : list.bins_)
        if (splat.pixel >= pixels || !is_amount(splat.radiance, list.largest_) ||
            splat.bin >= static_cast<std::uint32_t>(layout.spectral_bins))
            refuse();
    return list;
}

}  // namespace dewbow
