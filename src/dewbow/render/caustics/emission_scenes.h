// SPDX-License-Identifier: Apache-2.0
#pragma once

// For tests: each kind of lamp before casters of several kinds.

#include <functional>
#include <string>
#include <vector>

#include "dewbow/render/caustics/emission_map.h"

namespace dewbow::caustics {

inline MediumPtr test_glass() {
    return std::make_shared<Medium>(
        Medium{"", make_dispersion({"constant", {1.5}, IndexReference::vacuum}), nullptr, 0});
}
inline int add_glass(Scene& scene) { return scene.add({"glass", Dielectric{test_glass()}, {}}); }
inline int add_mirror(Scene& scene) {
    return scene.add({"mirror", Mirror{make_constant(1.0)}, {}});
}
inline void add_shape(Scene& scene, Geometry geometry, const Affine& world, int material) {
    scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(world), material});
}

/// Twenty triangles alike about the origin, each vertex at distance 1: an icosahedron.
inline std::shared_ptr<const Mesh> icosahedron() {
    Mesh mesh;
    const double a = 1.0 / std::sqrt(1.0 + 1.6180339887498949 * 1.6180339887498949);
    const double b = 1.6180339887498949 * a;
    for (const auto& [x, y, z] : {std::array{-a, b, 0.0},
                                  {a, b, 0.0},
                                  {-a, -b, 0.0},
                                  {a, -b, 0.0},
                                  {0.0, -a, b},
                                  {0.0, a, b},
                                  {0.0, -a, -b},
                                  {0.0, a, -b},
                                  {b, 0.0, -a},
                                  {b, 0.0, a},
                                  {-b, 0.0, -a},
                                  {-b, 0.0, a}})
        mesh.vertices.push_back({{x, y, z}});
    mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// A few things apart from each other, some metres below the origin.
inline void add_things(Scene& scene) {
    using unit::m;
    const int glass = add_glass(scene), mirror = add_mirror(scene);
    const auto turned = [](double x, double y, double z) {
        return translation({x, y, z}) * rotation(normalised(Vec3{1, 2, 3}), 0.7 * unit::rad);
    };
    add_shape(scene, Sphere{0.9 * m}, translation({-1.5, -4, 0.2}), glass);
    add_shape(scene, Prism{60.0 * unit::deg, 1.4 * m, 2.0 * m}, turned(1.5, -3, 0.5), glass);
    add_shape(scene, Disc{0.8 * m}, turned(0.2, -5, -2), mirror);
    add_shape(scene, icosahedron(), turned(0.5, -4, 2.5) * scaling({0.6, 1.2, 0.8}), glass);
}
/// A plane without end, 3 m below the origin and tilted.
inline void add_plane(Scene& scene) {
    add_shape(scene, Sphere{0.1 * unit::m}, translation({0.5, -1, 0}),
              scene.add({"grey", Diffuse{make_constant(0.5)}, {}}));
    add_shape(scene, Plane{}, translation({0, -3, 0}) * rotation({1, 0, 0}, -80.0 * unit::deg),
              add_mirror(scene));
}
/// A bulb around the origin.
inline void add_bulb(Scene& scene) {
    add_shape(scene, icosahedron(), scaling({9, 9, 9}), add_glass(scene));
}

/// A picture of 4 × 2 texels, one of them ten times as bright.
inline TexturePtr test_texture() {
    auto image = std::make_shared<TextureImage>();
    image->width = 4, image->height = 2;
    for (int i = 0; i < 8; ++i)
        for (const int channel : {20 + 10 * i, 100, i == 5 ? 255 : 25, 255})
            image->texels8.push_back(std::uint8_t(channel));
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    texture->coding = TextureCoding::linear;
    return texture;
}

struct Lamp {
    std::string name;
    std::function<void(Scene&)> add;
};

inline std::vector<Lamp> lamps_of_shape() {
    using unit::m;
    const auto glowing = [](const char* name, Geometry geometry, const Affine& world,
                            bool two_sided, bool textured = false) {
        return Lamp{name, [=](Scene& scene) {
                        Material material{"lamp", Black{}, textured ? nullptr : make_constant(2.0)};
                        material.two_sided_emission = two_sided;
                        if (textured)
                            material.emission_texture.emplace(EmissionTexture{test_texture()});
                        add_shape(scene, geometry, world, scene.add(material));
                    }};
    };
    const Affine down = rotation({1, 0, 0}, 100.0 * unit::deg);
    const Affine askew = rotation(normalised(Vec3{1, 0.2, 0.3}), 2.0 * unit::rad);
    return {glowing("rectangle", Rectangle{1.0 * m, 0.5 * m}, down, false),
            glowing("rectangle of two sides", Rectangle{1.0 * m, 0.5 * m}, askew, true),
            glowing("screen", Rectangle{1.0 * m, 0.5 * m}, down, false, true),
            glowing("disc", Disc{0.3 * m}, down, false),
            glowing("sphere", Sphere{0.25 * m}, askew, false),
            glowing("sphere of two sides", Sphere{0.25 * m}, askew, true),
            glowing("textured sphere", Sphere{0.25 * m}, askew, false, true),
            glowing("ellipsoid", Sphere{0.25 * m}, askew * scaling({1, 1.5, 0.7}), false),
            glowing("box", Box{0.3 * m, 0.4 * m, 0.5 * m}, askew, false),
            glowing("prism", Prism{50.0 * unit::deg, 0.4 * m, 0.5 * m}, askew, false),
            glowing("mesh", icosahedron(), askew * scaling({0.2, 0.3, 0.2}), false)};
}

inline std::shared_ptr<const PhotometricWeb> test_web() {
    return std::make_shared<const PhotometricWeb>(PhotometricTable{
        {0, 30, 60, 90}, {0, 90, 360}, {100, 80, 30, 0, 100, 60, 20, 0, 100, 80, 30, 0}});
}

/// A picture of 16 × 8 pixels with a sun.
inline std::shared_ptr<const ImageEnvironment> test_sky() {
    ImageEnvironment sky;
    sky.width = 16, sky.height = 8;
    for (int i = 0; i < 16 * 8; ++i) {
        const double v = i == 37 ? 100.0 : 0.5 + 0.1 * (i % 5);
        sky.pixels.push_back({{v, 0.9 * v, 0.7 * v}});
    }
    sky.world_from_object = Transform<World, Object>(rotation({0, 1, 0}, 0.4 * unit::rad));
    return std::make_shared<const ImageEnvironment>(sky);
}

inline std::vector<Lamp> lamps_without_shape() {
    using unit::deg;
    const auto light = [](const char* name, Light l) {
        return Lamp{name, [=](Scene& scene) { scene.lights.push_back(l); }};
    };
    const Dir<World> down{normalised(Vec3{0.1, -1, 0.05})};
    const SpectrumPtr one = make_constant(1.0);
    return {light("point", PointLight{{}, one}),
            light("wide spot", SpotLight{{}, down, 20.0 * deg, 80.0 * deg, one}),
            light("narrow spot",
                  SpotLight{{}, {normalised(Vec3{1.5, -3, 0.5})}, 1.0 * deg, 3.0 * deg, one}),
            light("profile", ProfileLight{{}, {}, test_web(), one}),
            light("wide beam", BeamLight{{}, down, 3.0 * unit::m, one}),
            light("narrow beam", BeamLight{{{1.5, 0, 0.5}}, {{0, -1, 0}}, 0.05 * unit::m, one}),
            light("sun", DistantLight{down, 0.2666 * deg, one}),
            light("parallel light", DistantLight{down, 0.0 * deg, one}),
            light("even sky", UniformEnvironment{one}),
            light("picture", test_sky())};
}

struct LitScene {
    std::string name;
    Scene scene;
    std::vector<Ball> targets;  ///< around the casters; of a plane without end, below the lamps
};
inline std::vector<Ball> targets_of(const Scene& casters) {
    std::vector<Ball> targets;
    for (const Shape& shape : casters.shapes) {
        if (std::holds_alternative<Plane>(shape.geometry)) return {{{0, -6, 0}, 4.0}};
        const Bounds box = bounds_of(shape);
        targets.push_back({box.centre(), box.radius()});
    }
    return targets;
}
struct CasterKind {
    std::string name;
    std::function<void(Scene&)> add;
};
inline CasterKind things() { return {"things", add_things}; }

/// All lamps, each alone.
inline std::vector<LitScene> lamps_before(const CasterKind& casters) {
    std::vector<Lamp> lamps = lamps_of_shape();
    for (const Lamp& lamp : lamps_without_shape()) lamps.push_back(lamp);
    std::vector<LitScene> scenes;
    for (const Lamp& lamp : lamps) {
        LitScene lit{lamp.name + " before " + casters.name, make_empty_scene(), {}};
        casters.add(lit.scene);
        lit.targets = targets_of(lit.scene);
        lamp.add(lit.scene);
        scenes.push_back(std::move(lit));
    }
    return scenes;
}
inline std::vector<LitScene> all_lamps() {
    std::vector<LitScene> scenes = lamps_before(things());
    for (const CasterKind& kind : {CasterKind{"plane", add_plane}, CasterKind{"bulb", add_bulb}})
        for (LitScene& lit : lamps_before(kind)) scenes.push_back(std::move(lit));
    return scenes;
}

/// A scene with what is made of it.
struct Ready {
    explicit Ready(const Scene& scene)
        : prepared(scene), casters(scene, prepared.see_through), maps(prepared, casters) {}
    PreparedScene prepared;
    Casters casters;
    EmissionMaps maps;
};

}  // namespace dewbow::caustics
