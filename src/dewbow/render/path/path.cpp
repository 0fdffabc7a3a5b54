// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/path/path.h"

#include "dewbow/render/path/camera_walk.h"

namespace dewbow {

namespace {

class PathEstimator : public Estimator {
public:
    explicit PathEstimator(const Scene& scene) : prepared_(scene) {}

    void render(const Unit& unit, FilmSums& film) const override {
        for_each_sample(unit, prepared_.scene.render.seed, [&](int x, int y, std::int64_t i) {
            film.add(x, y, trace_pixel_sample(prepared_, x, y, std::uint32_t(i)), i);
        });
    }

private:
    PreparedScene prepared_;
};

}  // namespace

PixelSample trace_pixel_sample(const PreparedScene& prepared, int x, int y, std::uint32_t index,
                               const caustics::LightPaths* light_paths) {
    const RenderSettings& settings = prepared.scene.render;
    const SampleKey key(stream_key(settings.seed, std::uint32_t(x), std::uint32_t(y)), index);
    // Behind a prism light depends on place and wavelength together: they are stratified together.
    // All lanes repeat after a packet-th of a turn, which the samples fill evenly.
    const double turn = key.third(0, Purpose::pixel_filter) / settings.packet;
    const WavelengthPacket wavelengths =
        sample_wavelengths(settings.wavelengths, settings.packet, turn);
    const CameraRays& camera = prepared.camera;
    const Ray ray = camera.ray(x, y, key);
    if (!camera.disperses())
        return trace_sample(prepared, ray, prepared.camera_media, wavelengths, key, light_paths);
    return trace_open_sample(prepared, ray, camera.rays(x, y, key, wavelengths.lambdas()),
                             prepared.camera_media, wavelengths, key, light_paths);
}

PixelSample trace_sample(const PreparedScene& prepared, const Ray& ray, MediaStack media,
                         const WavelengthPacket& wavelengths, const SampleKey& key,
                         const caustics::LightPaths* light_paths) {
    return walk::CameraWalk(prepared, light_paths, wavelengths, key, media).run(ray);
}

PixelSample trace_open_sample(const PreparedScene& prepared, const Ray& first, const RayLanes& rays,
                              MediaStack media, const WavelengthPacket& wavelengths,
                              const SampleKey& key, const caustics::LightPaths* light_paths) {
    return walk::CameraWalk(prepared, light_paths, wavelengths, key, media).run_open(first, rays);
}

std::unique_ptr<Estimator> make_path_estimator(const Scene& scene) {
    return std::make_unique<PathEstimator>(scene);
}

std::string path_settings(const RenderSettings& settings) {
    return "packet " + std::to_string(settings.packet) + ", max depth " +
           std::to_string(settings.max_depth) + ", roulette from " +
           std::to_string(settings.roulette_depth) + ", wavelengths " +
           (settings.wavelengths == WavelengthSampling::visual ? "visual" : "uniform") + ", " +
           text_of(settings.rain);
}

}  // namespace dewbow
