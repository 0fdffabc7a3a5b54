// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caustics.h"

#include "dewbow/render/caustics/lamp_media.h"
#include "dewbow/render/caustics/light_walk.h"
#include "dewbow/render/caustics/training.h"
#include "dewbow/render/path/path.h"

namespace dewbow {

using caustics::EmittedRay;
using caustics::LightPaths;

namespace {

/// That training is planned for. A render that only time or noise ends has as many as can be: how
/// many it will have nobody knows, and it learns as one with the usual number.
int planned_samples(const RenderSettings& settings) {
    return settings.samples_per_pixel < kMostSamples ? settings.samples_per_pixel
                                                     : RenderSettings{}.samples_per_pixel;
}

}  // namespace

struct CausticsEstimator::Prepared {
    explicit Prepared(const Scene& of) : scene(of), emission(scene), lamp_media(scene) {}

    double pixels() const { return double(scene.scene.film.width) * scene.scene.film.height; }
    LightPaths light_paths(double per_sample) const { return {emission, per_sample * pixels()}; }

    void trace(const EmittedRay& ray, const SampleKey& key, const LightPaths& paths,
               SplatList& splats) const {
        const RenderSettings& settings = scene.scene.render;
        const WavelengthPacket packet =
            sample_wavelengths(settings.wavelengths, settings.packet,
                               key.one(0, Purpose::wavelength) / settings.packet);
        const bool afar = ray.source == LightSample::Source::infinite;
        caustics::LightWalk(scene, paths, packet, key, splats)
            .run(ray, afar ? MediaStack{} : lamp_media.along(ray.ray));
    }

    void learn() {
        const RenderSettings& settings = scene.scene.render;
        const LightPaths paths = light_paths(settings.caustics.light_paths);
        FilmLayout whole;
        whole.width = scene.scene.film.width, whole.height = scene.scene.film.height;
        whole.crop = {0, 0, whole.width, whole.height};
        training =
            caustics::train(emission, settings.seed, paths.per_sample * planned_samples(settings),
                            [&](const EmittedRay& ray, const SampleKey& key) {
                                SplatList splats(whole);
                                trace(ray, key, paths, splats);
                                double squares = 0.0;
                                for (const Splat& splat : splats.splats())
                                    squares += double(splat.xyz[1]) * splat.xyz[1];
                                return squares;
                            });
    }

    PreparedScene scene;
    caustics::AimedEmission emission;
    caustics::LampMedia lamp_media;
    caustics::TrainingReport training;
};

CausticsEstimator::CausticsEstimator(const Scene& scene)
    : CausticsEstimator(std::make_shared<Prepared>(scene), scene.render.caustics.light_paths) {}

CausticsEstimator::CausticsEstimator(std::shared_ptr<Prepared> prepared, double light_paths)
    : prepared_(std::move(prepared)),
      light_paths_(prepared_->emission.empty() ? 0.0 : light_paths) {}

void CausticsEstimator::aim() {
    if (prepared_->scene.scene.render.caustics.aimed && light_paths_ > 0.0) prepared_->learn();
}

CausticsEstimator CausticsEstimator::with_share_of_light_paths(double share) const {
    return {prepared_, share * light_paths_};
}

void CausticsEstimator::render(const Unit& unit, FilmSums& film) const {
    const PreparedScene& prepared = prepared_->scene;
    const LightPaths paths = prepared_->light_paths(light_paths_);
    const LightPaths* shared = light_paths_ > 0.0 ? &paths : nullptr;
    for_each_sample(unit, prepared.scene.render.seed, [&](int x, int y, std::int64_t i) {
        film.add(x, y, trace_pixel_sample(prepared, x, y, std::uint32_t(i), shared), i);
    });
}

double CausticsEstimator::light_paths() const { return light_paths_; }

void CausticsEstimator::trace_light(const LightUnit& unit, SplatList& splats) const {
    const LightPaths paths = prepared_->light_paths(light_paths_);
    const std::uint64_t seed = prepared_->scene.scene.render.seed;
    for (std::uint64_t path = unit.first_path; path < unit.end_path; ++path) {
        const SampleKey key = light_path_key(seed, unit.pass, path);
        if (const std::optional<EmittedRay> ray = prepared_->emission.sample(key))
            prepared_->trace(*ray, key, paths, splats);
    }
}

std::optional<LightPathReport> CausticsEstimator::light_path_report() const {
    const caustics::TrainingReport& passes = prepared_->training;
    if (passes.empty()) return std::nullopt;
    LightPathReport report{0, passes.front().share(), passes.back().share()};
    for (const caustics::TrainingPass& pass : passes) report.traced += pass.paths;
    return report;
}

std::unique_ptr<Estimator> make_caustics_estimator(const Scene& scene) {
    auto estimator = std::make_unique<CausticsEstimator>(scene);
    estimator->aim();
    return estimator;
}

std::string caustics_settings(const RenderSettings& settings) {
    return path_settings(settings) + ", " + text_of(settings.caustics);
}

}  // namespace dewbow
