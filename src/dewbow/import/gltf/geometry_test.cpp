// SPDX-License-Identifier: Apache-2.0

// Triangles, transforms, lights and cameras of glTF files.

#include <gtest/gtest.h>

#include "dewbow/import/gltf/test_document.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace gltf_test;

/// Rounding of a handful of multiplications by numbers near 1, in double.
constexpr double kRounding = 1e-12;

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, kRounding);
    EXPECT_NEAR(a.y, b.y, kRounding);
    EXPECT_NEAR(a.z, b.z, kRounding);
}

/// Corner `corner` of triangle `triangle` in the world.
Vec3 corner(const Shape& shape, std::size_t triangle, std::size_t corner) {
    const Mesh& mesh = mesh_of(shape);
    return shape.world_from_object(mesh.vertices[mesh.triangles[triangle][corner]]).v;
}

/// By the winding in the world.
Vec3 world_normal(const Shape& shape, std::size_t triangle) {
    const Vec3 a = corner(shape, triangle, 0);
    return normalised(cross(corner(shape, triangle, 1) - a, corner(shape, triangle, 2) - a));
}

/// Four corners of the unit square for strips and fans, no indices.
Parts square(const char* mode, std::initializer_list<float> positions) {
    Parts parts;
    parts.bytes = bytes_of<float>(positions);
    parts.views = R"([{"buffer": 0, "byteLength": )" + std::to_string(parts.bytes.size()) + "}]";
    parts.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": )" +
                      std::to_string(parts.bytes.size() / 12) + R"(, "type": "VEC3"}])";
    parts.primitive = R"({"attributes": {"POSITION": 0}, "mode": )" + std::string(mode) + "}";
    return parts;
}

TEST(GltfGeometry, ReadsTheTriangle) {
    const ParsedScene parsed = parse({});
    ASSERT_EQ(parsed.scene.shapes.size(), 1u);
    const Mesh& mesh = mesh_of(parsed.scene.shapes[0]);
    EXPECT_EQ(mesh.vertices.size(), 3u);
    EXPECT_TRUE(mesh.normals.empty());
    expect_near(corner(parsed.scene.shapes[0], 0, 1), {1, 0, 0});
    expect_near(world_normal(parsed.scene.shapes[0], 0), {0, 0, 1});
    EXPECT_TRUE(parsed.scene.cameras.empty());
}

TEST(GltfGeometry, StripsAndFansKeepOneFace) {
    // Two triangles of the unit square, both towards +z.
    const Parts strip = square("5", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    const Parts fan = square("6", {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    for (const Parts& parts : {strip, fan}) {
        const ParsedScene parsed = parse(parts);
        const Shape& shape = parsed.scene.shapes.at(0);
        ASSERT_EQ(mesh_of(shape).triangles.size(), 2u);
        double area = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            expect_near(world_normal(shape, i), {0, 0, 1});
            area += 0.5 * length(cross(corner(shape, i, 1) - corner(shape, i, 0),
                                       corner(shape, i, 2) - corner(shape, i, 0)));
        }
        EXPECT_NEAR(area, 1.0, kRounding);
    }
}

TEST(GltfGeometry, LinesAreNotedAndNotShown) {
    const ParsedScene parsed = parse(square("1", {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}));
    EXPECT_TRUE(parsed.scene.shapes.empty());
    ASSERT_EQ(parsed.diagnostics.size(), 2u);
    EXPECT_EQ(parsed.diagnostics[0].text, "points and lines of mesh \"mesh 0\" are not shown");
}

TEST(GltfGeometry, IndicesOfAllTypes) {
    struct Type {
        const char* number;
        std::string bytes;
    };
    const Type types[] = {{"5121", bytes_of<std::uint8_t>({2, 0, 1, 9})},
                          {"5123", bytes_of<std::uint16_t>({2, 0, 1, 9})},
                          {"5125", bytes_of<std::uint32_t>({2, 0, 1, 9})}};
    for (const Type& type : types) {
        Parts parts;
        parts.bytes = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + type.bytes;
        parts.views =
            R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": )" +
            std::to_string(type.bytes.size()) + "}]";
        parts.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": )" +
                          std::string(type.number) + R"(, "count": 3, "type": "SCALAR"}])";
        const ParsedScene parsed = parse(parts);
        expect_near(corner(parsed.scene.shapes.at(0), 0, 0), {0, 1, 0});
        expect_near(corner(parsed.scene.shapes.at(0), 0, 2), {1, 0, 0});
    }
}

TEST(GltfGeometry, InterleavedWithNormals) {
    Parts parts;
    parts.bytes = bytes_of<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0});
    parts.views = R"([{"buffer": 0, "byteLength": 72, "byteStride": 24}])";
    parts.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 12, "componentType": 5126, "count": 3, "type": "VEC3"}])";
    parts.primitive = R"({"attributes": {"POSITION": 0, "NORMAL": 1}})";
    const ParsedScene parsed = parse(parts);
    const Mesh& mesh = mesh_of(parsed.scene.shapes.at(0));
    ASSERT_EQ(mesh.normals.size(), 3u);
    for (const auto& normal : mesh.normals) expect_near(normal.v, {0, 0, 1});
    // The third was zero in the file.
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text, "renewed 1 normals without direction");
}

