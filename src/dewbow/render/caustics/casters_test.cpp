// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/caustics/casters.h"

#include <gtest/gtest.h>

#include "dewbow/base/random.h"
#include "dewbow/render/caustics/emission_scenes.h"

namespace dewbow::caustics {
namespace {

using unit::m;

std::size_t groups_with(const std::function<int(Scene&)>& add_material) {
    Scene scene = make_empty_scene();
    const int material = add_material(scene);
    add_shape(scene, Sphere{1.0 * m}, {}, material);
    return Casters(scene, see_through_shapes(scene)).groups().size();
}

TEST(Casters, AreWhatBendsOrMirrorsLight) {
    const auto one = make_constant(1.0);
    const auto air = [](Scene& scene) {
        return std::make_shared<Medium>(Medium{"", scene.surroundings->index, nullptr, 0});
    };
    EXPECT_EQ(groups_with(add_glass), 1u);
    EXPECT_EQ(groups_with(add_mirror), 1u);
    EXPECT_EQ(groups_with([](Scene& s) {
                  return s.add({"", Dielectric{test_glass(), 0.3}, {}});
              }),
              1u)
        << "rough glass";
    EXPECT_EQ(groups_with([&](Scene& s) { return s.add({"", Conductor{one, one}, {}}); }), 1u);
    EXPECT_EQ(groups_with([&](Scene& s) {
                  return s.add({"", Conductor{one, one, 0.2}, {}});
              }),
              0u)
        << "rough metal scatters";
    EXPECT_EQ(groups_with([&](Scene& s) {
                  return s.add({"", ThinDielectric{test_glass()->index}, {}});
              }),
              1u);
    EXPECT_EQ(groups_with([&](Scene& s) {
                  return s.add({"", ThinDielectric{test_glass()->index, {}, 0.2}, {}});
              }),
              0u);
    EXPECT_EQ(groups_with([&](Scene& s) { return s.add({"", Diffuse{one}, {}}); }), 0u);
    EXPECT_EQ(groups_with([&](Scene& s) { return s.add({"", MetallicRoughness{one}, {}}); }), 0u);
    EXPECT_EQ(groups_with([&](Scene& s) { return s.add({"", Black{}, {}}); }), 0u);
    EXPECT_EQ(groups_with([&](Scene& s) {
                  return s.add({"", Dielectric{air(s)}, {}});
              }),
              0u)
        << "a body of air in air";
    EXPECT_EQ(groups_with([&](Scene& s) {
                  const int grey = s.add({"", Diffuse{one}, {}}), mirror = add_mirror(s);
                  return s.add({"", Mix{grey, mirror, 0.1}, {}});
              }),
              1u);
}

/// Haze before any of them is left to light paths (haze_share.h), so none may be forgotten.
TEST(Casters, AreAllPlanesWithoutEnd) {
    constexpr std::size_t kPlanes = 100;  // more than the groups of other casters, at least 64
    Scene scene = make_empty_scene();
    const int mirror = add_mirror(scene);
    for (std::size_t i = 0; i < kPlanes; ++i)
        add_shape(scene, Plane{}, translation({0, 0, -double(i)}), mirror);
    add_shape(scene, Sphere{1.0 * m}, translation({0, 0, 5}), mirror);
    EXPECT_EQ(Casters(scene, see_through_shapes(scene)).groups().size(), kPlanes + 1);
}

/// Share of a lamp's rays that meet a caster.
double share_that_arrives(const Scene& scene) {
    constexpr int kRays = 4096;
    const Ready ready(scene);
    int arrived = 0;
    for (int i = 0; i < kRays; ++i) {
        const SampleKey key(stream_key(2, 0, 0), std::uint32_t(i));
        const auto a = key.two(0, Purpose::test);
        const auto ray = ready.maps[0].ray(
            {a[0], a[1], key.third(0, Purpose::test), key.fourth(0, Purpose::test)});
        arrived += ray && ready.prepared.accelerator.intersect(ray->ray);
    }
    return double(arrived) / kRays;
}

/// Ten thousand small beads in a cloud: rays go to beads, and not to the air between them.
TEST(Casters, MayBeTenThousandBeads) {
    constexpr int kBeads = 10000;
    Scene scene = make_empty_scene();
    const int glass = add_glass(scene);
    for (int i = 0; i < kBeads; ++i) {
        const SampleKey key(stream_key(4, 0, 0), std::uint32_t(i));
        const auto a = key.two(0, Purpose::test);
        const Vec3 at{4.0 * a[0] - 2.0, 4.0 * a[1] - 2.0, 4.0 * key.third(0, Purpose::test) - 2.0};
        add_shape(scene, Sphere{0.005 * m}, translation(at), glass);
    }
    Scene sun = scene, point = scene;
    sun.lights.push_back(DistantLight{{{0, -1, 0}}, 0.2666 * unit::deg, make_constant(1.0)});
    point.lights.push_back(PointLight{{{0, 4, 0}}, make_constant(1.0)});
    EXPECT_GT(share_that_arrives(sun), 0.9);
    EXPECT_GT(share_that_arrives(point), 0.9);
}

/// Stones far apart in one mesh are aimed at one by one.
TEST(Casters, MayBePartsOfOneMesh) {
    Mesh both = *icosahedron();
    const auto corners = std::uint32_t(both.vertices.size());
    for (std::uint32_t i = 0; i < corners; ++i)
        both.vertices.push_back({both.vertices[i].v + Vec3{9, 0, 0}});
    for (std::size_t i = 0; i < 20; ++i) {
        const auto [a, b, c] = both.triangles[i];
        both.triangles.push_back({a + corners, b + corners, c + corners});
    }
    Scene scene = make_empty_scene();
    add_shape(scene, std::make_shared<const Mesh>(both), {}, add_glass(scene));
    EXPECT_EQ(Casters(scene, see_through_shapes(scene)).groups().size(), 2u);
}

/// A prism turned in space: the box around it shows the sun 1.3 to 2 times as much.
TEST(Casters, AreAimedAtByTheirOwnBoxes) {
    Scene scene = make_empty_scene();
    add_shape(scene, Prism{60.0 * unit::deg, 0.03 * m, 0.3 * m},
              rotation(normalised(Vec3{1, 2, 3}), 0.8 * unit::rad), add_glass(scene));
    scene.lights.push_back(UniformEnvironment{make_constant(1.0)});
    EXPECT_GT(share_that_arrives(scene), 0.7);
}

}  // namespace
}  // namespace dewbow::caustics
