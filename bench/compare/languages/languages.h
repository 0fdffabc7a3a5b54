// SPDX-License-Identifier: Apache-2.0
#pragma once

// The other renderers as contestants: each is told the scene in its own language. Nothing is fitted
// to their pictures: cameras, indices and radiances are stated as the scene has them, and exposure
// is 1.

#include <string>

#include "contestant.h"

namespace dewbow::bench {

std::unique_ptr<Contestant> find_pov_ray(const Programs& programs);
std::unique_ptr<Contestant> find_pov_ray_photons(const Programs& programs);
std::unique_ptr<Contestant> find_blender(const Programs& programs);
std::unique_ptr<Contestant> find_pbrt(const Programs& programs);
std::unique_ptr<Contestant> find_pbrt_lightpath(const Programs& programs);
std::unique_ptr<Contestant> find_pbrt_bdpt(const Programs& programs);
std::unique_ptr<Contestant> find_pbrt_sppm(const Programs& programs);
std::unique_ptr<Contestant> find_pbrt_mlt(const Programs& programs);
std::unique_ptr<Contestant> find_mitsuba(const Programs& programs);

/// What their writers read of an order.
struct SceneOrder {
    const PlainScene& scene;
    Knobs knobs;
    int threads = 1;
    int max_depth = 64;  ///< surfaces that a path may meet
};

/// The name of the picture that all of them are told to leave in their folder.
inline constexpr const char* kPictureFile = "picture.exr";

// Files of each language, as text.
std::string pov_scene(const SceneOrder& order);
std::string pov_photon_scene(const SceneOrder& order);
std::string blender_script(const SceneOrder& order);
/// @param integrator  by pbrt's name.
std::string pbrt_scene(const SceneOrder& order, const std::string& integrator = "path");
std::string mitsuba_scene(const SceneOrder& order);
/// The body as Mitsuba's scene reads it from a file beside: Wavefront OBJ.
std::string mitsuba_body(const PlainBody& body);

}  // namespace dewbow::bench
