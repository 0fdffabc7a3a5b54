// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

constexpr int kWidth = 5, kHeight = 3;
constexpr PixelRect kWhole{0, 0, kWidth, kHeight};

struct Event {
    int x, y;
    std::int64_t index;
    PixelSample sample;
};

PixelSample constant_sample(double radiance, double u = 0.25, int lanes = 8) {
    PixelSample sample;
    sample.wavelengths = sample_wavelengths(WavelengthSampling::visual, lanes, u);
    std::fill_n(sample.radiance.begin(), lanes, radiance);
    return sample;
}

/// Samples over twelve powers of ten, some of them invalid.
std::vector<Event> random_events(std::size_t count) {
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Event> events;
    for (std::size_t i = 0; i < count; ++i) {
        Event event{int(engine() % kWidth), int(engine() % kHeight), std::int64_t(i), {}};
        event.sample.wavelengths = sample_wavelengths(WavelengthSampling::visual, 8, unit(engine));
        for (int k = 0; k < 8; ++k)
            event.sample.radiance[k] = std::pow(10.0, -6.0 + 12.0 * unit(engine));
        if (i % 97 == 0) event.sample.radiance[i % 8] = std::nan("");
        event.sample.hit = i % 3 != 0;
        event.sample.depth = event.sample.hit ? 100.0 * unit(engine) : 0.0;
        event.sample.normal = {unit(engine) - 0.5, 0.3, -0.7};
        event.sample.albedo = {{unit(engine), unit(engine), unit(engine)}};
        events.push_back(event);
    }
    return events;
}

void add_all(FilmSums& film, const std::vector<Event>& events) {
    for (const Event& e : events) film.add(e.x, e.y, e.sample, e.index);
}

PixelSample coloured_sample(Colour<Xyz> xyz) {
    PixelSample sample;
    sample.colour = xyz;
    return sample;
}

TEST(Film, SamplesMayBeColours) {
    FilmSums film(kWidth, kHeight, kWhole, 0, 1.0);
    film.add(1, 1, coloured_sample({{0.5, 1.0, 2.0}}), 0);
    // A single sample of a spectrum may lie outside all real colours: together they do not.
    film.add(1, 1, coloured_sample({{-0.25, 0.5, -1.0}}), 1);
    EXPECT_EQ(film.xyz(1, 1), (Colour<Xyz>{{0.125, 0.75, 0.5}}));  // binary fractions: exact
    EXPECT_EQ(film.variance_of_mean(1, 1), 0.0625);  // ((1 − ¾)² + (½ − ¾)²) / 2
    EXPECT_EQ(film.invalid_samples(), 0);
    film.add(1, 1, coloured_sample({{std::nan(""), 0.0, 0.0}}), 2);
    film.add(1, 1, coloured_sample({{0.0, std::numeric_limits<double>::infinity(), 0.0}}), 3);
    EXPECT_EQ(film.invalid_samples(), 2);
    EXPECT_EQ(film.samples(1, 1), 2u);
}

TEST(Film, FingerprintDoesNotDependOnTheOrder) {
    std::vector<Event> events = random_events(20000);
    FilmSums first(kWidth, kHeight, kWhole, 7, 1.0);
    add_all(first, events);
    std::mt19937_64 engine(2);
    for (int repeat = 0; repeat < 5; ++repeat) {
        std::shuffle(events.begin(), events.end(), engine);
        FilmSums other(kWidth, kHeight, kWhole, 7, 1.0);
        add_all(other, events);
        EXPECT_EQ(first.fingerprint(), other.fingerprint());
        EXPECT_EQ(first.first_invalid(), other.first_invalid());
    }
}

TEST(Film, FingerprintDoesNotDependOnThreads) {
    const std::vector<Event> events = random_events(20000);
    FilmSums first(kWidth, kHeight, kWhole, 7, 1.0);
    add_all(first, events);
    FilmSums other(kWidth, kHeight, kWhole, 7, 1.0);
    {
        std::vector<std::jthread> threads;  // one for each column of pixels
        for (int x = 0; x < kWidth; ++x)
            threads.emplace_back([&, x] {
                for (const Event& e : events)
                    if (e.x == x) other.add(e.x, e.y, e.sample, e.index);
            });
    }
    EXPECT_EQ(first.fingerprint(), other.fingerprint());
}

