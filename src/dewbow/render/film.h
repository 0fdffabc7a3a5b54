// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sums of samples that do not depend on the order in which they arrive: fixed-point integers with a
// power-of-two quantum. Threads, ranks and resumed runs add up to the same bits.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dewbow/math/vector.h"
#include "dewbow/render/film_layout.h"
#include "dewbow/render/splat_sums.h"
#include "dewbow/scene/camera.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

/// What one path brings home.
struct PixelSample {
    WavelengthPacket wavelengths;
    /// Radiance estimate of each lane, W m⁻² sr⁻¹ nm⁻¹.
    alignas(64) std::array<double, kMaxLanes> radiance{};
    /// Of estimators that know colours only, in place of lanes: Y of the constant spectrum 1 W m⁻²
    /// sr⁻¹ nm⁻¹ is 1. May be negative, as single samples of a spectrum are.
    std::optional<Colour<Xyz>> colour{};
    // The first thing that is seen; of what is seen through or in glass, the glass itself.
    Colour<Xyz> albedo;  ///< under D65: white is that of linear sRGB (1, 1, 1)
    Vec3 normal;         ///< world frame; zero where nothing is hit
    double depth = 0.0;  ///< m along the camera's axis; 0 where nothing is hit
    bool hit = false;
};

/// A sample that was not a number, infinite or negative, and how to compute it again.
struct InvalidSample {
    int x = 0, y = 0;
    std::int64_t index = 0;
    bool operator==(const InvalidSample&) const = default;
};

/// How many samples were invalid, and the first hundred of them by pixel and index.
struct InvalidSamples {
    std::int64_t count = 0;
    std::vector<InvalidSample> first;  // ascending
    /// Splats of light paths: neither in `count` nor among the first.
    std::int64_t splats = 0;
    void add(const InvalidSamples& other);
};

class FilmSums {
public:
    /// @param width,height  size of the picture.  @param crop  the part of it that is rendered
    /// (memory is taken for this only).  @param reference_radiance  a typical radiance, W m⁻² sr⁻¹
    /// nm⁻¹, from which the quanta follow: XYZ 2⁻⁴⁰ of it (128 bits), spectral bins 2⁻²⁴ of it (64
    /// bits), rounded to a power of two. Those of the layers (64 bits) are 2⁻²⁴ of 1, of a unit
    /// normal and of a metre.
    FilmSums(int width, int height, PixelRect crop, int spectral_bins, double reference_radiance);
    /// An empty film.
    explicit FilmSums(const FilmLayout& layout);

    /// Adds one sample of pixel (x, y) of the whole picture. The one place where a sample that is
    /// not finite, or whose lanes are negative, is found, counted and left out; one whose XYZ
    /// exceed 2⁶² reference radiances is counted too, and clamped there. Different pixels may be
    /// added to at once. A sample that is a colour adds nothing to spectral bins.
    ///
    /// No sum wraps around: XYZ hold 2²⁴ samples of the largest kind, and the sums of 64 bits and
    /// of Y² stop at their largest value, which does not depend on the order because no term is
    /// negative. Cost: about 60 ns with 8 lanes and no bins.
    void add(int x, int y, const PixelSample& sample, std::int64_t index);

    /// Adds the sums of a film whose layout is the same but for the crop, which lies within this
    /// one's. The order of adding does not matter.
    void add(const FilmSums& other);
    /// The same, but for the other's invalid samples, and for what light paths brought.
    void add_pixels(const FilmSums& other);

    /// Adds what `light_paths` more light paths brought.
    void add_splats(const SplatList& splats, std::uint64_t light_paths);
    /// The parts of it: splats, of which there may be none, and the paths that they are shared by.
    SplatSums& splats() { return splats_; }
    const SplatSums& splats() const { return splats_; }
    void add_light_paths(std::uint64_t paths) { light_paths_ += paths; }
    std::uint64_t light_paths() const { return light_paths_; }

