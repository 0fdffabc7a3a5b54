// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/film.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <tuple>

#include "dewbow/base/check.h"
#include "dewbow/base/random.h"
#include "dewbow/render/saturating.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/spectrum.h"

namespace dewbow {

namespace {

using Wide = __int128;

constexpr int kXyzBits = 40;
constexpr int kBinBits = 24;
constexpr int kLayerBits = 24;
/// Of Y²: of dark pixels something must be left, of bright ones the sum must not saturate. 2⁻⁶⁰
/// resolves samples of 2⁻³⁰ of the reference, and holds 4096 samples of 2²⁷ times it.
constexpr int kSquareBits = 60;

/// 2²⁴ samples of this many quanta fit into 127 bits.
constexpr double kMostQuanta = 0x1p102;
constexpr double kMostSmallQuanta = 0x1p62;
constexpr double kMostSquareQuanta = 0x1p126;

/// No unit vector is longer; what little a rounding error adds does no harm.
constexpr double kLongestNormal = 2.0;
constexpr std::size_t kKeptInvalid = 100;

/// Beyond these no picture means anything, and quanta and their inverses would leave the doubles.
constexpr double kSmallestReference = 1e-30;
constexpr double kLargestReference = 1e30;

/// To the nearest integer, ties to even. @param quanta  |quanta| <= 2⁶²
std::int64_t round_small(double quanta) { return std::llrint(quanta); }

/// The same for |quanta| <= 2¹²⁶. From 2⁵³ on a double is an integer anyway.
Wide round_wide(double quanta) {
    if (std::abs(quanta) < kMostSmallQuanta) return round_small(quanta);
    return static_cast<Wide>(quanta);
}

/// One lock for all films: invalid samples are rare.
std::mutex& invalid_mutex() {
    static std::mutex mutex;
    return mutex;
}

bool comes_before(const InvalidSample& a, const InvalidSample& b) {
    return std::tie(a.y, a.x, a.index) < std::tie(b.y, b.x, b.index);
}

bool lanes_are_amounts(const PixelSample& sample) {
    constexpr double kMost = std::numeric_limits<double>::max();
    const int lanes = sample.wavelengths.count;
    DEWBOW_CHECK(lanes >= 1 && lanes <= kMaxLanes, "a packet has 1 to 16 lanes");
    bool amounts = true;
    for (int k = 0; k < lanes; ++k)
        amounts &= (sample.radiance[k] >= 0.0) & (sample.radiance[k] <= kMost);
    return amounts;
}

class Hash {
public:
    void add(std::uint64_t word) { state_ = hash_combine(state_, word); }
    void add(std::int64_t word) { add(static_cast<std::uint64_t>(word)); }
    void add(int word) { add(static_cast<std::uint64_t>(word)); }
    void add(Wide word) {
        add(static_cast<std::uint64_t>(word));
        add(static_cast<std::uint64_t>(word >> 64));
    }
    void add_power_of_two(double quantum) { add(std::ilogb(quantum)); }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0;
};

}  // namespace

Colour<Xyz> film_xyz(const WavelengthPacket& packet, std::span<const double> radiance) {
    static const double kPerWhite = 1.0 / cie_y_integral();
    return xyz_from_lanes(packet, radiance) * kPerWhite;
}

void InvalidSamples::add(const InvalidSamples& other) {
    count += other.count;
    splats += other.splats;
    std::vector<InvalidSample> both;
    std::merge(first.begin(), first.end(), other.first.begin(), other.first.end(),
               std::back_inserter(both), comes_before);
    if (both.size() > kKeptInvalid) both.resize(kKeptInvalid);
    first = std::move(both);
}

int reference_exponent(double radiance) {
    DEWBOW_CHECK(radiance > 0.0, "the reference radiance is above zero");
    // Exact: a logarithm may differ between machines.
    int exponent = 0;
    const double mantissa = std::frexp(std::clamp(radiance, kSmallestReference, kLargestReference),
                                       &exponent);  // in [1/2, 1)
    constexpr double kSqrtHalf = 0.70710678118654752;
    return mantissa < kSqrtHalf ? exponent - 1 : exponent;
}

FilmSums::FilmSums(int width, int height, PixelRect crop, int spectral_bins,
                   double reference_radiance)
    : FilmSums(
          FilmLayout{width, height, crop, spectral_bins, reference_exponent(reference_radiance)}) {}

FilmSums::FilmSums(const FilmLayout& layout) : layout_(layout), splats_(layout) {
    const PixelRect& crop = layout.crop;
    DEWBOW_CHECK(crop.x0 >= 0 && crop.y0 >= 0 && crop.x0 < crop.x1 && crop.y0 < crop.y1 &&
                     crop.x1 <= layout.width && crop.y1 <= layout.height,
                 "the crop is a part of the picture and not empty");
    DEWBOW_CHECK(layout.spectral_bins >= 0, "a number of bins is not negative");
    const double reference = std::ldexp(1.0, layout.reference_exponent);
    xyz_quantum_ = std::ldexp(reference, -kXyzBits);
    y_squared_quantum_ = std::ldexp(reference * reference, -kSquareBits);
    bin_quantum_ = std::ldexp(reference, -kBinBits);
    layer_quantum_ = std::ldexp(1.0, -kLayerBits);

    const auto pixels =
        static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
    counts_.resize(pixels);
    hits_.resize(pixels);
    xyz_.resize(pixels);
    y_squared_.resize(pixels);
    bins_sum_.resize(pixels * static_cast<std::size_t>(layout.spectral_bins));
    layers_.resize(pixels);
}

std::size_t FilmSums::bytes_per_pixel(int spectral_bins) {
    return 2 * sizeof(std::uint32_t) + 4 * sizeof(Wide) +
           sizeof(std::int64_t) * (7 + static_cast<std::size_t>(spectral_bins));
}

std::size_t FilmSums::index_of(int x, int y) const {
    DEWBOW_CHECK(x >= crop().x0 && x < crop().x1 && y >= crop().y0 && y < crop().y1,
                 "the pixel lies in the film's crop");
    return static_cast<std::size_t>(y - crop().y0) * static_cast<std::size_t>(crop().width()) +
           static_cast<std::size_t>(x - crop().x0);
}

void FilmSums::add(int x, int y, const PixelSample& sample, std::int64_t index) {
    if (observer_) observer_(x, y, sample, index);
    const std::size_t pixel = index_of(x, y);

    std::array<double, 3> quanta;
    const Verdict verdict =
        layers_are_valid(sample) ? xyz_in_quanta(sample, quanta) : Verdict::invalid;
    if (verdict != Verdict::good) add_invalid({1, {{x, y, index}}});
    if (verdict == Verdict::invalid) return;

    for (std::size_t c = 0; c < 3; ++c) xyz_[pixel][c] += round_wide(quanta[c]);
    const double luminance = quanta[1] * xyz_quantum_;
    const double square = luminance * luminance * (1.0 / y_squared_quantum_);
    add_saturating(y_squared_[pixel], round_wide(std::min(square, kMostSquareQuanta)));
    ++counts_[pixel];
    if (layout_.spectral_bins > 0 && !sample.colour) add_bins(pixel, sample);
    add_layers(pixel, sample);
}

bool FilmSums::layers_are_valid(const PixelSample& sample) {
    constexpr double kMost = std::numeric_limits<double>::max();
    // Comparisons with NaN are false.
    const auto is_amount = [](double v) { return v >= 0.0 && v <= kMost; };
    bool valid = is_amount(sample.depth) && is_finite(sample.normal);
    for (const double value : sample.albedo.v) valid = valid && is_amount(value);
    return valid;
}

FilmSums::Verdict FilmSums::xyz_in_quanta(const PixelSample& sample,
                                          std::array<double, 3>& quanta) const {
    constexpr double kMost = std::numeric_limits<double>::max();
    if (!sample.colour && !lanes_are_amounts(sample)) return Verdict::invalid;
    const auto lanes = static_cast<std::size_t>(sample.wavelengths.count);
    const Colour<Xyz> xyz = sample.colour
                                ? *sample.colour
                                : film_xyz(sample.wavelengths, {sample.radiance.data(), lanes});
    const double least = sample.colour ? -kMost : 0.0;
    bool large = false;
    for (std::size_t c = 0; c < 3; ++c) {
        // A product with a power of two is exact.
        quanta[c] = xyz[c] * (1.0 / xyz_quantum_);
        if (!(quanta[c] >= least && quanta[c] <= kMost)) return Verdict::invalid;
        large |= std::abs(quanta[c]) > kMostQuanta;
        quanta[c] = std::clamp(quanta[c], -kMostQuanta, kMostQuanta);
    }
    return large ? Verdict::too_large : Verdict::good;
}

void FilmSums::add_bins(std::size_t pixel, const PixelSample& sample) {
    const WavelengthPacket& packet = sample.wavelengths;
    const double bins_per_nm = layout_.spectral_bins / (kLambdaMax_nm - kLambdaMin_nm);
    const double scale = bins_per_nm / (packet.count * bin_quantum_);
    std::int64_t* sums = &bins_sum_[pixel * static_cast<std::size_t>(layout_.spectral_bins)];
    for (int k = 0; k < packet.count; ++k) {
        const double place = (packet.lambda_nm[k] - kLambdaMin_nm) * bins_per_nm;
        const int bin = std::clamp(static_cast<int>(place), 0, layout_.spectral_bins - 1);
        const double quanta = sample.radiance[k] / packet.pdf_per_nm[k] * scale;
        add_saturating(sums[bin], round_small(std::min(quanta, kMostSmallQuanta)));
    }
}

void FilmSums::add_layers(std::size_t pixel, const PixelSample& sample) {
    std::array<std::int64_t, 7>& sums = layers_[pixel];
    const double scale = 1.0 / layer_quantum_;
    for (std::size_t c = 0; c < 3; ++c)
        add_saturating(sums[c], round_small(std::min(sample.albedo[c] * scale, kMostSmallQuanta)));
    if (!sample.hit) return;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = std::clamp(sample.normal[axis], -kLongestNormal, kLongestNormal);
        sums[3 + static_cast<std::size_t>(axis)] += round_small(along * scale);
    }
    add_saturating(sums[6], round_small(std::min(sample.depth * scale, kMostSmallQuanta)));
    ++hits_[pixel];
}

