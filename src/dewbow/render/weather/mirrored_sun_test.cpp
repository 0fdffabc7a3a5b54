// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/mirrored_sun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "dewbow/optics/catalogue.h"
#include "dewbow/render/prepared_scene.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Ways of some 100 m, over cosines of a hundredth at least.
constexpr double kRounding_m = 1e-9;

Dir<World> sun_at(Angle altitude, Angle azimuth) {
    return {{sin(azimuth) * cos(altitude), sin(altitude), -cos(azimuth) * cos(altitude)}};
}

MediumPtr water() {
    Medium medium;
    medium.name = "water";
    medium.index = make_dispersion(find_glass("water@20C").data);
    return std::make_shared<const Medium>(std::move(medium));
}

/// A lake of the shape given, its surface at y = 2.
Scene lake(Geometry geometry, double depth = 0.0) {
    Scene scene = make_empty_scene();
    const int material = scene.add({"water", Dielectric{water()}, {}});
    const Affine place =
        translation({0, 2.0 - depth, 0}) *
        (std::holds_alternative<Box>(geometry) ? Affine{} : rotation({1, 0, 0}, -90.0 * deg));
    scene.shapes.push_back(
        {"lake", std::move(geometry), Transform<World, Object>(place), material});
    return scene;
}

Shape box_at(Vec3 centre, double size, int material) {
    return {"box", Box{size * m, size * m, size * m}, Transform<World, Object>(translation(centre)),
            material};
}

MeshRegion box_mesh(Vec3 low, Vec3 high) {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.vertices.push_back({{corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                  corner & 4 ? high.z : low.z}});
    }
    const std::array<std::array<std::uint32_t, 4>, 6> sides{
        {{0, 2, 6, 4}, {1, 5, 7, 3}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 6, 7, 5}}};
    for (const auto& s : sides) {
        mesh.triangles.push_back({s[0], s[1], s[2]});
        mesh.triangles.push_back({s[0], s[2], s[3]});
    }
    return {std::make_shared<const Mesh>(std::move(mesh)), {}};
}

TEST(LevelMirrors, AreFoundWhereWaterLies) {
    EXPECT_EQ(level_mirrors(lake(Plane{})), std::vector<double>{2.0});
    EXPECT_EQ(level_mirrors(lake(Disc{5.0 * m})), std::vector<double>{2.0});
    EXPECT_EQ(level_mirrors(lake(Box{4.0 * m, 1.0 * m, 4.0 * m}, 0.5)), std::vector<double>{2.0});
    EXPECT_TRUE(level_mirrors(lake(Sphere{1.0 * m})).empty());
    Scene rough = lake(Plane{});
    std::get<Dielectric>(rough.materials[0].surface).roughness = 0.1;
    EXPECT_TRUE(level_mirrors(rough).empty());
    Scene both = lake(Disc{5.0 * m});  // the larger one first
    both.add({"mirror", Mirror{make_constant(0.9)}, {}});
    both.shapes.push_back(box_at({20, 0, 0}, 20.0, 1));
    EXPECT_EQ(level_mirrors(both), (std::vector<double>{10.0, 2.0}));
}

TEST(LevelMirrors, TiltedWaterMirrorsElsewhere) {
    Scene scene = lake(Plane{});
    scene.shapes[0].world_from_object = Transform<World, Object>(rotation({1, 0, 0}, -89.99 * deg));
    EXPECT_TRUE(level_mirrors(scene).empty());
}