    const FilmLayout& layout() const { return layout_; }
    int width() const { return layout_.width; }
    int height() const { return layout_.height; }
    const PixelRect& crop() const { return layout_.crop; }
    int spectral_bins() const { return layout_.spectral_bins; }
    /// Bytes that one pixel takes, in memory and in files; without what light paths brought.
    static std::size_t bytes_per_pixel(int spectral_bins);

    // Averages at a pixel of the crop. Zero where no sample arrived.
    std::uint32_t samples(int x, int y) const;
    /// XYZ as a multiple of the constant spectrum 1 W m⁻² sr⁻¹ nm⁻¹ (Y = 1): the mean of the
    /// pixel's samples, plus what light paths brought.
    Colour<Xyz> xyz(int x, int y) const;
    /// The part of it that light paths brought: the sum of the pixel's splats over their number.
    Colour<Xyz> caustics(int x, int y) const;
    /// Mean spectral radiance in bin `bin` of `spectral_bins` even ones over 360–830 nm.
    double bin(int x, int y, int bin) const;
    Colour<Xyz> albedo(int x, int y) const;
    Vec3 normal(int x, int y) const;
    double depth(int x, int y) const;     ///< mean over samples that hit something
    double coverage(int x, int y) const;  ///< share of samples that hit something
    /// Variance of Y, estimated from the samples and from the splats, which are taken to be of as
    /// many paths; of either, 0 with fewer than two.
    double variance_of_mean(int x, int y) const;

    std::int64_t invalid_samples() const;  ///< and splats
    /// The first of them, at most 100, ordered by pixel and index.
    std::vector<InvalidSample> first_invalid() const;
    InvalidSamples invalid() const;

    /// Appends the sums of the pixels of `part`, which lies in the crop, row by row:
    /// bytes_per_pixel() each, in this machine's byte order.
    void append_pixels(const PixelRect& part, std::string& to) const;
    /// Adds what append_pixels made of the same part of a film of the same quanta and bins.
    /// @param bytes  as many as `part` has.
    void add_pixels(const PixelRect& part, std::string_view bytes);
    void add_invalid(const InvalidSamples& samples);

    /// A hash of all sums: equal if and only if (practically) every integer is.
    std::uint64_t fingerprint() const;

    /// Calls `observer` with each sample that add() is given, before it is looked at; any thread.
    using SampleObserver =
        std::function<void(int x, int y, const PixelSample&, std::int64_t index)>;
    void observe(SampleObserver observer) { observer_ = std::move(observer); }

private:
    enum class Verdict { good, too_large, invalid };

    struct Pixel;

    std::size_t index_of(int x, int y) const;
    Pixel pixel(std::size_t index) const;
    void add_pixel(std::size_t index, const Pixel& sums);
    static bool layers_are_valid(const PixelSample& sample);
    /// The sample's XYZ in quanta; too large ones are clamped.
    Verdict xyz_in_quanta(const PixelSample& sample, std::array<double, 3>& quanta) const;
    void add_bins(std::size_t pixel, const PixelSample& sample);
    void add_layers(std::size_t pixel, const PixelSample& sample);

    FilmLayout layout_;
    double xyz_quantum_, y_squared_quantum_, bin_quantum_, layer_quantum_;
    std::vector<std::uint32_t> counts_, hits_;
    std::vector<std::array<__int128, 3>> xyz_;
    std::vector<__int128> y_squared_;
    std::vector<std::int64_t> bins_sum_;               // [pixel][bin]
    std::vector<std::array<std::int64_t, 7>> layers_;  // albedo XYZ, normal xyz, depth
    SplatSums splats_;
    std::uint64_t light_paths_ = 0;
    // The invalid ones are guarded by a mutex in film.cpp: they are rare.
    InvalidSamples invalid_;
    SampleObserver observer_;
};

}  // namespace dewbow
