// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/caustics.h"

#include "dewbow/render/caustics/lamp_media.h"
#include "dewbow/render/caustics/light_walk.h"
#include "dewbow/render/caustics/training.h"
#include "dewbow/render/path/path.h"

namespace dewbow {

namespace {

using caustics::EmittedRay;

class CausticsEstimator : public Estimator {
public:
    explicit CausticsEstimator(const Scene& scene)
        : prepared_(scene),
          emission_(prepared_),
          lamp_media_(prepared_),
          light_paths_{emission_, emission_.empty() ? 0.0 : paths_per_sample(scene)} {
        if (scene.render.caustics.aimed) learn();
    }

    void render(const Unit& unit, FilmSums& film) const override {
        const caustics::LightPaths* shared = light_paths() > 0.0 ? &light_paths_ : nullptr;
        for_each_sample(unit, prepared_.scene.render.seed, [&](int x, int y, std::int64_t i) {
            film.add(x, y, trace_pixel_sample(prepared_, x, y, std::uint32_t(i), shared), i);
        });
    }

    double light_paths() const override {
        return light_paths_.per_sample > 0.0 ? prepared_.scene.render.caustics.light_paths : 0.0;
    }

    void trace_light(const LightUnit& unit, SplatList& splats) const override {
        const std::uint64_t seed = prepared_.scene.render.seed;
        for (std::uint64_t path = unit.first_path; path < unit.end_path; ++path) {
            const SampleKey key = light_path_key(seed, unit.pass, path);
            if (const std::optional<EmittedRay> ray = emission_.sample(key))
                trace(*ray, key, splats);
        }
    }

private:
    static double paths_per_sample(const Scene& scene) {
        return scene.render.caustics.light_paths * scene.film.width * scene.film.height;
    }

    void trace(const EmittedRay& ray, const SampleKey& key, SplatList& splats) const {
        const RenderSettings& settings = prepared_.scene.render;
        const WavelengthPacket packet =
            sample_wavelengths(settings.wavelengths, settings.packet,
                               key.one(0, Purpose::wavelength) / settings.packet);
        const bool afar = ray.source == LightSample::Source::infinite;
        caustics::LightWalk(prepared_, light_paths_, packet, key, splats)
            .run(ray, afar ? MediaStack{} : lamp_media_.along(ray.ray));
    }

    void learn() {
        const Scene& scene = prepared_.scene;
        FilmLayout whole;
        whole.width = scene.film.width, whole.height = scene.film.height;
        whole.crop = {0, 0, whole.width, whole.height};
        caustics::train(emission_, scene.render.seed,
                        light_paths_.per_sample * scene.render.samples_per_pixel,
                        [&](const EmittedRay& ray, const SampleKey& key) {
                            SplatList splats(whole);
                            trace(ray, key, splats);
                            double squares = 0.0;
                            for (const Splat& splat : splats.splats())
                                squares += double(splat.xyz[1]) * splat.xyz[1];
                            return squares;
                        });
    }

    PreparedScene prepared_;
    caustics::AimedEmission emission_;
    caustics::LampMedia lamp_media_;
    caustics::LightPaths light_paths_;
};

}  // namespace

std::unique_ptr<Estimator> make_caustics_estimator(const Scene& scene) {
    return std::make_unique<CausticsEstimator>(scene);
}

std::string caustics_settings(const RenderSettings& settings) {
    return path_settings(settings) + ", " + text_of(settings.caustics);
}

}  // namespace dewbow
