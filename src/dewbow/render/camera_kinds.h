// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras of all kinds, for tests. None stands at the origin or looks along an axis.

#include <string>
#include <vector>

#include "dewbow/optics/catalogue.h"
#include "dewbow/scene/scene.h"

namespace dewbow::test_kit {

struct CameraKind {
    std::string name;
    Scene scene;
};

inline Scene scene_with(const Film& film, Projection projection) {
    Scene scene = make_empty_scene();
    scene.film = film;
    scene.camera.projection = projection;
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({1, 2, 3}, {-1, 0.5, 2}, {0.1, 1, 0}));
    return scene;
}

inline Scene with_stereo(Scene scene, StereoLayout layout) {
    scene.camera.stereo = StereoPair{0.2 * unit::m, 3.0 * unit::m, layout};
    return scene;
}

inline Scene with_lens(Scene scene, int blades, bool glass) {
    ThinLens lens{0.05 * unit::m, 2.0 * unit::m, blades, {}};
    if (glass)
        lens.glass = LensGlass{make_dispersion(find_glass("schott/N-SF11").data), 0.1 * unit::m};
    scene.camera.lens = lens;
    return scene;
}

inline Scene squeezed(Scene scene) {
    scene.camera.world_from_camera = Transform<World, Camera>(
        scene.camera.world_from_camera.affine() * scaling({2.0, 0.5, 3.0}));
    return scene;
}

inline std::vector<CameraKind> cameras_of_all_kinds(const Film& film) {
    const Scene perspective = scene_with(film, Perspective{60.0 * unit::deg});
    const Scene orthographic = scene_with(film, Orthographic{5.0 * unit::m});
    const Scene panorama = scene_with(film, Panorama{});
    return {
        {"perspective", perspective},
        {"orthographic", orthographic},
        {"panorama", panorama},
        {"perspective, scaled", squeezed(perspective)},
        {"orthographic, scaled", squeezed(orthographic)},
        {"panorama, scaled", squeezed(panorama)},
        {"round lens", with_lens(perspective, 0, false)},
        {"lens of six blades", with_lens(perspective, 6, false)},
        {"lens with dispersion", with_lens(perspective, 5, true)},
        {"side by side", with_stereo(perspective, StereoLayout::side_by_side)},
        {"over and under", with_stereo(perspective, StereoLayout::over_under)},
        {"left eye", with_stereo(perspective, StereoLayout::left)},
        {"right eye", with_stereo(perspective, StereoLayout::right)},
        {"pair with lens", with_lens(with_stereo(perspective, StereoLayout::over_under), 0, true)}};
}

}  // namespace dewbow::test_kit