void FilmSums::add_invalid(const InvalidSamples& samples) {
    if (samples.count == 0 && samples.splats == 0) return;
    const std::scoped_lock lock(invalid_mutex());
    invalid_.add(samples);
}

std::uint32_t FilmSums::samples(int x, int y) const { return counts_[index_of(x, y)]; }

Colour<Xyz> FilmSums::xyz(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    Colour<Xyz> mean = caustics(x, y);
    if (counts_[pixel] == 0) return mean;
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] += static_cast<double>(xyz_[pixel][c]) * xyz_quantum_ / counts_[pixel];
    return mean;
}

Colour<Xyz> FilmSums::caustics(int x, int y) const {
    if (light_paths_ == 0) return {};
    return splats_.at(index_of(x, y)).xyz * (1.0 / static_cast<double>(light_paths_));
}

double FilmSums::bin(int x, int y, int bin) const {
    DEWBOW_CHECK(bin >= 0 && bin < layout_.spectral_bins, "the film has that bin");
    const std::size_t pixel = index_of(x, y);
    double mean = 0.0;
    if (light_paths_ > 0) mean = splats_.bin(pixel, bin) / static_cast<double>(light_paths_);
    if (counts_[pixel] == 0) return mean;
    const std::int64_t sum = bins_sum_[pixel * static_cast<std::size_t>(layout_.spectral_bins) +
                                       static_cast<std::size_t>(bin)];
    return mean + static_cast<double>(sum) * bin_quantum_ / counts_[pixel];
}

