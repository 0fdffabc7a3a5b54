// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/bands.h"

#include "dewbow/base/check.h"

namespace dewbow::distributed_1989 {

Bands::Bands(const MediaTable& table, const TextureBases& bases, std::span<const double> lambda_nm,
             std::span<const MonitorRgb> colours)
    : count_(int(lambda_nm.size())), colour_(colours.begin(), colours.end()) {
    DEWBOW_CHECK(lambda_nm.size() == colours.size(), "each band has a colour");
    DEWBOW_CHECK(count_ >= 1 && count_ <= kMostBands, "a ray has 1 to 95 bands");
    const int blocks = (count_ + kMaxLanes - 1) / kMaxLanes;
    blocks_.reserve(std::size_t(blocks));  // they stay where they are: lanes point to packets
    for (int b = 0; b < blocks; ++b) {
        BandBlock& block = blocks_.emplace_back(table, bases);
        block.first = b * kMaxLanes;
        block.packet.count = std::min(kMaxLanes, count_ - block.first);
        std::copy_n(lambda_nm.begin() + block.first, block.packet.count,
                    block.packet.lambda_nm.begin());
        begin(block);
    }
}

void Bands::begin(BandBlock& block) {
    block.lanes = LaneSet::all(block.packet);
    block.media.begin(block.packet);
    block.light.begin(block.packet);
    block.reflectance.begin(block.packet);
}

void Bands::set_wavelength(double lambda_nm) {
    DEWBOW_CHECK(count_ == 1, "one band has one wavelength");
    BandBlock& block = blocks_.front();
    if (block.packet.lambda_nm[0] == lambda_nm) return;
    block.packet.lambda_nm[0] = lambda_nm;
    begin(block);
}

MonitorRgb Bands::sum(const BandBlock& block, const BandValues& beta,
                      const LaneValues& radiance) const {
    MonitorRgb sum;
    for (int k = 0; k < block.lanes.count; ++k) {
        const int band = block.first + k;
        const MonitorRgb& colour = colour_[std::size_t(band)];
        const double amount = beta[band] * radiance[k];
        for (std::size_t c = 0; c < 3; ++c) sum[c] += amount * colour[c];
    }
    return sum;
}

}  // namespace dewbow::distributed_1989
