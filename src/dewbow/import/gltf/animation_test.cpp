// SPDX-License-Identifier: Apache-2.0

// Animations at one time, against values worked out by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/import/gltf/test_document.h"

namespace dewbow {
namespace {

using namespace gltf_test;

/// Floats of size 1 in the file.
constexpr double kFloat = 1e-6;
const float kHalfRoot = std::sqrt(0.5f);

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, kFloat);
    EXPECT_NEAR(a.y, b.y, kFloat);
    EXPECT_NEAR(a.z, b.z, kFloat);
}

/// One channel that moves `path` of node 0 between two times.
struct Curve {
    std::string times = bytes_of<float>({1, 3});
    int time_count = 2;
    std::string values = bytes_of<float>({0, 0, 0, 1, 2, 3});
    int value_count = 2;
    const char* type = "VEC3";
    const char* path = "translation";
    const char* interpolation = "LINEAR";
    int node = 0;
};

std::string animation_of(Buffer& buffer, const Curve& curve, const char* name = "a") {
    const int times = buffer.add(curve.times, "5126", curve.time_count, "SCALAR");
    const int values = buffer.add(curve.values, "5126", curve.value_count, curve.type);
    return R"({"name": ")" + std::string(name) + R"(", "samplers": [{"input": )" +
           std::to_string(times) + R"(, "output": )" + std::to_string(values) +
           R"(, "interpolation": ")" + curve.interpolation +
           R"("}], "channels": [{"sampler": 0, "target": {"node": )" + std::to_string(curve.node) +
           R"(, "path": ")" + curve.path + R"("}}]})";
}

Parts animated(const Curve& curve) {
    Buffer buffer;
    const std::string animation = animation_of(buffer, curve);
    Parts parts = buffer.parts(R"("POSITION": 0)");
    parts.rest = R"(, "animations": [)" + animation + "]";
    return parts;
}

/// Where (1, 0, 0) of the only shape is.
Vec3 place(const Curve& curve, std::optional<double> time_s) {
    return parse(animated(curve), time_s)
        .scene.shapes.at(0)
        .world_from_object(Point<Object>{{1, 0, 0}})
        .v;
}

TEST(GltfAnimation, MovesOnAStraightLineAndIsHeldAtItsEnds) {
    expect_near(place({}, 2.0), {1.5, 1, 1.5});
    expect_near(place({}, 1.5), {1.25, 0.5, 0.75});
    for (const double early : {0.0, 1.0}) expect_near(place({}, early), {1, 0, 0});
    for (const double late : {3.0, 100.0}) expect_near(place({}, late), {2, 2, 3});
}

TEST(GltfAnimation, WithoutATimeThingsRestAndItIsSaid) {
    const ParsedScene parsed = parse(animated({}));
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "the scene is shown at rest; --frame N shows its animations");
    expect_near(place({}, std::nullopt), {1, 0, 0});
}

TEST(GltfAnimation, StepsHoldTheirValue) {
    Curve curve;
    curve.interpolation = "STEP";
    expect_near(place(curve, 2.999), {1, 0, 0});
    expect_near(place(curve, 3.0), {2, 2, 3});
}

TEST(GltfAnimation, TurnsOnTheShorterArcAtEvenSpeed) {
    Curve curve;
    curve.path = "rotation";
    curve.type = "VEC4";
    // By 90 deg about z; the second quaternion with the other sign is the same rotation.
    for (const float sign : {1.0f, -1.0f}) {
        curve.values = bytes_of<float>({0, 0, 0, 1, 0, 0, sign * kHalfRoot, sign * kHalfRoot});
        for (const double share : {0.5, 1.0 / 3.0}) {
            const double angle = share * 1.57079632679489662;
            expect_near(place(curve, 1.0 + 2.0 * share), {std::cos(angle), std::sin(angle), 0});
        }
    }
}

/// Hermite's cubic at a quarter of the way, over 2 s, from 0 with slope 2 to 1 with slope 0:
/// 3/16 − 2/64 of the value, and (1/64 − 2/16 + 1/4) of 2 s times 2/s.
TEST(GltfAnimation, CubicSplinesHaveTangents) {
    Curve curve;
    curve.interpolation = "CUBICSPLINE";
    curve.values = bytes_of<float>({9, 9, 9, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0, 0, 9, 9, 9});
    curve.value_count = 6;
    expect_near(place(curve, 1.5), {1.0 + 0.15625 + 0.5625, 0, 0});
    expect_near(place(curve, 3.0), {2, 0, 0});
}

TEST(GltfAnimation, ScalesAndRestsWhereItDoesNotMove) {
    Curve curve;
    curve.path = "scale";
    curve.values = bytes_of<float>({1, 1, 1, 3, 3, 3});
    Parts parts = animated(curve);
    parts.nodes = R"([{"mesh": 0, "translation": [0, 7, 0], "scale": [9, 9, 9]}])";
    const ParsedScene parsed = parse(parts, 2.0);
    expect_near(parsed.scene.shapes.at(0).world_from_object(Point<Object>{{1, 0, 0}}).v, {2, 7, 0});
}