TEST(GltfGeometry, SparseAccessorsChangeSomeElements) {
    Parts parts;
    parts.bytes += bytes_of<std::uint32_t>({2}) + bytes_of<float>({0, 5, 0});
    parts.views =
        R"([{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
        {"buffer": 0, "byteOffset": 44, "byteLength": 4}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}])";
    parts.accessors = R"([{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "sparse": {"count": 1, "indices": {"bufferView": 2, "componentType": 5125}, "values": {"bufferView": 3}}},
        {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}])";
    expect_near(corner(parse(parts).scene.shapes.at(0), 0, 2), {0, 5, 0});
}

TEST(GltfGeometry, BadTrianglesAreDroppedAndCounted) {
    Parts parts = square("4", {0, 0, 0, 1, 0, 0, 0, 1,
                               0,  // good
                               0, 0, 0, 1, 0, 0, 2, 0,
                               0,  // a line
                               0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::quiet_NaN(),
                               0});
    const ParsedScene parsed = parse(parts);
    EXPECT_EQ(mesh_of(parsed.scene.shapes.at(0)).triangles.size(), 1u);
    ASSERT_EQ(parsed.diagnostics.size(), 2u);
    EXPECT_EQ(parsed.diagnostics[0].text, "dropped 1 triangles with a vertex that is not finite");
    EXPECT_EQ(parsed.diagnostics[1].text, "dropped 1 triangles without area");
}

// ---- nodes -------------------------------------------------------------------------------------

TEST(GltfNodes, TransformsReadFromRightToLeft) {
    Parts parts;
    // Scaled by 2, turned 90 deg about z, moved by 1 in x; below a node that moves by 10 in y.
    parts.nodes = R"([{"translation": [0, 10, 0], "children": [1]},
        {"mesh": 0, "translation": [1, 0, 0], "rotation": [0, 0, 0.70710678118654752, 0.70710678118654752],
         "scale": [2, 2, 2]}])";
    const ParsedScene parsed = parse(parts);
    expect_near(corner(parsed.scene.shapes.at(0), 0, 0), {1, 10, 0});
    expect_near(corner(parsed.scene.shapes.at(0), 0, 1), {1, 12, 0});
    expect_near(corner(parsed.scene.shapes.at(0), 0, 2), {-1, 10, 0});
}

TEST(GltfNodes, MatricesAreColumnMajor) {
    Parts parts;
    parts.nodes = R"([{"mesh": 0, "matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1]}])";
    const ParsedScene parsed = parse(parts);
    expect_near(corner(parsed.scene.shapes.at(0), 0, 0), {5, 6, 7});
    expect_near(corner(parsed.scene.shapes.at(0), 0, 1), {5, 7, 7});
}

TEST(GltfNodes, MirroredMeshesKeepTheirFrontOutside) {
    Parts parts;
    parts.roots = "[0, 1, 2, 3]";
    parts.nodes =
        R"([{"mesh": 0}, {"mesh": 0, "scale": [-1, 1, 1]}, {"mesh": 0, "scale": [1, 1, -1]},
                      {"mesh": 0, "scale": [-2, -3, 1]}])";
    const ParsedScene parsed = parse(parts);
    ASSERT_EQ(parsed.scene.shapes.size(), 4u);
    // The front of the triangle is what lies at +z of it: a mirror image in z puts it at −z.
    const Vec3 expected[] = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, 1}};
    const Vec3 second[] = {{1, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {-2, 0, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Shape& shape = parsed.scene.shapes[i];
        EXPECT_GT(shape.world_from_object.affine().determinant(), 0.0);
        expect_near(world_normal(shape, 0), expected[i]);
        bool found = false;
        for (std::size_t c = 0; c < 3; ++c)
            found = found || length(corner(shape, 0, c) - second[i]) < kRounding;
        EXPECT_TRUE(found) << "shape " << i;
    }
    // Plain instances share one mesh, mirrored ones another.
    EXPECT_EQ(&mesh_of(parsed.scene.shapes[0]), &mesh_of(parsed.scene.shapes[3]));
    EXPECT_EQ(&mesh_of(parsed.scene.shapes[1]), &mesh_of(parsed.scene.shapes[2]));
}

TEST(GltfNodes, FlattenedMeshesStayVisible) {
    Parts parts;
    parts.roots = "[0, 1]";
    parts.nodes =
        R"([{"mesh": 0, "scale": [3, 1, 0]}, {"name": "gone", "mesh": 0, "scale": [0, 1, 1]}])";
    const ParsedScene parsed = parse(parts);
    ASSERT_EQ(parsed.scene.shapes.size(), 1u);
    expect_near(corner(parsed.scene.shapes[0], 0, 1), {3, 0, 0});
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "nothing is shown of node \"gone\": it is scaled to nothing");
}

// ---- lights and cameras ------------------------------------------------------------------------

