// SPDX-License-Identifier: Apache-2.0
#pragma once

// The spectral path tracer: camera paths that carry a packet of wavelengths.

#include <memory>

#include "dewbow/render/accelerator.h"
#include "dewbow/render/camera_ray.h"
#include "dewbow/render/estimator.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/media.h"
#include "dewbow/render/scene_opacity.h"

namespace dewbow {

/// What all paths of a render share: the scene, made ready for tracing. Immutable.
struct PreparedScene {
    explicit PreparedScene(const Scene& scene);

    const std::uint64_t
        serial;  ///< different for each, never 0: what a thread keeps belongs to one of them
    const Scene& scene;
    MediaTable media;
    std::vector<bool> see_through;  ///< one a shape: see_through_shapes
    SceneOpacity opacity;
    Accelerator accelerator;
    LightSet lights;
    CameraRays camera;
    MediaStack camera_media;          ///< what the camera stands in
    std::vector<Colour<Xyz>> albedo;  ///< one a material, for the albedo layer
    std::vector<bool> varies;         ///< one a material: surface_varies
};

/// Sample `index` of pixel (x, y).
PixelSample trace_pixel_sample(const PreparedScene& prepared, int x, int y, std::uint32_t index);

/// The radiance that arrives along `ray` at each lane of `wavelengths`, estimated by the random
/// numbers of `key`. `media` says what the ray starts in.
PixelSample trace_sample(const PreparedScene& prepared, const Ray& ray, MediaStack media,
                         const WavelengthPacket& wavelengths, const SampleKey& key);

/// The same where each lane arrives along its own ray of `rays`; the layers are of `first`.
PixelSample trace_open_sample(const PreparedScene& prepared, const Ray& first, const RayLanes& rays,
                              MediaStack media, const WavelengthPacket& wavelengths,
                              const SampleKey& key);

/// `scene` must outlive the estimator.
std::unique_ptr<Estimator> make_path_estimator(const Scene& scene);

}  // namespace dewbow