TEST(GltfAnimation, MovesCamerasAndLightsBelow) {
    Parts parts = animated({});
    parts.nodes =
        R"([{"children": [1]}, {"mesh": 0, "camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}])";
    parts.rest +=
        R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.01}}],
           "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}})";
    const ParsedScene parsed = parse(parts, 2.0);
    expect_near(parsed.scene.cameras.at(0).world_from_camera(Point<Camera>{{0, 0, 0}}).v,
                {0.5, 1, 1.5});
    expect_near(std::get<PointLight>(parsed.scene.lights.at(0)).position.v, {0.5, 1, 1.5});
}

TEST(GltfAnimation, WeighsMorphTargets) {
    Buffer buffer;
    const int up = buffer.add(bytes_of<float>({0, 0, 0, 0, 0, 0, 0, 0, 1}), "5126", 3, "VEC3");
    Curve curve;
    curve.path = "weights";
    curve.type = "SCALAR";
    curve.values = bytes_of<float>({0, 0.25f, 1, 0.75f});  // two targets each
    curve.value_count = 4;
    const std::string animation = animation_of(buffer, curve);
    const std::string target = R"({"POSITION": )" + std::to_string(up) + "}";
    Parts parts =
        buffer.parts(R"("POSITION": 0)", R"(, "targets": [)" + target + ", " + target + "]");
    parts.rest = R"(, "animations": [)" + animation + "]";
    const ParsedScene parsed = parse(parts, 2.0);
    expect_near(mesh_of(parsed.scene.shapes.at(0)).vertices.at(2).v, {0, 1, 0.5 + 0.5});
}

TEST(GltfAnimation, OfTwoThatMoveOneThingTheFirstCounts) {
    Buffer buffer;
    Curve other;
    other.values = bytes_of<float>({8, 8, 8, 8, 8, 8});
    const std::string animations =
        animation_of(buffer, {}, "walk") + ", " + animation_of(buffer, other, "run");
    Parts parts = buffer.parts(R"("POSITION": 0)");
    parts.rest = R"(, "animations": [)" + animations + "]";
    const ParsedScene parsed = parse(parts, 3.0);
    expect_near(parsed.scene.shapes.at(0).world_from_object(Point<Object>{{0, 0, 0}}).v, {1, 2, 3});
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "animation \"run\" moves what an earlier one moves, and is not used there");
}

TEST(GltfAnimation, WrongOnesAreErrorsWithTheirPlace) {
    struct Row {
        void (*change)(Curve&);
        const char* phrase;
    };
    const Row rows[] = {
        {[](Curve& c) { c.value_count = 1; },
         "/animations/0/samplers/0/output: there are 1 values for 2 times, 1 each"},
        {[](Curve& c) { c.interpolation = "CUBICSPLINE"; },
         "/output: there are 2 values for 2 times, 3 each"},
        {[](Curve& c) { c.interpolation = "BEZIER"; },
         "/interpolation: \"BEZIER\" is no way of interpolating"},
        {[](Curve& c) {
             c.times = bytes_of<float>({3, 1});
         },
         "/input: time 1 is 1 s; times grow"},
        {[](Curve& c) {
             c.times = bytes_of<float>({-1, 1});
         },
         "/input: time 0 is -1 s"},
        {[](Curve& c) {
             c.times = bytes_of<float>({std::numeric_limits<float>::quiet_NaN(), 1});
         },
         "/input: time 0 is nan s"},
        {[](Curve& c) { c.time_count = 0; }, "/input: there are no times"},
        {[](Curve& c) {
             c.values = bytes_of<float>({std::numeric_limits<float>::infinity(), 0, 0, 0, 0, 0});
         },
         "/output: its value at 2 s is inf"},
        {[](Curve& c) {
             c.path = "rotation";
             c.type = "VEC4";
             c.values = std::string(32, '\0');
         },
         "/nodes/0: is zero; a rotation is a unit quaternion"},
        {[](Curve& c) { c.path = "colour"; },
         "/target/path: \"colour\" is nothing that can be animated"},
        {[](Curve& c) { c.node = 9; }, "/target/node: is 9"},
        {[](Curve& c) { c.type = "SCALAR"; }, "/type: is SCALAR"},
    };
    for (const Row& row : rows) {
        Curve curve;
        row.change(curve);
        const std::string message = error_of(animated(curve), 2.0);
        EXPECT_NE(message.find(row.phrase), std::string::npos) << row.phrase << "\nis not in\n"
                                                               << message;
    }
}

}  // namespace
}  // namespace dewbow
