// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes that a method which sends light to glass may stumble over: where there is little to aim
// at, nothing, far too much, or no way to the camera.

#include "caustic_scenes.h"

namespace dewbow::kit {

/// A closed room of `half` metres to each side of its middle, on the floor y = 0.
inline void add_room(Scene& scene, double half, double height) {
    const auto wall = [&](Vec3 at, const Affine& turn, const Material& material) {
        add(scene, Rectangle{2.0 * half * m, 2.0 * half * m}, material, translation(at) * turn);
    };
    wall({0, 0, 0}, kFloor, paint(0.6, 0.5, 0.4));
    wall({0, height, 0}, rotation({1, 0, 0}, 90.0 * deg), diffuse(0.8));
    wall({-half, 0.5 * height, 0}, rotation({0, 1, 0}, 90.0 * deg), diffuse(0.7));
    wall({half, 0.5 * height, 0}, rotation({0, 1, 0}, -90.0 * deg), diffuse(0.7));
    wall({0, 0.5 * height, -half}, {}, diffuse(0.7));
    wall({0, 0.5 * height, half}, rotation({0, 1, 0}, 180.0 * deg), diffuse(0.7));
}

/// Of the small lamp's light one part in 10⁴ goes to the prism: 0.06 m × 0.08 m at 2 m.
inline Scene tiny_prism() {
    Scene scene = caustic_scene({0.4, 0.9, 0.9}, {0.2, 0.1, 0}, 40.0 * deg);
    add_room(scene, 4.0, 3.0);
    add(scene, Prism{60.0 * deg, 0.06 * m, 0.08 * m}, dielectric(glass("schott/N-SF11")),
        translation({0, 0.3, 0}) * rotation({0, 1, 0}, 30.0 * deg));
    add(scene, Sphere{0.03 * m}, lamp(make_scaled(find_illuminant("D65"), 300.0)),
        translation({-0.9, 2.0, 0.3}));
    return scene;
}

/// Nothing to aim at.
inline Scene no_casters() {
    Scene scene = over_a_floor();
    add_room(scene, 3.0, 2.8);
    add(scene, Sphere{0.4 * m}, paint(0.8, 0.3, 0.2), translation({-0.3, 0.4, 0}));
    add(scene, Box{0.5 * m, 0.5 * m, 0.5 * m},
        {"plastic", MetallicRoughness{make_reflectance({{0.2, 0.6, 0.3}}), 0.0, 0.4, 1.5}, nullptr},
        translation({0.4, 0.25, 0.2}));
    add_lamp(scene, 0.4);
    return scene;
}

/// The camera stands in a closed box of thick glass: light paths find nothing that it sees.
inline Scene glass_box_around_the_camera() {
    Scene scene = caustic_scene({0, 1.0, 1.5}, {0, 0.6, -1}, 50.0 * deg);
    add_room(scene, 3.0, 2.8);
    add(scene, Sphere{0.4 * m}, paint(0.8, 0.3, 0.2), translation({-0.3, 0.4, -1}));
    add(scene, Box{0.8 * m, 0.8 * m, 0.8 * m}, dielectric(glass("schott/N-BK7", nullptr, 1)),
        translation({0, 1.0, 1.5}));
    add(scene, Box{0.7 * m, 0.7 * m, 0.7 * m},
        dielectric(std::make_shared<Medium>(Medium{"hollow", air(), nullptr, 2})),
        translation({0, 1.0, 1.5}));
    add_lamp(scene, 0.4, 4.0, {0, 2.7, -1});
    return scene;
}

/// All but everything comes from one texel of a fine picture, 0.35 degrees wide.
inline Scene sun_pixel() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.3 * m}, dielectric(glass("schott/N-SF66")), translation({0, 0.45, 0}));
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 1024;
    image->height = 512;
    image->pixels.assign(1024 * 512, {{0.2, 0.3, 0.5}});
    image->pixels[100 * 1024 + 400] = {{60000.0, 55000.0, 50000.0}};
    scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(image));
    return scene;
}

/// 10,000 of them, in a field of 100 by 100, under the sun.
inline Scene beads() {
    Scene scene = over_a_floor();
    add_floor(scene);
    const int id = scene.add(dielectric(glass("schott/N-BK7")));
    for (int i = 0; i < 100; ++i)
        for (int k = 0; k < 100; ++k)
            scene.shapes.push_back(
                {"bead", Sphere{0.008 * m},
                 Transform<World, Object>(translation(
                     {0.02 * (i - 49.5), 0.012 + 0.01 * ((i * 7 + k * 3) % 5), 0.02 * (k - 49.5)})),
                 id});
    scene.lights.push_back(
        DistantLight{{normalised({0.4, -1, -0.2})}, 0.2666 * deg, make_constant(3.0)});
    scene.lights.push_back(UniformEnvironment{make_constant(0.1)});
    return scene;
}

inline const NamedScene kRobustScenes[] = {
    {"TinyPrism", &tiny_prism},
    {"NoCasters", &no_casters},
    {"RoomThroughAWindow", &room_through_a_window},
    {"GlassBoxAroundTheCamera", &glass_box_around_the_camera},
    {"SunPixel", &sun_pixel},
    {"Beads", &beads},
};

}  // namespace dewbow::kit