TEST(Film, FingerprintSeesTheSmallestChange) {
    const std::vector<Event> events = random_events(200);
    FilmSums first(kWidth, kHeight, kWhole, 0, 1.0);
    FilmSums second(kWidth, kHeight, kWhole, 0, 1.0);
    add_all(first, events);
    add_all(second, events);
    EXPECT_EQ(first.fingerprint(), second.fingerprint());
    PixelSample faint = constant_sample(1e-11);
    first.add(0, 0, constant_sample(0.0), 200);
    second.add(0, 0, faint, 200);
    EXPECT_NE(first.fingerprint(), second.fingerprint());
    EXPECT_NE(first.fingerprint(), FilmSums(kWidth, kHeight, kWhole, 0, 2.0).fingerprint());
}

TEST(Film, AveragesAreThoseOfLongDoubles) {
    const std::vector<Event> events = random_events(5000);
    FilmSums film(kWidth, kHeight, kWhole, 0, 1.0);
    add_all(film, events);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            long double sum[3] = {}, albedo = 0, depth = 0, normal = 0;
            int count = 0, hits = 0;
            for (const Event& e : events) {
                if (e.x != x || e.y != y || e.index % 97 == 0) continue;
                const Colour<Xyz> xyz =
                    xyz_from_lanes(e.sample.wavelengths, {e.sample.radiance.data(), 8});
                for (std::size_t c = 0; c < 3; ++c) sum[c] += xyz[c] / cie_y_integral();
                albedo += e.sample.albedo[1];
                ++count;
                if (!e.sample.hit) continue;
                depth += e.sample.depth;
                normal += e.sample.normal.x;
                ++hits;
            }
            ASSERT_EQ(film.samples(x, y), std::uint32_t(count));
            // Half a quantum of rounding a sample, and the double that is returned.
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(film.xyz(x, y)[c], double(sum[c] / count),
                            0x1p-41 + 4e-16 * double(sum[c] / count));
            EXPECT_NEAR(film.albedo(x, y)[1], double(albedo / count), 0x1p-25);
            EXPECT_NEAR(film.depth(x, y), double(depth / hits), 0x1p-25);
            EXPECT_NEAR(film.normal(x, y).x, double(normal / count), 0x1p-25);
            EXPECT_DOUBLE_EQ(film.coverage(x, y), double(hits) / count);
        }
    }
}

TEST(Film, EmptyPixelsAreZero) {
    const FilmSums film(kWidth, kHeight, kWhole, 2, 1.0);
    EXPECT_EQ(film.samples(1, 1), 0u);
    EXPECT_EQ(film.xyz(1, 1), Colour<Xyz>{});
    EXPECT_EQ(film.bin(1, 1, 1), 0.0);
    EXPECT_EQ(film.depth(1, 1), 0.0);
    EXPECT_EQ(film.variance_of_mean(1, 1), 0.0);
}

TEST(Film, InvalidSamplesAreCountedAndLeftOut) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    FilmSums film(kWidth, kHeight, kWhole, 3, 1.0);
    film.add(1, 1, constant_sample(2.0), 0);
    const std::uint32_t before = film.samples(1, 1);
    const Colour<Xyz> xyz = film.xyz(1, 1);
    std::int64_t index = 1;
    for (const double bad : {kNan, -kNan, kInfinity, -kInfinity, -1e-300, -1.0}) {
        for (const int lane : {0, 3, 7}) {
            PixelSample sample = constant_sample(1.0);
            sample.radiance[std::size_t(lane)] = bad;
            film.add(1, 1, sample, index++);
        }
        PixelSample sample = constant_sample(1.0);
        sample.depth = bad;
        film.add(1, 1, sample, index++);
        sample = constant_sample(1.0);
        sample.albedo[2] = bad;
        film.add(1, 1, sample, index++);
    }
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        PixelSample sample = constant_sample(1.0);
        sample.normal.y = bad;
        film.add(1, 1, sample, index++);
    }
    EXPECT_EQ(film.invalid_samples(), index - 1);
    EXPECT_EQ(film.first_invalid().size(), std::size_t(index - 1));
    EXPECT_EQ(film.first_invalid().front(), (InvalidSample{1, 1, 1}));
    EXPECT_EQ(film.samples(1, 1), before);
    EXPECT_EQ(film.xyz(1, 1), xyz);
}

