// SPDX-License-Identifier: Apache-2.0
#pragma once

// The spectral path tracer: camera paths that carry a packet of wavelengths.

#include <memory>

#include "dewbow/render/estimator.h"
#include "dewbow/render/prepared_scene.h"

namespace dewbow {

namespace caustics {
struct LightPaths;
}

/// Sample `index` of pixel (x, y).   @param light_paths  what else finds light, or nullptr.
PixelSample trace_pixel_sample(const PreparedScene& prepared, int x, int y, std::uint32_t index,
                               const caustics::LightPaths* light_paths = nullptr);

/// The radiance that arrives along `ray` at each lane of `wavelengths`, estimated by the random
/// numbers of `key`. `media` says what the ray starts in.
PixelSample trace_sample(const PreparedScene& prepared, const Ray& ray, MediaStack media,
                         const WavelengthPacket& wavelengths, const SampleKey& key,
                         const caustics::LightPaths* light_paths = nullptr);

/// The same where each lane arrives along its own ray of `rays`; the layers are of `first`.
PixelSample trace_open_sample(const PreparedScene& prepared, const Ray& first, const RayLanes& rays,
                              MediaStack media, const WavelengthPacket& wavelengths,
                              const SampleKey& key,
                              const caustics::LightPaths* light_paths = nullptr);

/// `scene` must outlive the estimator.
std::unique_ptr<Estimator> make_path_estimator(const Scene& scene);
std::string path_settings(const RenderSettings& settings);

}  // namespace dewbow
