// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/undisturbed.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dewbow/base/random.h"

namespace dewbow {
namespace {

using unit::m;

int add(Scene& scene, Geometry geometry, const Affine& place) {
    if (scene.materials.empty()) scene.add({"black", Black{}});
    scene.shapes.push_back({"", std::move(geometry), Transform<World, Object>(place), 0});
    return int(scene.shapes.size()) - 1;
}

/// Against every pair of boxes, one by one.
TEST(Undisturbed, SpheresThatNoOtherBoxComesNear) {
    Scene scene = make_empty_scene();
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const SampleKey key(51, i);
        const auto a = key.two(0, Purpose::test), b = key.two(1, Purpose::test);
        add(scene, Sphere{0.02 * m}, translation({a[0], a[1], b[0]}));
    }
    std::vector<bool> expected;
    for (const Shape& shape : scene.shapes)
        expected.push_back(
            std::none_of(scene.shapes.begin(), scene.shapes.end(), [&](const Shape& other) {
                return &other != &shape && bounds_of(other).overlaps(bounds_of(shape));
            }));
    const std::vector<bool> found =
        find_undisturbed(scene, std::vector<const ConvexSolid*>(scene.shapes.size(), nullptr));
    EXPECT_EQ(found, expected);
    EXPECT_GT(std::count(found.begin(), found.end(), true), 300);
    EXPECT_GT(std::count(found.begin(), found.end(), false), 300);
}

TEST(Undisturbed, APlaneDisturbsWhatItCuts) {
    Scene scene = make_empty_scene();
    const int above = add(scene, Sphere{1.0 * m}, translation({0, 0, 2}));
    const int cut = add(scene, Box{1.0 * m, 1.0 * m, 1.0 * m}, translation({5, 0, 0}));
    const int plane = add(scene, Plane{}, {});
    const std::vector<bool> found = find_undisturbed(scene, {nullptr, nullptr, nullptr});
    EXPECT_TRUE(found[std::size_t(above)]);
    EXPECT_FALSE(found[std::size_t(cut)]);
    EXPECT_FALSE(found[std::size_t(plane)]);
}

}  // namespace
}  // namespace dewbow