TEST(Film, LanesBeyondTheCountAreNotLookedAt) {
    FilmSums film(kWidth, kHeight, kWhole, 3, 1.0);
    PixelSample sample = constant_sample(1.0, 0.5, 4);
    sample.radiance[4] = std::nan("");
    film.add(0, 0, sample, 0);
    EXPECT_EQ(film.invalid_samples(), 0);
}

TEST(Film, TheFirstHundredInvalidSamplesAreKept) {
    FilmSums film(kWidth, kHeight, kWhole, 0, 1.0);
    const PixelSample bad = constant_sample(-1.0);
    for (int i = 299; i >= 0; --i) film.add(i % kWidth, i / kWidth % kHeight, bad, i);
    EXPECT_EQ(film.invalid_samples(), 300);
    const std::vector<InvalidSample> kept = film.first_invalid();
    ASSERT_EQ(kept.size(), 100u);
    for (std::size_t i = 0; i < 100; ++i) {
        EXPECT_EQ(kept[i].y, 0);
        EXPECT_EQ(kept[i].x, int(i) / 20);
        EXPECT_EQ(kept[i].index, std::int64_t(i) / 20 + 15 * (std::int64_t(i) % 20));
    }
}

TEST(Film, TooLargeSamplesAreClampedAndCounted) {
    FilmSums film(kWidth, kHeight, kWhole, 1, 1.0);
    for (int i = 0; i < 1000; ++i) film.add(0, 0, constant_sample(1e200), i);
    EXPECT_EQ(film.invalid_samples(), 1000);
    EXPECT_EQ(film.samples(0, 0), 1000u);
    EXPECT_DOUBLE_EQ(film.xyz(0, 0)[1], 0x1p62);
    EXPECT_GT(film.bin(0, 0, 0), 0.0);
    EXPECT_GE(film.variance_of_mean(0, 0), 0.0);
    film.add(1, 0, constant_sample(1e18), 0);  // below 2⁶²: large, and right
    EXPECT_EQ(film.invalid_samples(), 1000);
    EXPECT_NEAR(film.xyz(1, 0)[1] / 1e18, constant_sample(1.0).wavelengths.count / 8.0, 0.05);
}

TEST(Film, TheReferenceMovesTheRange) {
    for (const double reference : {1e-40, 1e-9, 0.75, 1e9, 1e40}) {
        const double typical = std::clamp(reference, 1e-30, 1e30);
        FilmSums film(kWidth, kHeight, kWhole, 1, reference);
        for (int i = 0; i < 64; ++i) film.add(0, 0, constant_sample(typical, (i + 0.5) / 64), i);
        EXPECT_EQ(film.invalid_samples(), 0);
        EXPECT_NEAR(film.xyz(0, 0)[1] / typical, 1.0, 1e-3) << reference;
        EXPECT_NEAR(film.bin(0, 0, 0) / typical, 1.0, 1e-2) << reference;
    }
}