Colour<Xyz> FilmSums::albedo(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    if (counts_[pixel] == 0) return {};
    const double scale = layer_quantum_ / counts_[pixel];
    const auto& sums = layers_[pixel];
    return {{static_cast<double>(sums[0]) * scale, static_cast<double>(sums[1]) * scale,
             static_cast<double>(sums[2]) * scale}};
}

Vec3 FilmSums::normal(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    if (counts_[pixel] == 0) return {};
    const double scale = layer_quantum_ / counts_[pixel];
    const auto& sums = layers_[pixel];
    return {static_cast<double>(sums[3]) * scale, static_cast<double>(sums[4]) * scale,
            static_cast<double>(sums[5]) * scale};
}

double FilmSums::depth(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    if (hits_[pixel] == 0) return 0.0;
    return static_cast<double>(layers_[pixel][6]) * layer_quantum_ / hits_[pixel];
}

double FilmSums::coverage(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    return counts_[pixel] == 0 ? 0.0 : static_cast<double>(hits_[pixel]) / counts_[pixel];
}

namespace {

/// Of a mean of `n` numbers, by the sums of them and of their squares.
double variance_of_mean(double n, double sum, double sum_of_squares) {
    if (n < 2.0) return 0.0;
    const double mean = sum / n;
    // Below zero only by rounding, or where the sum of squares has stopped at its largest value.
    return std::max(0.0, sum_of_squares / n - mean * mean) / (n - 1.0);
}

}  // namespace

