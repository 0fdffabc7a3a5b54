// SPDX-License-Identifier: Apache-2.0
#pragma once

// Scenes for tests, built by hand: bodies, meshes, lights, and rays through them.

#include <array>
#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "dewbow/math/sampling.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/render/path/path.h"
#include "dewbow/scene/scene.h"
#include "dewbow/spectrum/wavelengths.h"

namespace dewbow::kit {

using unit::deg;
using unit::m;

inline constexpr double kPi = std::numbers::pi;

// ---- media and materials -----------------------------------------------------------------------

inline MediumPtr medium(DispersionPtr index, SpectrumPtr absorption = nullptr, int priority = 0) {
    return std::make_shared<Medium>(
        Medium{"medium", std::move(index), std::move(absorption), priority});
}
inline MediumPtr glass(const char* name, SpectrumPtr absorption = nullptr, int priority = 0) {
    return medium(make_dispersion(find_glass(name).data), std::move(absorption), priority);
}
/// The same index at every wavelength.
inline MediumPtr plain(double n, SpectrumPtr absorption = nullptr, int priority = 0) {
    return medium(make_dispersion({"constant", {n}, IndexReference::vacuum}), std::move(absorption),
                  priority);
}
inline Material dielectric(MediumPtr interior, double roughness = 0.0) {
    return {"dielectric", Dielectric{std::move(interior), roughness, nullptr}, nullptr, false};
}
inline Material diffuse(double reflectance) {
    return {"diffuse", Diffuse{make_constant(reflectance)}, nullptr, false};
}
inline Material lamp(SpectrumPtr radiance, bool two_sided = false) {
    return {"lamp", Black{}, std::move(radiance), two_sided};
}
inline Material lamp(double radiance, bool two_sided = false) {
    return lamp(make_constant(radiance), two_sided);
}

/// Adds a shape of its own material and returns its index.
inline int add(Scene& scene, Geometry geometry, Material material, const Affine& place = {}) {
    const int id = scene.add(std::move(material));
    scene.shapes.push_back({"shape", std::move(geometry), Transform<World, Object>(place), id});
    return int(scene.shapes.size()) - 1;
}

/// A scene of nothing in a vacuum, whose paths never end by roulette.
inline Scene empty_scene(int max_depth = 100000) {
    Scene scene = make_empty_scene();
    scene.surroundings = medium(vacuum(), nullptr, -1000);
    scene.render.max_depth = max_depth;
    scene.render.roulette_depth = max_depth;
    return scene;
}
inline Scene furnace_scene(double radiance = 1.0) {
    Scene scene = empty_scene();
    scene.lights.push_back(UniformEnvironment{make_constant(radiance)});
    return scene;
}

// ---- meshes ------------------------------------------------------------------------------------

inline std::shared_ptr<const Mesh> mesh(std::vector<Vec3> vertices,
                                        std::vector<std::array<std::uint32_t, 3>> triangles) {
    auto result = std::make_shared<Mesh>();
    for (const Vec3 v : vertices) result->vertices.push_back({v});
    result->triangles = std::move(triangles);
    return result;
}

inline std::shared_ptr<const Mesh> box_mesh(Vec3 size) {
    std::vector<Vec3> corner;
    for (int i = 0; i < 8; ++i)
        corner.push_back({size.x * ((i & 1) - 0.5), size.y * ((i >> 1 & 1) - 0.5),
                          size.z * ((i >> 2 & 1) - 0.5)});
    return mesh(corner, {{0, 4, 6},
                         {0, 6, 2},
                         {1, 3, 7},
                         {1, 7, 5},
                         {0, 1, 5},
                         {0, 5, 4},
                         {2, 6, 7},
                         {2, 7, 3},
                         {0, 2, 3},
                         {0, 3, 1},
                         {4, 5, 7},
                         {4, 7, 6}});
}

/// As Prism: apex at +y, centroid at the origin, along z.
inline std::shared_ptr<const Mesh> prism_mesh(double apex_rad, double side, double length) {
    const double height = side * std::cos(0.5 * apex_rad), half = side * std::sin(0.5 * apex_rad);
    std::vector<Vec3> v;
    for (const double z : {-0.5 * length, 0.5 * length}) {
        v.push_back({0.0, 2.0 / 3.0 * height, z});
        v.push_back({-half, -height / 3.0, z});
        v.push_back({half, -height / 3.0, z});
    }
    return mesh(
        v,
        {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}});
}

