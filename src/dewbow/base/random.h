// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random numbers from keys. A sample is a function of (stream, index, vertex, purpose) and of
// nothing else: not of the thread, not of what was drawn before.
//
// Each (stream, vertex, purpose) is one padded two-dimensional Owen-scrambled Sobol' sequence over
// `index`: stratified in every power-of-two block of indices of one stream, independent between
// keys. [Owen 1995; Laine & Karras 2011; Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4)
// 2020]

#include <array>
#include <cstdint>

namespace dewbow {

/// What a number is drawn for: one row a use, so that no two uses share a sequence by accident.
enum class Purpose : std::uint32_t {
    pixel_filter,
    lens,
    wavelength,
    light_choice,
    light_point,
    bsdf_lobe,
    bsdf_direction,
    lane_choice,
    roulette,
    test,
    impact_parameter,  ///< of a ray on a drop
    spectral_offset,   ///< of a sample of the spectrum within its interval
    haze,              ///< a point of haze and its light, or what sees it
    rain_on_flight,    ///< what uneven rain leaves of light along a path
    rain_to_light,     ///< and on its way from a light or to a camera
    drop_distance,     ///< where a path meets a drop, and whether it does
    drop_direction,    ///< how the drop turns it
    rain_point,        ///< a point of rain, and of the light that shines on it
    paper_fog,         ///< what jitters the paper's rainbow on a ray
};

/// A bijection of 64 bits in which every output bit depends on every input bit.
constexpr std::uint64_t mix_bits(std::uint64_t v) {
    // Constants: David Stafford's "Mix13" (as in splitmix64).
    v ^= v >> 30;
    v *= 0xbf58476d1ce4e5b9ULL;
    v ^= v >> 27;
    v *= 0x94d049bb133111ebULL;
    v ^= v >> 31;
    return v;
}
constexpr std::uint64_t hash_combine(std::uint64_t a, std::uint64_t b) {
    return mix_bits(a ^ (mix_bits(b) + 0x9e3779b97f4a7c15ULL + (a << 6) + (a >> 2)));
}

/// The stream of one pixel of one render.
constexpr std::uint64_t stream_key(std::uint64_t seed, std::uint32_t x, std::uint32_t y) {
    return hash_combine(mix_bits(seed + 0x9e3779b97f4a7c15ULL), (std::uint64_t{y} << 32) | x);
}

/// The stream of the light paths of one pass of a render; no pixel has it.
constexpr std::uint64_t light_stream_key(std::uint64_t seed, std::uint64_t pass) {
    constexpr std::uint64_t kLight = 0x6c69676874ULL;  // "light"
    return hash_combine(hash_combine(mix_bits(seed + 0x9e3779b97f4a7c15ULL), kLight), pass);
}

/// All random numbers of sample `index` of `stream`.
class SampleKey {
public:
    constexpr SampleKey(std::uint64_t stream, std::uint32_t index)
        : stream_(stream), index_(index) {}

    /// One number in [0, 1), stratified over index.
    double one(std::uint32_t vertex, Purpose purpose) const { return two(vertex, purpose)[0]; }
    /// Two numbers in [0, 1)², a (0,2)-sequence over index.
    std::array<double, 2> two(std::uint32_t vertex, Purpose purpose) const;
    /// A third and a fourth number in [0, 1) to go with two(), for what depends on all of them at
    /// once: over index, three are a (1,3)-sequence and four a (3,4)-sequence.
    double third(std::uint32_t vertex, Purpose purpose) const;
    double fourth(std::uint32_t vertex, Purpose purpose) const;

    std::uint32_t index() const { return index_; }

private:
    std::uint64_t step(std::uint64_t number) const;
    std::uint32_t shuffled(std::uint64_t first_step) const;

    std::uint64_t stream_;
    std::uint32_t index_;
};

}  // namespace dewbow