// Both legs from every point on its own.
TEST(MirroredSun, WaysInRainAreThoseOfBothLegs) {
    const MirroredSun sun(sun_at(25.0 * deg, 70.0 * deg), 2.0);
    const Vec3 low{-8, -1, -9}, high{9, 12, 10};
    const Transform<World, Object> place(translation(0.5 * (low + high)));
    const std::vector<std::variant<ConvexRegion, MeshRegion>> regions = {
        ConvexRegion::layer(-3.0 * m, 12.0 * m), ConvexRegion::box(place, 0.5 * (high - low)),
        box_mesh(low, high)};
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double longest = 0.0;
    for (const auto& region : regions) {
        const RainInside rain({"r", region, nullptr, {}});
        for (int i = 0; i < 200; ++i) {
            const Point<World> from{{10 * unit(random), 8 + 5 * unit(random), 10 * unit(random)}};
            const Dir<World> d{normalised({unit(random), unit(random), unit(random)})};
            const auto on = sun.above(from, d, {0.5, 20.0});
            if (!on) continue;
            std::vector<LengthPiece> pieces;
            sun.lengths(rain, from, d, *on, pieces);
            ASSERT_FALSE(pieces.empty());
            EXPECT_EQ(pieces.front().begin, on->begin);
            EXPECT_EQ(pieces.back().end, on->end);
            for (const LengthPiece& piece : pieces) {
                const double s = 0.3 * piece.begin + 0.7 * piece.end;
                const Point<World> p = along(from, d, s);
                const double way = (p.v.y - 2.0) / -sun.direction().v.y;
                const Dir<World> up{
                    {sun.direction().v.x, -sun.direction().v.y, sun.direction().v.z}};
                const double expected =
                    rain.length_inside(p, sun.direction(), way) +
                    rain.length_inside(along(p, sun.direction(), way), up, kInfinity);
                EXPECT_NEAR(piece.length + piece.slope * (s - piece.begin), expected, kRounding_m);
                longest = std::max(longest, expected);
            }
        }
    }
    EXPECT_GT(longest, 30.0);
}

// In rain without end sunlight comes undimmed to the water, and dimmed from there on.
TEST(MirroredSun, EndlessRainDimsOnTheWayUp) {
    const MirroredSun sun(sun_at(30.0 * deg, 0.0 * deg), 0.0);
    std::vector<LengthPiece> pieces;
    const RainInside rain({"r", ConvexRegion::everywhere(), nullptr, {}});
    sun.lengths(rain, {{0, 10, 0}}, {{0, 1, 0}}, {0.0, 5.0}, pieces);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_NEAR(pieces[0].length, 20.0, kRounding_m);  // 10 m / sin 30°
    EXPECT_NEAR(pieces[0].slope, 2.0, kRounding_m);
}

// One looks at the image itself, or away from it: all light comes from one place of the mirror.
TEST(MirroredSun, LookingAlongTheLight) {
    const MirroredSun sun(sun_at(30.0 * deg, 0.0 * deg), 0.0);
    const RainInside rain({"r", ConvexRegion::layer(0.0 * m, 20.0 * m), nullptr, {}});
    for (const double side : {1.0, -1.0}) {
        const Dir<World> d{side * sun.direction().v};
        std::vector<LengthPiece> pieces;
        sun.lengths(rain, {{0, 10, 0}}, d, {0.0, 8.0}, pieces);
        ASSERT_EQ(pieces.size(), 1u);
        EXPECT_NEAR(pieces[0].length, 20.0 + 40.0, kRounding_m);
        EXPECT_NEAR(pieces[0].slope, -side, kRounding_m);
    }
}

struct Looks {
    explicit Looks(const Scene& scene) : prepared(scene), media(prepared.media) {
        packet.count = 4;
        for (int k = 0; k < 4; ++k) packet.lambda_nm[std::size_t(k)] = 450.0 + 60.0 * k;
        media.begin(packet);
    }
    std::optional<ReflectanceLanes> at(Vec3 point, Dir<World> to_sun, double height = 2.0) {
        return MirroredSun(to_sun, height)
            .reflect(prepared, {point}, to_sun, SampleKey(0, 0), 0, LaneSet::all(packet), media);
    }
    PreparedScene prepared;
    WavelengthPacket packet;
    PacketMedia media;
};

