// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes whose light camera paths find by chance, with patience, and light paths at once.

#include "../analytic/rain_kit.h"
#include "dewbow/optics/metal.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::kit {

inline const Affine kFloor = rotation({1, 0, 0}, -90.0 * deg);
/// Faces down.
inline Affine above(Vec3 at) { return translation(at) * rotation({1, 0, 0}, 90.0 * deg); }

inline Material paint(double r, double g, double b) {
    return {"paint", Diffuse{make_reflectance({{r, g, b}})}, nullptr, false};
}

/// A small picture of a small part of the world.
inline Scene caustic_scene(Vec3 eye, Vec3 target, Angle field) {
    Scene scene = make_empty_scene();
    scene.render.max_depth = 16;
    scene.film.width = scene.film.height = 16;
    scene.camera.world_from_camera = Transform<World, Camera>(looking_at(eye, target, {0, 1, 0}));
    scene.camera.projection = Perspective{field};
    return scene;
}
inline void add_floor(Scene& scene, Material material = paint(0.7, 0.6, 0.5)) {
    add(scene, Rectangle{8.0 * m, 8.0 * m}, std::move(material), kFloor);
}
/// Looks at the floor behind something that stands over its middle.
inline Scene over_a_floor() { return caustic_scene({0, 2.2, 2.6}, {0, 0, 0}, 30.0 * deg); }

inline void add_lamp(Scene& scene, double radius, double scale = 4.0, Vec3 at = {0, 2.4, 0}) {
    add(scene, Disc{radius * m}, lamp(make_scaled(find_illuminant("D65"), scale)), above(at));
}

inline Scene glass_ball() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.3 * m}, dielectric(glass("schott/N-SF66")), translation({0, 0.45, 0}));
    add_lamp(scene, 0.7);
    return scene;
}

/// The ball stands in rain, which dims the light on each way of it.
inline Scene glass_ball_in_rain() {
    Scene scene = glass_ball();
    scene.rains = {rain_in_box(drops(0.4), {0, 1.2, 0}, {1, 1, 1})};
    return scene;
}

/// Where the glass scatters both ways find light, and next-event estimation too.
inline Scene rough_glass() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.3 * m}, dielectric(glass("schott/N-SF66"), 0.25),
        translation({0, 0.45, 0}));
    add(scene, Box{0.5 * m, 0.1 * m, 0.5 * m}, dielectric(glass("schott/N-BK7"), 0.4),
        translation({0.5, 0.5, 0.2}));
    add_lamp(scene, 0.7);
    return scene;
}

/// All light comes through the pane, and much of it from other walls.
inline Scene room_through_a_window() {
    Scene scene = caustic_scene({0.6, 1.2, 1.7}, {0, 0.6, -1}, 50.0 * deg);
    const auto wall = [&](Vec3 at, const Affine& turn, const Material& material) {
        add(scene, Rectangle{4.0 * m, 4.0 * m}, material, translation(at) * turn);
    };
    wall({0, 0, 0}, kFloor, paint(0.5, 0.4, 0.3));
    wall({0, 2, 0}, rotation({1, 0, 0}, 90.0 * deg), diffuse(0.8));
    wall({-1, 1, 0}, rotation({0, 1, 0}, 90.0 * deg), paint(0.8, 0.3, 0.2));
    wall({0, 1, -2}, {}, diffuse(0.7));
    wall({0, 1, 2}, rotation({0, 1, 0}, 180.0 * deg), diffuse(0.7));
    // The fourth wall is glass, and the lamp stands behind it.
    add(scene, Box{0.05 * m, 4.0 * m, 4.2 * m}, dielectric(glass("schott/N-BK7")),
        translation({1, 1, 0}));
    add(scene, Rectangle{2.5 * m, 2.5 * m}, lamp(make_scaled(find_illuminant("D65"), 3.0)),
        translation({2.5, 1.5, 0}) * rotation({0, 1, 0}, -90.0 * deg));
    return scene;
}

inline Scene even_dome() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.4 * m}, dielectric(glass("schott/F2")), translation({0, 0.42, 0}));
    scene.lights.push_back(UniformEnvironment{make_constant(0.8)});
    return scene;
}

/// One texel of a coarse picture is a sun of 12 degrees.
inline Scene dome_of_a_picture() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.4 * m}, dielectric(glass("schott/N-SF66")), translation({0, 0.42, 0}));
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 32;
    image->height = 16;
    for (int i = 0; i < 32 * 16; ++i)
        image->pixels.push_back(
            {{0.1 + 0.01 * (i % 7), 0.2, 0.3 + (i == 3 * 32 + 12 ? 60.0 : 0.0)}});
    scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(image));
    return scene;
}

