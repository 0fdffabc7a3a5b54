// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/prepared_scene.h"

#include <atomic>

#include "dewbow/render/albedo.h"

namespace dewbow {

namespace {

std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> serial{0};
    return ++serial;
}

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
    if (scene.paper_rainbow) paper_fog.emplace(scene);
    if (media.scatters() || Weather::is_there(s)) haze.emplace(scene, lights, camera);
    if (Weather::is_there(scene)) weather.emplace(scene);
    albedo = albedo_of_materials(scene);
    for (const Material& material : scene.materials)
        varies.push_back(surface_varies(scene, material));
}

}  // namespace dewbow