double FilmSums::variance_of_mean(int x, int y) const {
    const std::size_t pixel = index_of(x, y);
    const double of_samples =
        dewbow::variance_of_mean(counts_[pixel], static_cast<double>(xyz_[pixel][1]) * xyz_quantum_,
                                 static_cast<double>(y_squared_[pixel]) * y_squared_quantum_);
    if (light_paths_ == 0) return of_samples;
    const SplatSums::Arrived arrived = splats_.at(pixel);
    return of_samples + dewbow::variance_of_mean(static_cast<double>(light_paths_), arrived.xyz[1],
                                                 arrived.y_squared);
}

std::int64_t FilmSums::invalid_samples() const {
    const InvalidSamples all = invalid();
    return all.count + all.splats;
}

std::vector<InvalidSample> FilmSums::first_invalid() const { return invalid().first; }

InvalidSamples FilmSums::invalid() const {
    const std::scoped_lock lock(invalid_mutex());
    return invalid_;
}

std::uint64_t FilmSums::fingerprint() const {
    Hash hash;
    const PixelRect& part = layout_.crop;
    for (const int side :
         {layout_.width, layout_.height, part.x0, part.y0, part.x1, part.y1, layout_.spectral_bins})
        hash.add(side);
    for (const double quantum : {xyz_quantum_, y_squared_quantum_, bin_quantum_, layer_quantum_})
        hash.add_power_of_two(quantum);
    for (std::size_t pixel = 0; pixel < counts_.size(); ++pixel) {
        hash.add((std::uint64_t{counts_[pixel]} << 32) | hits_[pixel]);
        for (const Wide sum : xyz_[pixel]) hash.add(sum);
        hash.add(y_squared_[pixel]);
        for (const std::int64_t sum : layers_[pixel]) hash.add(sum);
    }
    for (const std::int64_t sum : bins_sum_) hash.add(sum);
    const std::scoped_lock lock(invalid_mutex());
    if (light_paths_ > 0) {
        hash.add(light_paths_);
        splats_.for_each_word([&hash](std::uint64_t word) { hash.add(word); });
        hash.add(invalid_.splats);
    }
    hash.add(invalid_.count);
    for (const InvalidSample& sample : invalid_.first) {
        hash.add((static_cast<std::uint64_t>(sample.y) << 32) |
                 static_cast<std::uint32_t>(sample.x));
        hash.add(sample.index);
    }
    return hash.value();
}

}  // namespace dewbow
