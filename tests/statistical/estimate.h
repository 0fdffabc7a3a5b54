// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a scene looks like through a cone of rays, as XYZ with its covariance.

#include "../analytic/scene_kit.h"
#include "../analytic/statistics.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow::kit {

/// Rays from `eye` to the points of a ball.
struct View {
    Vec3 eye, target;
    double radius = 0.0;
};

/// How light is carried, and what a test plants.
struct Sampling {
    int packet = 8;
    WavelengthSampling sampling = WavelengthSampling::visual;
    std::size_t samples = 0;
    std::uint64_t seed = 0;
    void (*plant)(WavelengthPacket&, PixelSample&) = nullptr;
};

/// Sums of XYZ (white of the constant spectrum 1: Y = 1) minus `expected`.
inline VectorSums estimate(const Scene& scene, const View& view, const Sampling& way,
                           const Triple& expected = {}) {
    const PreparedScene prepared(scene);
    const MediaStack start = media_at(view.eye, scene, prepared.media, prepared.accelerator);
    constexpr std::size_t kChunks = 64;
    std::vector<VectorSums> parts(kChunks);
    in_chunks(way.samples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const SampleKey key = independent_key(way.seed, i);
            const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
            const Vec3 aside =
                view.radius * std::cbrt(b[0]) * sample_uniform_sphere<World>(a[0], a[1]).v;
            const Ray ray{view.eye, normalised(view.target + aside - view.eye), {}};
            PixelSample sample =
                trace_sample(prepared, ray, start, packet_of(key, way.packet, way.sampling), key);
            if (way.plant) way.plant(sample.wavelengths, sample);
            const Colour<Xyz> xyz = xyz_from_lanes(
                sample.wavelengths,
                std::span(sample.radiance).first(std::size_t(sample.wavelengths.count)));
            Triple x;
            for (std::size_t c = 0; c < 3; ++c) x[c] = xyz[c] / cie_y_integral() - expected[c];
            parts[chunk].add(x);
        }
    });
    VectorSums all;
    for (const VectorSums& part : parts) all.add(part);
    return all;
}

inline Triple xyz_of(const Spectrum& spectrum) {
    const Colour<Xyz> xyz = xyz_from_spectrum(spectrum);
    return {xyz[0] / cie_y_integral(), xyz[1] / cie_y_integral(), xyz[2] / cie_y_integral()};
}

}  // namespace dewbow::kit
