// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/accelerator.h"
#include "dewbow/render/camera_ray.h"
#include "dewbow/render/haze/haze.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/media.h"
#include "dewbow/render/paper_fog_light.h"
#include "dewbow/render/scene_opacity.h"
#include "dewbow/render/weather/weather.h"

namespace dewbow {

/// What all rays of a render share: the scene, made ready for tracing. Immutable.
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
    std::optional<Haze> haze;                ///< where a medium scatters, or there is weather
    std::optional<PaperFogLight> paper_fog;  ///< where the scene has the paper's rainbow
    std::optional<Weather> weather;          ///< where a scene has any
    MediaStack camera_media;                 ///< what the camera stands in
    std::vector<Colour<Xyz>> albedo;         ///< one a material, for the albedo layer
    std::vector<bool> varies;                ///< one a material: surface_varies
};

}  // namespace dewbow
