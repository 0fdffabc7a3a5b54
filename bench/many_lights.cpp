// SPDX-License-Identifier: Apache-2.0

// How to choose one light of many? Error × processor time of direct light in a hall of 1 to 10000
// small lamps of differing power over a floor with boxes, when a lamp is chosen by chance alone, by
// its power, or by the light tree.
//
//     bench_many_lights [lamps…]          default: 1 3 10 100 1000 10000
//
// Each pixel is one point, so that the true picture is a sum over all lamps, with a shadow ray
// each, and has no noise of its own. One thread; time is the processor's, the search for the point
// that a pixel shows left out. A table in Markdown: MSE of Y over the square of the mean Y,
// nanoseconds a sample, and 1 / (MSE × CPU s) as a ratio to the choice by power.

#include <cmath>
#include <cstdio>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "dewbow/base/random.h"
#include "dewbow/math/distribution.h"
#include "dewbow/render/accelerator.h"
#include "dewbow/render/light_tree.h"
#include "dewbow/render/punctual_light.h"
#include "picture_error.h"

namespace dewbow::bench {
namespace {

using unit::m;

constexpr int kWidth = 64, kHeight = 48, kSamples = 16, kRepeats = 4;
constexpr double kReflectance = 0.5;
constexpr double kHall_m = 40.0, kCeiling_m = 4.0;

/// Numbers of the scene's own, apart from those of its samples.
std::array<double, 2> scene_numbers(std::uint32_t i, std::uint32_t which) {
    return SampleKey(stream_key(1, i, 0), 0).two(which, Purpose::test);
}

/// Lamps at random under the ceiling, together as bright whatever their number; the brightest has
/// e³ times the power of the weakest.
std::vector<PointLight> make_lamps(int count) {
    std::vector<PointLight> lamps;
    for (std::uint32_t i = 0; i < std::uint32_t(count); ++i) {
        const auto at = scene_numbers(i, 0), u = scene_numbers(i, 1);
        const double intensity = 500.0 / count * std::exp(3.0 * u[0]);
        lamps.push_back(
            {{{kHall_m * (at[0] - 0.5), kCeiling_m - 0.5 * u[1], kHall_m * (at[1] - 0.5)}},
             make_constant(intensity)});
    }
    return lamps;
}

Scene make_hall() {
    Scene scene = make_empty_scene();
    const int grey = scene.add({"grey", Diffuse{make_constant(kReflectance)}, nullptr, false});
    const auto add = [&](Geometry geometry, const Affine& place) {
        scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), grey});
    };
    add(Rectangle{kHall_m * m, kHall_m * m}, rotation({1, 0, 0}, -90.0 * unit::deg));
    for (std::uint32_t i = 0; i < 60; ++i) {
        const auto at = scene_numbers(i, 2), size = scene_numbers(i, 3);
        const double height = 0.5 + 2.0 * size[0];
        add(Box{0.8 * m, height * m, (0.5 + 2.0 * size[1]) * m},
            translation({kHall_m * (at[0] - 0.5), 0.5 * height, kHall_m * (at[1] - 0.5)}));
    }
    return scene;
}

/// How a lamp is chosen.
struct LightChoice {
    virtual ~LightChoice() = default;
    virtual std::optional<LightTree::Choice> choose(const Receiver& receiver, double u) const = 0;
};
struct ByWeight : LightChoice {
    explicit ByWeight(const std::vector<double>& weights) : weights_(weights) {}
    std::optional<LightTree::Choice> choose(const Receiver&, double u) const override {
        const std::size_t index = weights_.sample(u).index;
        return LightTree::Choice{int(index), weights_.probability(index)};
    }
    Distribution1D weights_;
};
struct ByTree : LightChoice {
    explicit ByTree(const std::vector<LightBounds>& bounds) : tree_(bounds) {}
    std::optional<LightTree::Choice> choose(const Receiver& receiver, double u) const override {
        return tree_.sample(receiver, u);
    }
    LightTree tree_;
};

struct Hall {
    Scene scene = make_hall();
    Accelerator accelerator{scene, std::vector<bool>(scene.shapes.size(), false)};
    std::vector<double> intensities;
    std::vector<PunctualLight> lamps;
    std::vector<LightBounds> bounds;
    std::vector<std::optional<Receiver>> pixels;  ///< what each shows
    std::vector<SurfaceFrom> surfaces;

