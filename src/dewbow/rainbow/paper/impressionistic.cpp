// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/paper/impressionistic.h"

#include <cmath>

#include "dewbow/base/random.h"

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

double ring_index(const ImpressionisticBow& bow, Angle r) {
    if (bow.index == ImpressionisticBow::Index::by_angle)
        return ring_index(r, bow.outer, bow.inner);
    const double width = kPaperSamples / (cos(bow.inner) - cos(bow.outer));
    return published_ring_index(cos(r), cos(bow.outer), width);
}

std::optional<Colour<LinearSrgb>> ring_fog(double index, const FogJitter& jitter,
                                           std::array<double, 2> u) {
    index += jitter.delta * (u[0] - 0.5);
    // Before the cast: −0.5 would become ring 0.
    if (!(index >= 0.0 && index < kPaperSamples)) return std::nullopt;
    const double within = jitter.colour ? u[1] : 0.5;
    return linear_spectrum_colour((std::floor(index) + within) / kPaperSamples);
}

std::vector<Colour<LinearSrgb>> impressionistic_strip(const ImpressionisticBow& bow,
                                                      std::span<const Angle> angles, int samples,
                                                      std::uint64_t seed) {
    std::vector<Colour<LinearSrgb>> strip(angles.size());
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double index = ring_index(bow, angles[k]);
        const std::uint64_t stream = stream_key(seed, std::uint32_t(k), 0);
        for (int s = 0; s < samples; ++s) {
            const SampleKey key(stream, std::uint32_t(s));
            const auto fog = ring_fog(index, bow.jitter,
                                      {key.one(index_jitter, Purpose::wavelength),
                                       key.one(colour_jitter, Purpose::wavelength)});
            if (fog) strip[k] = strip[k] + *fog * (1.0 / samples);
        }
    }
    return strip;
}

}  // namespace dewbow
