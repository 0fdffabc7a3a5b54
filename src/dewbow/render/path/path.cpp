// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/path/path.h"

#include <atomic>

#include "dewbow/base/check.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> serial{0};
    return ++serial;
}

Colour<Xyz> albedo_of(const Material& material) {
    const Spectrum* spectrum = nullptr;
    if (const auto* diffuse = std::get_if<Diffuse>(&material.surface))
        spectrum = diffuse->reflectance.spectrum.get();
    else if (const auto* metallic = std::get_if<MetallicRoughness>(&material.surface))
        spectrum = metallic->base_colour.spectrum.get();
    else if (std::holds_alternative<Black>(material.surface))
        return {};
    const Colour<Xyz> white = xyz_from_spectrum(*make_constant(1.0));
    return (spectrum ? xyz_from_spectrum(*spectrum) : white) * (1.0 / cie_y_integral());
}

class PathEstimator : public Estimator {
public:
    explicit PathEstimator(const Scene& scene) : prepared_(scene) {}

    void render(const Unit& unit, FilmSums& film) const override {
        ReplayContext& replay = replay_context();
        replay.seed = prepared_.scene.render.seed;
        for (int y = unit.tile.y0; y < unit.tile.y1; ++y) {
            for (int x = unit.tile.x0; x < unit.tile.x1; ++x) {
                for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i) {
                    replay.pixel_x = x, replay.pixel_y = y, replay.sample = i;
                    film.add(x, y, trace_pixel_sample(prepared_, x, y, std::uint32_t(i)), i);
                }
            }
        }
        replay = {};
    }

private:
    PreparedScene prepared_;
};

}  // namespace

PreparedScene::PreparedScene(const Scene& s)
    : serial(next_serial()),
      scene(s),
      media(s),
      see_through(see_through_shapes(s)),
      opacity(s),
      accelerator(s, see_through, &opacity),
      lights(s),
      camera(s) {
    camera_media = media_at(camera.position(), scene, media, accelerator);
    for (const Material& material : scene.materials) {
        albedo.push_back(albedo_of(material));
        varies.push_back(surface_varies(scene, material));
    }
}

PixelSample trace_pixel_sample(const PreparedScene& prepared, int x, int y, std::uint32_t index) {
    const RenderSettings& settings = prepared.scene.render;
    const SampleKey key(stream_key(settings.seed, std::uint32_t(x), std::uint32_t(y)), index);
    const WavelengthPacket wavelengths =
        sample_wavelengths(settings.wavelengths, settings.packet, key.one(0, Purpose::wavelength));
    return trace_sample(prepared, prepared.camera.ray(x, y, key), prepared.camera_media,
                        wavelengths, key);
}

std::unique_ptr<Estimator> make_path_estimator(const Scene& scene) {
    return std::make_unique<PathEstimator>(scene);
}

}  // namespace dewbow