/// A stone in coloured water in a glass, each reaching into the next.
inline Scene nested_coloured_glass() {
    Scene scene = over_a_floor();
    add_floor(scene, diffuse(0.7));
    add(scene, Box{0.7 * m, 0.7 * m, 0.7 * m}, dielectric(glass("schott/N-BK7", nullptr, 1)),
        translation({0, 0.36, 0}));
    add(scene, Box{0.6 * m, 0.62 * m, 0.6 * m},
        dielectric(glass("fluid/water", make_absorption({{0.4, 0.8, 0.9}}, 0.5 * m), 2)),
        translation({0, 0.41, 0}));
    add(scene, Sphere{0.2 * m},
        dielectric(glass("gem/diamond", make_absorption({{0.9, 0.5, 0.4}}, 0.5 * m), 3)),
        translation({0, 0.42, 0}));
    add_lamp(scene, 0.8);
    return scene;
}

/// What bends nothing and still casts: mirrors, gold, tinted panes; on varnish.
inline Scene mirrors_and_panes() {
    Scene scene = over_a_floor();
    MetallicRoughness varnish{make_reflectance({{0.3, 0.5, 0.6}}), 0.0, 0.5};
    varnish.clearcoat = 0.5, varnish.clearcoat_roughness = 0.4;
    add_floor(scene, {"varnish", varnish});
    const Metal& gold = find_metal("gold");
    add(scene, Sphere{0.25 * m}, {"mirror", Mirror{make_reflectance({{0.9, 0.8, 0.6}})}, nullptr},
        translation({-0.4, 0.3, 0}));
    add(scene, Sphere{0.25 * m}, {"gold", Conductor{gold.n, gold.k}}, translation({0.4, 0.3, 0}));
    add(scene, Rectangle{1.2 * m, 0.6 * m},
        {"pane", ThinDielectric{make_dispersion(find_glass("gem/diamond").data),
                                make_reflectance({{0.5, 0.9, 0.8}})}},
        translation({0, 0.9, 0.2}) * kFloor);
    add_lamp(scene, 0.7);
    return scene;
}

/// Normals that are interpolated, and a lamp that is a picture.
inline Scene smoothed_mesh() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, sphere_mesh(0.35, 1, true), dielectric(glass("schott/N-SF66")),
        translation({0, 0.45, 0}));
    auto image = std::make_shared<TextureImage>();
    image->width = image->height = 4;
    for (int i = 0; i < 16; ++i)
        for (const int value : {i % 3 ? 30 : 255, 90, i % 5 ? 200 : 40, 255})
            image->texels8.push_back(std::uint8_t(value));
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    Material screen{"screen", Black{}, nullptr, false};
    screen.emission_texture = EmissionTexture{texture, {{6.0, 6.0, 6.0}}};
    add(scene, Rectangle{1.6 * m, 1.6 * m}, screen, above({0, 2.0, 0}));
    return scene;
}

/// The lamp is in the glass, and the glass in the room.
inline Scene lamp_in_glass() {
    Scene scene = over_a_floor();
    add_floor(scene);
    add(scene, Sphere{0.5 * m},
        dielectric(glass("schott/F2", make_absorption({{0.9, 0.6, 0.4}}, 0.5 * m))),
        translation({0, 0.7, 0}));
    add(scene, Sphere{0.2 * m}, lamp(make_scaled(find_illuminant("A"), 4.0)),
        translation({0.1, 0.75, 0}));
    return scene;
}

struct NamedScene {
    const char* name;
    Scene (*make)();
};
inline void PrintTo(const NamedScene& row, std::ostream* out) { *out << row.name; }

inline const NamedScene kCausticScenes[] = {
    {"GlassBall", &glass_ball},
    {"GlassBallInRain", &glass_ball_in_rain},
    {"RoughGlass", &rough_glass},
    {"RoomThroughAWindow", &room_through_a_window},
    {"EvenDome", &even_dome},
    {"DomeOfAPicture", &dome_of_a_picture},
    {"NestedColouredGlass", &nested_coloured_glass},
    {"MirrorsAndPanes", &mirrors_and_panes},
    {"SmoothedMesh", &smoothed_mesh},
    {"LampInGlass", &lamp_in_glass},
};

}  // namespace dewbow::kit
