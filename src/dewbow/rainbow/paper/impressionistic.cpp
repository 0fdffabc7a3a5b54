// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/impressionistic.h"

#include <cmath>

namespace dewbow {
namespace {

enum Vertex : std::uint32_t { index_jitter, colour_jitter };

}  // namespace

double published_ring_index(double dot, double rainbow_angle, double rainbow_width) {
    return (dot - rainbow_angle) * rainbow_width;
}

double ring_index(Angle r, Angle outer, Angle inner) {
    return (outer - r) / (outer - inner) * kPaperSamples;
}

std::optional<Colour<LinearSrgb>> ring_fog(double index, const FogJitter& jitter,
                                           const SampleKey& key) {
    if (jitter.delta > 0.0)
        index += jitter.delta * (key.one(index_jitter, Purpose::wavelength) - 0.5);
    // Before the cast: −0.5 would become ring 0.
    if (!(index >= 0.0 && index < kPaperSamples)) return std::nullopt;
    const double within = jitter.colour ? key.one(colour_jitter, Purpose::wavelength) : 0.5;
    return linear_spectrum_colour((std::floor(index) + within) / kPaperSamples);
}

std::vector<Colour<LinearSrgb>> impressionistic_strip(const ImpressionisticBow& bow,
                                                      std::span<const Angle> angles, int samples,
                                                      std::uint64_t seed) {
    const double width = kPaperSamples / (cos(bow.inner) - cos(bow.outer));
    std::vector<Colour<LinearSrgb>> strip(angles.size());
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double index = bow.index == ImpressionisticBow::Index::by_angle
                                 ? ring_index(angles[k], bow.outer, bow.inner)
                                 : published_ring_index(cos(angles[k]), cos(bow.outer), width);
        const std::uint64_t stream = stream_key(seed, std::uint32_t(k), 0);
        for (int s = 0; s < samples; ++s)
            if (const auto fog = ring_fog(index, bow.jitter, {stream, std::uint32_t(s)}))
                strip[k] = strip[k] + *fog * (1.0 / samples);
    }
    return strip;
}

}  // namespace dewbow
