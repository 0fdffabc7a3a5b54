// SPDX-License-Identifier: Apache-2.0
#pragma once

// What light paths bring to pixels, gathered for one unit of them and then added to the film at
// once.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/render/film_layout.h"
#include "dewbow/render/lanes.h"

namespace dewbow {

/// XYZ for one pixel. Single precision: its rounding, 6·10⁻⁸, is the same on every machine, has no
/// preferred sign and is far below the noise of one path.
struct Splat {
    std::uint32_t pixel;       ///< in the crop, row by row
    std::array<float, 3> xyz;  ///< Y of the constant spectrum 1 W m⁻² sr⁻¹ nm⁻¹ is 1
};
/// The same light, where the film keeps spectra: what one wavelength adds to one bin of one pixel.
struct BinSplat {
    std::uint32_t pixel;
    std::uint32_t bin;
    float radiance;  ///< W m⁻² sr⁻¹ nm⁻¹, a mean over the bin
};

/// What a light path sends from one vertex to the camera: values of the lanes that it carries, W
/// m⁻² sr⁻¹ nm⁻¹, and their XYZ. All lanes of a splat are summed before they meet the film.
class SplatLight {
public:
    /// @param packet  of the path; the estimate is the mean over all its lanes, carried or not.
    SplatLight(const WavelengthPacket& packet, const LaneSet& lanes, const LaneValues& values);

    const Colour<Xyz>& xyz() const { return xyz_; }
    const WavelengthPacket& packet() const { return packet_; }
    /// By lane of the packet.
    const std::array<double, kMaxLanes>& radiance() const { return radiance_; }

private:
    const WavelengthPacket& packet_;
    alignas(64) std::array<double, kMaxLanes> radiance_{};
    Colour<Xyz> xyz_;
};

class SplatList {
public:
    explicit SplatList(const FilmLayout& layout);

    /// Adds `weight` times `light` to pixel (x, y) of the whole picture; a pixel outside the crop
    /// drops it. The value is such that the mean over all light paths of a pixel's splats is the
    /// radiance that it gets from them. One that is not finite or negative is counted and left out;
    /// one beyond 2⁶² reference radiances of the film, or the largest float, is counted and
    /// clamped.
    void add(int x, int y, double weight, const SplatLight& light);

    const std::vector<Splat>& splats() const { return splats_; }
    const std::vector<BinSplat>& bins() const { return bins_; }
    std::int64_t invalid() const { return invalid_; }
    void add_invalid(std::int64_t splats) { invalid_ += splats; }

    /// Appends all splats, 16 bytes each, and those of bins, 12 bytes each; but for how many were
    /// invalid.
    void append_bytes(std::string& to) const;
    /// What append_bytes made of a list for the same film. Throws InputError if that cannot be.
    static SplatList from_bytes(const FilmLayout& layout, std::string_view bytes);

private:
    void add_bins(std::uint32_t pixel, double weight, const SplatLight& light);

    PixelRect crop_;
    int spectral_bins_;
    double largest_;
    std::vector<Splat> splats_;
    std::vector<BinSplat> bins_;
    std::int64_t invalid_ = 0;
};

}  // namespace dewbow
