// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/splat_list.h"

#include <algorithm>
#include <limits>

#include "dewbow/base/check.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

namespace {

constexpr double kMostFloat = std::numeric_limits<float>::max();

/// Comparisons with NaN are false.
bool is_amount(double value) { return value >= 0.0 && value <= kMostFloat; }

}  // namespace

SplatLight::SplatLight(const WavelengthPacket& packet, const LaneSet& lanes,
                       const LaneValues& values)
    : packet_(packet) {
    for (int i = 0; i < lanes.count; ++i)
        radiance_[static_cast<std::size_t>(lanes.id[static_cast<std::size_t>(i)])] = values[i];
    xyz_ = film_xyz(packet, {radiance_.data(), static_cast<std::size_t>(packet.count)});
}

SplatList::SplatList(const FilmLayout& layout)
    : crop_(layout.crop), spectral_bins_(layout.spectral_bins) {
    DEWBOW_CHECK(crop_.area() <= std::numeric_limits<std::uint32_t>::max(),
                 "a pixel's number has 32 bits");
}

void SplatList::add(int x, int y, double weight, const SplatLight& light) {
    if (x < crop_.x0 || x >= crop_.x1 || y < crop_.y0 || y >= crop_.y1) return;
    Splat splat{
        static_cast<std::uint32_t>((y - crop_.y0) * std::int64_t{crop_.width()} + (x - crop_.x0)),
        {}};
    bool valid = true;
    for (std::size_t c = 0; c < 3; ++c) {
        const double value = weight * light.xyz()[c];
        valid = valid && is_amount(value);
        splat.xyz[c] = static_cast<float>(std::min(value, kMostFloat));
    }
    if (!valid) {
        ++invalid_;
        return;
    }
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
                         static_cast<float>(std::min(value, kMostFloat))});
    }
}

}  // namespace dewbow