TEST(MirroredSun, WaterMirrorsAsFresnelSays) {
    const Scene scene = lake(Plane{});
    Looks looks(scene);
    for (const double altitude_deg : {2.0, 10.0, 37.0, 80.0}) {
        const auto shares = looks.at({1, 9, 3}, sun_at(altitude_deg * deg, 40.0 * deg));
        ASSERT_TRUE(shares);
        for (int k = 0; k < 4; ++k) {
            const double n =
                looks.media.index(looks.prepared.media.interior_of(0))[std::size_t(k)] /
                looks.media.index(0)[std::size_t(k)];
            // By the tangent and sine of sum and difference.    [Born & Wolf §1.5.2, eqs. 21a, 21b]
            const double i = (90.0 - altitude_deg) * deg.to(rad), t = std::asin(std::sin(i) / n);
            const double s = std::sin(i - t) / std::sin(i + t),
                         p = std::tan(i - t) / std::tan(i + t);
            EXPECT_NEAR((*shares)[std::size_t(k)].perpendicular, s * s, 1e-12);
            EXPECT_NEAR((*shares)[std::size_t(k)].parallel, p * p, 1e-12);
        }
    }
}

TEST(MirroredSun, WhatStandsInTheWayShadows) {
    const Dir<World> sun = sun_at(30.0 * deg, 90.0 * deg);  // in the east, +x
    const Vec3 point{0, 7, 0};  // its light leaves the water at x = 5 / tan 30°
    const double x = 5.0 * std::sqrt(3.0);
    Scene scene = lake(Plane{});
    const int black = scene.add({"black", Black{}, {}});
    EXPECT_TRUE(Looks(scene).at(point, sun));
    EXPECT_FALSE(Looks(scene).at(point, sun, 1.5));  // no mirror at that height
    EXPECT_FALSE(Looks(scene).at({0, 1, 0}, sun));   // under water
    for (const double part : {0.5, 2.0}) {           // before the water; between it and the sun
        Scene shadowed = scene;
        const double height = 2.0 + 5.0 * std::abs(1.0 - part);
        shadowed.shapes.push_back(box_at({part * x, height, 0}, 0.5, black));
        EXPECT_FALSE(Looks(shadowed).at(point, sun)) << part;
        shadowed.shapes.back() = box_at({part * x, height, 1.0}, 0.5, black);
        EXPECT_TRUE(Looks(shadowed).at(point, sun)) << part;
    }
    Scene island = scene;  // the mirror's place is dry
    island.shapes.push_back(box_at({x, 2.0, 0}, 0.5, black));
    EXPECT_FALSE(Looks(island).at(point, sun));
}

/// The field of light that a mirror has polarised, taken apart along the axes of scattering.
double by_fields(Vec3 from_sun_after_mirror, Reflectance<double> r, Intensities phase, Vec3 out) {
    const Vec3 s = normalised(cross(from_sun_after_mirror, {0, 1, 0}));
    const Vec3 p = cross(s, from_sun_after_mirror);
    const Vec3 perpendicular = normalised(cross(from_sun_after_mirror, out));
    const Vec3 parallel = cross(perpendicular, from_sun_after_mirror);
    const auto scattered = [&](Vec3 field) {
        return phase.perpendicular * std::pow(dot(field, perpendicular), 2) +
               phase.parallel * std::pow(dot(field, parallel), 2);
    };
    return 0.5 * (r.perpendicular * scattered(s) + r.parallel * scattered(p));
}

double scattered(Reflectance<double> light, Intensities phase) {
    return 0.5 * (light.perpendicular * phase.perpendicular + light.parallel * phase.parallel);
}

TEST(MirroredSun, PolarisationGoesOnIntoTheDrops) {
    const MirroredSun sun(sun_at(20.0 * deg, 130.0 * deg), 0.0);
    const Reflectance<double> r{0.1, 0.6};
    const Intensities phase{0.05, 0.002};
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double least = 1.0, most = 0.0;
    for (int i = 0; i < 100; ++i) {
        const Vec3 out = normalised({unit(random), unit(random), unit(random)});
        const double expected = by_fields(-sun.direction().v, r, phase, out);
        const double found = scattered(sun.turned(r, {out}), phase);
        EXPECT_NEAR(found, expected, 1e-14);
        least = std::min(least, found), most = std::max(most, found);
    }
    EXPECT_GT(most / least, 3.0);  // it does matter
    EXPECT_NEAR(sun.turned(r, {-sun.direction().v}).perpendicular, 0.35, 1e-15);
    EXPECT_NEAR(sun.turned({0.3, 0.3}, {normalised({1, 2, 3})}).parallel, 0.3, 1e-15);
}

}  // namespace
}  // namespace dewbow
