// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a ray carries: numbers in bands. A ray without wavelength has three, the channels of a
// monitor, or one for each 5 nm of the visible range; a sample of the spectrum has three or one.
// Each band has a colour, and light is the sum of its bands' colours.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "dewbow/render/media.h"
#include "dewbow/render/rgb_lanes.h"
#include "dewbow/spectrum/spectral_model.h"

namespace dewbow::distributed_1989 {

/// Those of the visible range: 360, 365 … 830 nm.
inline constexpr int kMostBands = 95;
inline constexpr double kBandStep_nm = 5.0;
static_assert(kLambdaMin_nm + (kMostBands - 1) * kBandStep_nm == kLambdaMax_nm);

/// A number a band. Not initialised; only `count` of them are copied.
class BandValues {
public:
    explicit BandValues(int count) : count_(count) {}
    BandValues(int count, double value) : count_(count) { std::fill_n(v_.begin(), count, value); }
    BandValues(const BandValues& other) { *this = other; }
    BandValues& operator=(const BandValues& other) {
        count_ = other.count_;
        std::copy_n(other.v_.begin(), count_, v_.begin());
        return *this;
    }

    int count() const { return count_; }
    double operator[](int k) const { return v_[std::size_t(k)]; }
    double& operator[](int k) { return v_[std::size_t(k)]; }
    double largest() const { return *std::max_element(v_.begin(), v_.begin() + count_); }
    void scale(double factor) {
        for (int k = 0; k < count_; ++k) v_[std::size_t(k)] *= factor;
    }

private:
    int count_;
    std::array<double, kMostBands> v_;
};

/// Spectra that textures of colours are mixtures of: as they are, or in channels.
struct TextureBases {
    const RgbBasis& light;
    const RgbBasis& reflectance;
};

/// Sixteen bands or fewer, as the surfaces and lights of the scene are asked about them.
struct BandBlock {
    BandBlock(const MediaTable& table, const TextureBases& bases)
        : media(table), light(bases.light), reflectance(bases.reflectance) {}

    /// Of medium `id`, at each lane.
    LaneValues indices(int id) {
        LaneValues index;
        std::copy_n(media.index(id).begin(), lanes.count, index.v.begin());
        return index;
    }

    int first = 0;  ///< number of its first band
    WavelengthPacket packet;
    LaneSet lanes;
    PacketMedia media;
    RgbLightLanes light;
    RgbReflectanceLanes reflectance;
};

class Bands {
public:
    /// @param colours  one a wavelength.   `table` and `bases` outlive this.
    Bands(const MediaTable& table, const TextureBases& bases, std::span<const double> lambda_nm,
          std::span<const MonitorRgb> colours);
    Bands(const Bands&) = delete;
    Bands& operator=(const Bands&) = delete;

    int count() const { return count_; }
    std::vector<BandBlock>& blocks() { return blocks_; }
    /// Of the radiance 1 W m⁻² sr⁻¹ nm⁻¹ in band k.
    MonitorRgb& colour(int k) { return colour_[std::size_t(k)]; }
    /// Where there is a single band.
    void set_wavelength(double lambda_nm);

    /// Σ beta_k radiance_k colour_k over one block.
    MonitorRgb sum(const BandBlock& block, const BandValues& beta,
                   const LaneValues& radiance) const;

private:
    static void begin(BandBlock& block);

    int count_;
    std::vector<BandBlock> blocks_;
    std::vector<MonitorRgb> colour_;
};

}  // namespace dewbow::distributed_1989
