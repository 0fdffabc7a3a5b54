// SPDX-License-Identifier: Apache-2.0
#pragma once

// An estimator for tests: noise from the camera and sparks from light paths, by the rules of a true
// one. What it adds is a function of seed, pixel and index, or of seed, pass and path.

#include <algorithm>
#include <cmath>
#include <functional>

#include "dewbow/render/estimator.h"

namespace dewbow {

class SparkEstimator : public Estimator {
public:
    /// @param width,height  of the whole picture.  @param light_paths  of each sample of a pixel
    SparkEstimator(int width, int height, double light_paths)
        : width_(width), height_(height), light_paths_(light_paths) {}

    void render(const Unit& unit, FilmSums& film) const override {
        if (on_unit) on_unit();
        for (int y = unit.tile.y0; y < unit.tile.y1; ++y)
            for (int x = unit.tile.x0; x < unit.tile.x1; ++x)
                for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i)
                    film.add(x, y, sample(x, y, i), i);
    }

    double light_paths() const override { return light_paths_; }

    /// Each path leaves two sparks, of about as much light as a sample of each pixel; some beside
    /// the picture, some invalid.
    void trace_light(const LightUnit& unit, SplatList& splats) const override {
        if (on_unit) on_unit();
        for (std::uint64_t path = unit.first_path; path < unit.end_path; ++path) {
            const SampleKey key = light_path_key(kSeed, unit.pass, path);
            const WavelengthPacket packet = packet_of(key);
            LaneValues values;
            for (int k = 0; k < packet.count; ++k)
                values[k] = key.one(std::uint32_t(k), Purpose::test) * width_ * height_;
            if (key.one(9, Purpose::test) < invalid_share) values[1] = std::nan("");
            const SplatLight light(packet, LaneSet::all(packet), values);
            for (std::uint32_t spark = 0; spark < 2; ++spark) {
                const auto [u, v] = key.two(spark, Purpose::light_point);
                splats.add(int(u * (width_ + 4)) - 2, int(v * v * height_), 0.5, light);
            }
        }
    }

    /// Called at the start of each unit, from any thread.
    std::function<void()> on_unit;
    double invalid_share = 0.0;

private:
    static constexpr std::uint64_t kSeed = 5;

    static WavelengthPacket packet_of(const SampleKey& key) {
        return sample_wavelengths(WavelengthSampling::visual, 4, key.one(0, Purpose::wavelength));
    }
    PixelSample sample(int x, int y, std::int64_t index) const {
        const SampleKey key(stream_key(kSeed, std::uint32_t(x), std::uint32_t(y)),
                            std::uint32_t(index));
        PixelSample result;
        result.wavelengths = packet_of(key);
        for (std::uint32_t k = 0; k < 4; ++k) result.radiance[k] = key.one(k, Purpose::test);
        if (key.one(9, Purpose::test) < invalid_share) result.radiance[1] = -1.0;
        return result;
    }

    int width_, height_;
    double light_paths_;
};

/// What a render of `width` × `height` pixels by that estimator has in the end, added up in one
/// thread from the first sample and path to the last.
inline FilmSums undivided_film(const SparkEstimator& estimator, const FilmLayout& layout,
                               std::int64_t samples_per_pixel, std::int64_t samples_per_pass) {
    FilmSums film(layout);
    estimator.render({layout.crop, 0, samples_per_pixel}, film);
    const double paths = estimator.light_paths() * layout.width * layout.height;
    for (std::int64_t first = 0, pass = 0; first < samples_per_pixel;
         first += samples_per_pass, ++pass) {
        const auto samples = std::min(samples_per_pass, samples_per_pixel - first);
        const auto end = std::uint64_t(std::llround(paths * double(samples)));
        SplatList splats(layout);
        estimator.trace_light({std::uint64_t(pass), 0, end}, splats);
        film.add_splats(splats, end);
    }
    return film;
}

}  // namespace dewbow