TEST(Film, BinsReconstructASpectrum) {
    constexpr int kBins = 10;
    constexpr int kSamples = 20000;
    const auto spectrum = [](double lambda_nm) { return 1.0 + (lambda_nm - 360.0) / 100.0; };
    FilmSums film(kWidth, kHeight, kWhole, kBins, 1.0);
    for (int i = 0; i < kSamples; ++i) {
        PixelSample sample;
        sample.wavelengths =
            sample_wavelengths(WavelengthSampling::visual, 8, (i + 0.5) / kSamples);
        for (int k = 0; k < 8; ++k) sample.radiance[k] = spectrum(sample.wavelengths.lambda_nm[k]);
        film.add(2, 1, sample, i);
    }
    // The ends of a bin fall between two of the evenly placed quantiles, of which the last bins,
    // that the eye hardly sees, hold about 500.
    constexpr double kTolerance = 5e-3;
    double sum = 0.0;
    for (int bin = 0; bin < kBins; ++bin) {
        const double centre = 360.0 + 47.0 * (bin + 0.5);
        EXPECT_NEAR(film.bin(2, 1, bin) / spectrum(centre), 1.0, kTolerance) << bin;
        sum += film.bin(2, 1, bin) * 47.0;
    }
    EXPECT_NEAR(sum / (470.0 * spectrum(595.0)), 1.0, kTolerance);
}

TEST(Film, VarianceOfTheMeanIsThatOfTheSamples) {
    const std::vector<double> values{0.5, 1.0, 4.0, 0.0, 2.5};
    FilmSums film(kWidth, kHeight, kWhole, 0, 1.0);
    const double unit_y = [] {
        FilmSums one(1, 1, {0, 0, 1, 1}, 0, 1.0);
        one.add(0, 0, constant_sample(1.0), 0);
        return one.xyz(0, 0)[1];
    }();
    for (std::size_t i = 0; i < values.size(); ++i)
        film.add(0, 0, constant_sample(values[i]), std::int64_t(i));
    double mean = 0.0, squares = 0.0;
    for (const double v : values) mean += v / 5.0;
    for (const double v : values) squares += (v - mean) * (v - mean) / 4.0;
    EXPECT_NEAR(film.variance_of_mean(0, 0), unit_y * unit_y * squares / 5.0, 1e-11);
    film.add(1, 0, constant_sample(3.0), 0);
    EXPECT_EQ(film.variance_of_mean(1, 0), 0.0);
    film.add(1, 0, constant_sample(3.0), 1);
    EXPECT_NEAR(film.variance_of_mean(1, 0), 0.0, 1e-14);
}

TEST(Film, ACropKeepsThePixelsOfTheWhole) {
    const PixelRect crop{1, 1, 4, 3};
    FilmSums whole(kWidth, kHeight, kWhole, 2, 1.0), part(kWidth, kHeight, crop, 2, 1.0);
    for (const Event& e : random_events(2000)) {
        whole.add(e.x, e.y, e.sample, e.index);
        if (e.x >= crop.x0 && e.x < crop.x1 && e.y >= crop.y0 && e.y < crop.y1)
            part.add(e.x, e.y, e.sample, e.index);
    }
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x) {
            EXPECT_EQ(whole.xyz(x, y), part.xyz(x, y));
            EXPECT_EQ(whole.bin(x, y, 1), part.bin(x, y, 1));
        }
}

TEST(Film, TheObserverSeesEverySample) {
    FilmSums film(kWidth, kHeight, kWhole, 0, 1.0);
    std::vector<std::int64_t> seen;
    film.observe([&](int, int, const PixelSample&, std::int64_t index) { seen.push_back(index); });
    film.add(0, 0, constant_sample(1.0), 3);
    film.add(0, 0, constant_sample(-1.0), 4);
    EXPECT_EQ(seen, (std::vector<std::int64_t>{3, 4}));
}

TEST(FilmDeathTest, APixelOutsideIsABrokenContract) {
    FilmSums film(kWidth, kHeight, {0, 0, 2, 2}, 0, 1.0);
    EXPECT_DEATH(film.add(2, 0, constant_sample(1.0), 0), "crop");
}

TEST(LongFilm, CostOfOneSample) {
    FilmSums film(64, 64, {0, 0, 64, 64}, 0, 1.0);
    const PixelSample sample = constant_sample(1.0);
    constexpr int kSamples = 20'000'000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kSamples; ++i) film.add(i & 63, (i >> 6) & 63, sample, i);
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    // Ten times what was measured: this notices a lock or an allocation, not a slow machine.
    EXPECT_LT(time.count() / kSamples, 600.0);
    std::printf("%.1f ns a sample\n", time.count() / kSamples);
}

}  // namespace
}  // namespace dewbow
