// SPDX-License-Identifier: Apache-2.0

// Pictures to bytes and back, in bytes of the picture in memory a second, against a copy of them.

#include "dewbow/image/exr.h"
#include "dewbow/image/png.h"
#include "numbers.h"

namespace dewbow::bench {
namespace {

constexpr int kWidth = 320, kHeight = 240;

/// A smooth picture with a little noise, as renders are.
Image picture() {
    const std::vector<double> noise = numbers(std::size_t(kWidth) * kHeight, -0.01, 0.01);
    Image image{kWidth, kHeight, {}};
    for (const char* name : {"R", "G", "B"}) {
        Channel channel{name, {}};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                channel.values.push_back(
                    float(0.5 + 0.001 * x - 0.001 * y + noise[std::size_t(y * kWidth + x)]));
        image.channels.push_back(std::move(channel));
    }
    return image;
}
constexpr std::int64_t kFloatBytes = std::int64_t{3} * 4 * kWidth * kHeight;

void copy(benchmark::State& state) {
    const Image image = picture();
    for (auto _ : state) benchmark::DoNotOptimize(Image(image));
    state.SetBytesProcessed(state.iterations() * kFloatBytes);
}
BENCHMARK(copy);

void exr_encode(benchmark::State& state, bool half) {
    const Image image = picture();
    ExrOptions options;
    options.half = half;
    for (auto _ : state) benchmark::DoNotOptimize(encode_exr(image, {}, options));
    state.SetBytesProcessed(state.iterations() * kFloatBytes);
}
BENCHMARK_CAPTURE(exr_encode, half, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(exr_encode, float, false)->Unit(benchmark::kMillisecond);

void exr_decode(benchmark::State& state) {
    const std::string bytes = encode_exr(picture(), {}, {});
    for (auto _ : state) benchmark::DoNotOptimize(decode_exr(bytes, "picture.exr"));
    state.SetBytesProcessed(state.iterations() * kFloatBytes);
}
BENCHMARK(exr_decode)->Unit(benchmark::kMillisecond);

Image8 picture8() {
    Image8 image{kWidth, kHeight, {}};
    for (const double v : numbers(std::size_t(3) * kWidth * kHeight, 0.0, 6.0))
        image.rgb.push_back(std::uint8_t(120.0 + v));
    return image;
}

void png_encode(benchmark::State& state) {
    const Image8 image = picture8();
    for (auto _ : state) benchmark::DoNotOptimize(encode_png(image, {}));
    state.SetBytesProcessed(state.iterations() * std::int64_t(image.rgb.size()));
}
BENCHMARK(png_encode)->Unit(benchmark::kMillisecond);

void png_decode(benchmark::State& state) {
    const Image8 image = picture8();
    const std::string bytes = encode_png(image, {});
    for (auto _ : state) benchmark::DoNotOptimize(decode_png(bytes, "picture.png"));
    state.SetBytesProcessed(state.iterations() * std::int64_t(image.rgb.size()));
}
BENCHMARK(png_decode)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace dewbow::bench
