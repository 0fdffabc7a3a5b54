// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/light_share.h"

#include <algorithm>
#include <numeric>

#include "dewbow/base/parallel.h"
#include "dewbow/render/session.h"

namespace dewbow {

namespace {

// Beyond all samples and passes of a render.
constexpr std::int64_t kFirstSample = std::int64_t{1} << 30;
constexpr std::uint64_t kPass = std::uint64_t{1} << 60;
static_assert(kFirstSample > kMostSamples);

constexpr std::uint64_t kPathsPerUnit = 512;
/// Of the mean light: parts that are darker matter less and less.
constexpr double kFloor = 0.01;

/// The picture in squares.
class Parts {
public:
    explicit Parts(const Film& film)
        : film_(film),
          side_((std::max(film.width, film.height) + kPilotParts - 1) / kPilotParts),
          across_((film.width + side_ - 1) / side_),
          down_((film.height + side_ - 1) / side_) {}
    std::size_t count() const { return std::size_t(across_) * std::size_t(down_); }
    std::size_t at(int x, int y) const { return std::size_t(y / side_ * across_ + x / side_); }
    PixelRect pixels(std::size_t part) const {
        const int x = int(part) % across_ * side_, y = int(part) / across_ * side_;
        return {x, y, std::min(x + side_, film_.width), std::min(y + side_, film_.height)};
    }

private:
    const Film& film_;
    int side_, across_, down_;
};

/// Mean Y of each part, as camera paths bring it.
std::vector<double> by_camera(const Estimator& estimator, const Scene& scene, const Parts& parts) {
    std::vector<double> light(parts.count());
    parallel_for(parts.count(), [&](std::size_t part) {
        const PixelRect all = parts.pixels(part);
        for (std::uint64_t i = 0; i < kPilotSamples; ++i) {
            const std::uint64_t chance = hash_combine(part, i) % std::uint64_t(all.area());
            const int x = all.x0 + int(chance) % all.width(),
                      y = all.y0 + int(chance) / all.width();
            const PixelRect pixel{x, y, x + 1, y + 1};
            SessionOptions options;
            options.crop = pixel;
            FilmSums film = make_film(scene, options);
            estimator.render(
                {pixel, kFirstSample + std::int64_t(i), kFirstSample + std::int64_t(i) + 1}, film);
            light[part] += film.xyz(x, y)[1] / kPilotSamples;
        }
    });
    return light;
}

/// The same, as light paths bring it.
std::vector<double> by_light(const Estimator& estimator, const Scene& scene, const Parts& parts) {
    FilmLayout whole;
    whole.width = scene.film.width, whole.height = scene.film.height;
    whole.crop = {0, 0, whole.width, whole.height};
    std::vector<std::vector<double>> sums(kPilotLightPaths / kPathsPerUnit);
    parallel_for(sums.size(), [&](std::size_t unit) {
        sums[unit].resize(parts.count());
        SplatList splats(whole);
        estimator.trace_light({kPass, unit * kPathsPerUnit, (unit + 1) * kPathsPerUnit}, splats);
        for (const Splat& splat : splats.splats()) {
            const auto width = std::uint32_t(whole.width);
            const int x = int(splat.pixel % width), y = int(splat.pixel / width);
            sums[unit][parts.at(x, y)] += splat.xyz[1];
        }
    });
    std::vector<double> light(parts.count());
    for (const std::vector<double>& sum : sums)  // in a fixed order
        for (std::size_t part = 0; part < parts.count(); ++part)
            light[part] += sum[part] / (kPilotLightPaths * double(parts.pixels(part).area()));
    return light;
}

}  // namespace

double light_share(const CausticsEstimator& estimator, const Scene& scene) {
    const Parts parts(scene.film);
    const CausticsEstimator pilot = estimator.with_share_of_light_paths(1.0 / kPilotFewer);
    const std::vector<double> camera = by_camera(pilot, scene, parts);
    const std::vector<double> light = by_light(pilot, scene, parts);
    const auto count = double(parts.count());
    const double mean = (std::accumulate(camera.begin(), camera.end(), 0.0) +
                         std::accumulate(light.begin(), light.end(), 0.0)) /
                        count;
    if (!(mean > 0.0)) return 0.0;
    double share = 0.0;
    for (std::size_t part = 0; part < parts.count(); ++part)
        share += light[part] / (light[part] + camera[part] + kFloor * mean) / count;
    return share;
}

}  // namespace dewbow