    explicit Hall(int count) {
        for (const PointLight& lamp : make_lamps(count)) {
            lamps.emplace_back(lamp);
            bounds.push_back(lamps.back().bounds());
            intensities.push_back(bounds.back().intensity);
        }
        const Vec3 eye{0, 3.5, 0.5 * kHall_m};
        const Affine world_from_camera = looking_at(eye, {0, 0, 0}, {0, 1, 0});
        for (int i = 0; i < kWidth * kHeight; ++i) {
            const double x = (i % kWidth + 0.5) / kWidth - 0.5;
            const double y = (0.5 * kHeight - i / kWidth - 0.5) / kWidth;
            const Ray ray{eye, normalised(world_from_camera.apply_linear({x, y, -0.6})), {}};
            const Hit hit = accelerator.intersect(ray);
            pixels.emplace_back();
            surfaces.push_back({hit.shape, hit.primitive, false});
            if (hit) pixels.back() = Receiver{ray.origin + ray.direction * hit.t, hit.normal};
        }
    }

    /// Radiance by lamp `k` at pixel `i`.
    double light(std::size_t i, std::size_t k) const {
        const Receiver& at = *pixels[i];
        const auto arrival = lamps[k].arrival(at.position);
        const double cosine = arrival ? dot(arrival->direction, at.normal) : 0.0;
        if (!(cosine > 0.0)) return 0.0;
        const Ray ray{at.position, arrival->direction, surfaces[i]};
        if (accelerator.occluded(ray, arrival->distance)) return 0.0;
        return kReflectance / std::numbers::pi * intensities[k] * arrival->factor * cosine;
    }
};

Picture true_picture(const Hall& hall) {
    Picture picture(hall.pixels.size());
    for (std::size_t i = 0; i < hall.pixels.size(); ++i)
        for (std::size_t k = 0; hall.pixels[i] && k < hall.lamps.size(); ++k)
            picture[i][1] += hall.light(i, k);
    return picture;
}

Picture sampled_picture(const Hall& hall, const LightChoice& choice, std::uint64_t seed) {
    Picture picture(hall.pixels.size());
    for (std::size_t i = 0; i < hall.pixels.size(); ++i) {
        if (!hall.pixels[i]) continue;
        for (std::uint32_t s = 0; s < kSamples; ++s) {
            const SampleKey key(stream_key(seed, std::uint32_t(i), 0), s);
            const auto chosen = choice.choose(*hall.pixels[i], key.one(0, Purpose::light_choice));
            if (!chosen) continue;
            picture[i][1] +=
                hall.light(i, std::size_t(chosen->light)) / (chosen->probability * kSamples);
        }
    }
    return picture;
}

struct Cost {
    double error = 0.0, cpu_s = 0.0;
};

Cost measure(const Hall& hall, const Picture& truth, const LightChoice& choice) {
    double mean = 0.0;
    for (const Colour<Xyz>& pixel : truth) mean += pixel[1] / double(truth.size());
    Cost cost;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        const std::clock_t start = std::clock();
        const Picture picture = sampled_picture(hall, choice, std::uint64_t(repeat) + 1);
        cost.cpu_s += double(std::clock() - start) / CLOCKS_PER_SEC / kRepeats;
        cost.error += error_between(picture, truth).y / (mean * mean) / kRepeats;
    }
    return cost;
}

void compare(int count) {
    const Hall hall(count);
    const Picture truth = true_picture(hall);
    // The choice that stands for power is nine tenths by it, one tenth even.
    double sum = 0.0;
    for (const double intensity : hall.intensities) sum += intensity;
    std::vector<double> mixed;
    for (const double intensity : hall.intensities)
        mixed.push_back(0.9 * intensity / sum + 0.1 / count);
    const std::clock_t start = std::clock();
    const ByTree tree(hall.bounds);
    const double build_s = double(std::clock() - start) / CLOCKS_PER_SEC;
    const ByWeight power(mixed), even(std::vector<double>(std::size_t(count), 1.0));
    const Cost reference = measure(hall, truth, power);
    const auto row = [&](const char* name, const Cost& cost) {
        std::printf("| %d | %s | %.3g | %.0f | %.2f |\n", count, name, cost.error,
                    1e9 * cost.cpu_s / (kWidth * kHeight * kSamples),
                    reference.error * reference.cpu_s / (cost.error * cost.cpu_s));
    };
    row("even", measure(hall, truth, even));
    row("power", reference);
    row("tree", measure(hall, truth, tree));
    std::fprintf(stderr, "%d lamps: tree built in %.3g s\n", count, build_s);
}

}  // namespace
}  // namespace dewbow::bench

int main(int argc, char** argv) {
    std::vector<int> counts;
    for (int i = 1; i < argc; ++i) counts.push_back(std::stoi(argv[i]));
    if (counts.empty()) counts = {1, 3, 10, 100, 1000, 10000};
    std::printf(
        "| lamps | choice | MSE | ns a sample | 1 / (MSE × CPU s) |\n|---|---|---|---|---|\n");
    for (const int count : counts) dewbow::bench::compare(count);
}