Parts with_light(const std::string& light, const std::string& node) {
    Parts parts;
    parts.roots = "[0, 1]";
    parts.nodes =
        R"([{"mesh": 0}, {)" + node + R"("extensions": {"KHR_lights_punctual": {"light": 0}}}])";
    parts.rest = R"(, "extensions": {"KHR_lights_punctual": {"lights": [)" + light + "]}}";
    return parts;
}

double photometric(const SpectrumPtr& spectrum) {
    return kLuminousEfficacy * xyz_from_spectrum(*spectrum)[1];
}

TEST(GltfLights, DirectionalShinesAlongMinusZInLux) {
    // Turned by −90 deg about x: −z becomes −y.
    const auto parsed =
        parse(with_light(R"({"type": "directional", "intensity": 100})",
                         R"("rotation": [-0.70710678118654752, 0, 0, 0.70710678118654752],)"));
    const auto& light = std::get<DistantLight>(parsed.scene.lights.at(0));
    expect_near(light.direction.v, {0, -1, 0});
    EXPECT_NEAR(light.angular_radius.to(unit::deg), 0.2666, 1e-9);  // the sun's
    EXPECT_NEAR(photometric(light.irradiance), 100.0, 0.1);
}

TEST(GltfLights, PointAndSpotAreInCandela) {
    const auto point = parse(with_light(R"({"type": "point", "color": [1, 1, 1], "intensity": 7})",
                                        R"("translation": [1, 2, 3], "scale": [5, 5, 5],)"));
    const auto& bulb = std::get<PointLight>(point.scene.lights.at(0));
    expect_near(bulb.position.v, {1, 2, 3});
    EXPECT_NEAR(photometric(bulb.intensity), 7.0, 7e-3);

    const auto spot = parse(with_light(
        R"({"type": "spot", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}})", ""));
    const auto& lamp = std::get<SpotLight>(spot.scene.lights.at(0));
    EXPECT_NEAR(lamp.inner.to(unit::rad), 0.1, kRounding);
    EXPECT_NEAR(lamp.outer.to(unit::rad), 0.2, kRounding);
    expect_near(lamp.direction.v, {0, 0, -1});
}

TEST(GltfLights, ColourWeighsTheSize) {
    const auto parsed =
        parse(with_light(R"({"type": "point", "color": [0, 1, 0], "intensity": 10})", ""));
    // Rec.709's green has 0.7152 of white's luminance.
    EXPECT_NEAR(photometric(std::get<PointLight>(parsed.scene.lights.at(0)).intensity), 7.152,
                0.05);
}

TEST(GltfLights, DarkOnesAreNoLight) {
    EXPECT_TRUE(parse(with_light(R"({"type": "point", "intensity": 0})", "")).scene.lights.empty());
}

TEST(GltfLights, WrongOnesAreErrors) {
    EXPECT_NE(
        error_of(with_light(R"({"type": "area"})", "")).find("unknown type of light \"area\""),
        std::string::npos);
    EXPECT_NE(
        error_of(
            with_light(R"({"type": "spot", "spot": {"innerConeAngle": 1, "outerConeAngle": 0.5}})",
                       ""))
            .find("/extensions/KHR_lights_punctual/lights/0/spot/innerConeAngle: is 1"),
        std::string::npos);
    EXPECT_NE(
        error_of(with_light(R"({"type": "point", "intensity": -1})", "")).find("intensity: is -1"),
        std::string::npos);
}

TEST(GltfCameras, OrthographicOnesStateHalfTheirHeight) {
    Parts parts;
    parts.roots = "[0, 1]";
    parts.nodes = R"([{"mesh": 0}, {"camera": 0}])";
    parts.rest = R"(, "cameras": [{"type": "orthographic",
        "orthographic": {"xmag": 2.0, "ymag": 1.5, "zfar": 10, "znear": 0.01}}])";
    const ParsedScene parsed = parse(parts);
    ASSERT_EQ(parsed.scene.cameras.size(), 1u);
    EXPECT_EQ(std::get<Orthographic>(parsed.scene.cameras[0].projection).height.to(unit::m), 3.0);
}

TEST(GltfCameras, LookAlongMinusZWhateverTheScale) {
    Parts parts;
    parts.roots = "[0, 1]";
    parts.nodes = R"([{"mesh": 0}, {"camera": 0, "translation": [0, 1, 6], "scale": [-2, 3, 4]}])";
    parts.rest =
        R"(, "cameras": [{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.01}}])";
    const ParsedScene parsed = parse(parts);
    ASSERT_EQ(parsed.scene.cameras.size(), 1u);
    const CameraView& camera = parsed.scene.cameras[0];
    const auto& world_from_camera = camera.world_from_camera;
    expect_near(world_from_camera(Point<Camera>{{0, 0, 0}}).v, {0, 1, 6});
    expect_near(world_from_camera(Dir<Camera>{{0, 0, -1}}).v, {0, 0, -1});
    expect_near(world_from_camera(Dir<Camera>{{1, 0, 0}}).v, {1, 0, 0});
    EXPECT_NEAR(std::get<Perspective>(camera.projection).vertical_field_of_view.to(unit::rad), 0.5,
                kRounding);
}

}  // namespace
}  // namespace dewbow