/// An icosahedron whose triangles are split `levels` times, blown up to `radius`.
inline std::shared_ptr<const Mesh> sphere_mesh(double radius, int levels, bool smooth = false) {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    std::vector<Vec3> v{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                        {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<std::array<std::uint32_t, 3>> t{
        {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int level = 0; level < levels; ++level) {
        std::vector<std::array<std::uint32_t, 3>> finer;
        std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> middles(v.size());
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            if (a > b) std::swap(a, b);
            for (const auto& [other, at] : middles[a])
                if (other == b) return at;
            v.push_back(0.5 * (v[a] + v[b]));
            middles[a].push_back({b, std::uint32_t(v.size() - 1)});
            return std::uint32_t(v.size() - 1);
        };
        for (const auto& [a, b, c] : t) {
            const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.push_back({a, ab, ca});
            finer.push_back({ab, b, bc});
            finer.push_back({ca, bc, c});
            finer.push_back({ab, bc, ca});
        }
        t = std::move(finer);
        for (Vec3& p : v) p = normalised(p);
    }
    for (Vec3& p : v) p = radius * normalised(p);
    auto result = std::make_shared<Mesh>(*mesh(v, std::move(t)));
    if (smooth)
        for (const Vec3 p : v) result->normals.push_back({normalised(p)});
    return result;
}

/// The v and f lines of an OBJ file, polygons as fans.
inline std::shared_ptr<const Mesh> read_obj(const std::string& path) {
    std::ifstream file(path);
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 v;
            words >> v.x >> v.y >> v.z;
            vertices.push_back(v);
        } else if (kind == "f") {
            std::vector<std::uint32_t> corner;
            for (std::string word; words >> word;)
                corner.push_back(std::uint32_t(std::stoul(word)) - 1u);
            for (std::size_t i = 2; i < corner.size(); ++i)
                triangles.push_back({corner[0], corner[i - 1], corner[i]});
        }
    }
    return mesh(std::move(vertices), std::move(triangles));
}

/// The round brilliant of examples/.
inline std::shared_ptr<const Mesh> brilliant() {
    return read_obj(DEWBOW_SOURCE_DIR "/examples/brilliant.obj");
}

// ---- samples -----------------------------------------------------------------------------------

/// Random numbers of their own for each i: samples are independent, as z- and T²-tests want them.
inline SampleKey independent_key(std::uint64_t seed, std::size_t i) {
    return {stream_key(seed, std::uint32_t(i), std::uint32_t(i >> 32)), 0};
}
/// Numbers that the tracer does not use.
inline std::array<double, 2> test_numbers(const SampleKey& key, std::uint32_t which) {
    return key.two(0x40000000u + which, Purpose::test);
}

/// A ray from a random point at `distance` from the origin to a random point of the ball of
/// `radius` there.
inline Ray ray_to_ball(const SampleKey& key, double distance, double radius) {
    const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
    const Vec3 origin = distance * sample_uniform_sphere<World>(a[0], a[1]).v;
    const Vec3 target =
        radius * std::cbrt(test_numbers(key, 2)[0]) * sample_uniform_sphere<World>(b[0], b[1]).v;
    return {origin, normalised(target - origin), {}};
}

inline WavelengthPacket packet_of(const SampleKey& key, int count,
                                  WavelengthSampling sampling = WavelengthSampling::visual) {
    return sample_wavelengths(sampling, count, key.one(0, Purpose::wavelength));
}
/// One wavelength alone.
inline WavelengthPacket one_wavelength(double lambda_nm) {
    WavelengthPacket packet;
    packet.count = 1;
    packet.lambda_nm[0] = lambda_nm;
    packet.pdf_per_nm[0] = 1.0;
    return packet;
}
/// `lambda_nm` in lane `lane`, and others of the visible range around it.
inline WavelengthPacket among_others(double lambda_nm, int count, int lane) {
    WavelengthPacket packet;
    packet.count = count;
    const double range = kLambdaMax_nm - kLambdaMin_nm;
    for (int k = 0; k < count; ++k) {
        double there = lambda_nm + range * double(k - lane) / double(count);
        if (there > kLambdaMax_nm) there -= range;
        if (there < kLambdaMin_nm) there += range;
        packet.lambda_nm[std::size_t(k)] = there;
        packet.pdf_per_nm[std::size_t(k)] = 1.0 / range;
    }
    return packet;
}

inline double index_of(const Medium& medium, double lambda_nm) {
    return (*medium.index)(lambda_nm * unit::nm).value;
}

/// Calls body(chunk, first, end) for `chunks` equal parts of [0, count), on all threads. What the
/// chunks find is put together in their order, so that it does not depend on the threads.
template <class Body>
void in_chunks(std::size_t count, std::size_t chunks, Body&& body) {
    parallel_for(chunks, [&](std::size_t chunk) {
        body(chunk, count * chunk / chunks, count * (chunk + 1) / chunks);
    });
}

}  // namespace dewbow::kit
