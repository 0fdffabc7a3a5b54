// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "dewbow/scene/checks.h"
#include "dewbow/spectrum/monitors.h"

namespace dewbow {
namespace {

using namespace checks;

constexpr int kMaxPictureSide = 65536;
constexpr double kMaxFilterRadius = 16.0;

void check_film(const Film& film) {
    const std::string who = "film";
    check_range(who, "width", film.width, 1, kMaxPictureSide);
    check_range(who, "height", film.height, 1, kMaxPictureSide);
    check_positive(who, "filter radius", film.filter.radius);
    check_range(who, "filter radius", film.filter.radius, 0.0, kMaxFilterRadius);
    check_positive(who, "white luminance", film.white_luminance);
    check_range(who, "exposure", film.exposure_stops, -100.0, 100.0);
    check_range(who, "the number of spectral bins", film.spectral_bins, 0, kMostSpectralBins);
}

void check_distributed_1989(const Distributed1989Settings& settings) {
    const std::string who = "distributed_1989";
    check_range(who, "the number of samples", settings.sampling.samples, 1, kMostSpectralSamples);
    check_range(who, "the least weight", settings.least_weight, 0.0, 1.0);
    find_monitor(settings.model.monitor);
}

void check_render(const RenderSettings& render) {
    const std::string who = "render";
    check_range(who, "samples per pixel", render.samples_per_pixel, 1, kMostSamples);
    if (render.packet != 1 && render.packet != 4 && render.packet != 8 && render.packet != 16) {
        fail(who, fmt::format("packet is {}; it must be 1, 4, 8 or 16", render.packet));
    }
    check_range(who, "the greatest depth", render.max_depth, 0, kMostDepth);
    check_range(who, "the roulette's depth", render.roulette_depth, 0,
                std::numeric_limits<int>::max());
    check_distributed_1989(render.distributed_1989);
    check_range("caustics", "the number of light paths", render.caustics.light_paths, 0.0,
                kMostLightPaths);
    check_range("rain", "the number of orders", render.rain.orders, RainSettings::kAllOrders,
                kMostRainOrders);
}

}  // namespace

void validate_view(const Scene& scene) {
    check_film(scene.film);
    check_camera(scene.camera, scene.film);
    check_render(scene.render);
}

void validate(const Scene& scene) {
    validate_view(scene);
    check_medium("surroundings", scene.surroundings);
    check_materials(scene);
    check_shapes(scene);
    check_lights(scene);
    check_rains(scene);
    if (scene.paper_rainbow) {
        check_paper_rainbow(*scene.paper_rainbow);
        if (!first_sun(scene))
            fail("paper rainbow",
                 "there is no sun, a light of type \"distant\", to stand opposite");
    }
}

}  // namespace dewbow
