// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

/// Rounding of a few operations on numbers near 1.
constexpr double kRounding = 1e-12;

Shape shape_of(Geometry geometry, const Affine& affine = {}) {
    return {"thing", std::move(geometry), Transform<World, Object>(affine), 0};
}

MediumPtr hazy(Medium medium, double scattering, PhaseFunctionPtr phase) {
    medium.scattering = make_constant(scattering);
    medium.phase = std::move(phase);
    return std::make_shared<Medium>(std::move(medium));
}

void expect_bounds(const Bounds& bounds, Vec3 low, Vec3 high) {
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(bounds.low[axis], low[axis], kRounding) << "axis " << axis;
        EXPECT_NEAR(bounds.high[axis], high[axis], kRounding) << "axis " << axis;
    }
}

TEST(Bounds, OfEachShape) {
    using namespace unit;
    expect_bounds(bounds_of(shape_of(Sphere{2.0 * m})), {-2, -2, -2}, {2, 2, 2});
    expect_bounds(bounds_of(shape_of(Disc{2.0 * m})), {-2, -2, 0}, {2, 2, 0});
    expect_bounds(bounds_of(shape_of(Rectangle{2.0 * m, 4.0 * m})), {-1, -2, 0}, {1, 2, 0});
    expect_bounds(bounds_of(shape_of(Box{2.0 * m, 4.0 * m, 6.0 * m})), {-1, -2, -3}, {1, 2, 3});
    // Equilateral, side 1: height √3/2, centroid at a third of it.
    const double height = std::sqrt(3.0) / 2.0;
    expect_bounds(bounds_of(shape_of(Prism{60.0 * deg, 1.0 * m, 3.0 * m})),
                  {-0.5, -height / 3, -1.5}, {0.5, height * 2 / 3, 1.5});
    EXPECT_TRUE(bounds_of(shape_of(Plane{})).empty());
}

TEST(Bounds, OfTurnedRoundShapesAreTight) {
    using namespace unit;
    const Affine turned = translation({5, 0, 0}) * rotation({1, 0, 0}, 30.0 * deg);
    // A ball turned is the same ball; the box around its box would not be.
    expect_bounds(bounds_of(shape_of(Sphere{1.0 * m}, turned)), {4, -1, -1}, {6, 1, 1});
    expect_bounds(bounds_of(shape_of(Disc{1.0 * m}, turned)),
                  {4, -std::cos(std::numbers::pi / 6), -0.5},
                  {6, std::cos(std::numbers::pi / 6), 0.5});
    expect_bounds(bounds_of(shape_of(Sphere{1.0 * m}, scaling({1, 2, 3}))), {-1, -2, -3},
                  {1, 2, 3});
}

TEST(Bounds, OfASceneLeaveOutPlanes) {
    Scene scene = make_empty_scene();
    scene.shapes = {shape_of(Plane{}), shape_of(Sphere{1.0 * unit::m}, translation({10, 0, 0}))};
    expect_bounds(bounds_of(scene), {9, -1, -1}, {11, 1, 1});
    scene.shapes.resize(1);
    EXPECT_TRUE(bounds_of(scene).empty());
    EXPECT_EQ(bounds_of(scene).radius(), 0.0);
}

// All corners of the bounds fall into the picture, whatever its shape.
TEST(FrameBounds, HoldsThemWholly) {
    Bounds bounds;
    bounds.add({-3, 0, 1});
    bounds.add({5, 2, 4});
    for (const double aspect : {0.25, 1.0, 16.0 / 9.0, 4.0}) {
        const CameraView camera = frame_bounds(bounds, aspect);
        const auto camera_from_world = camera.world_from_camera.inverse();
        const double half_height =
            tan(std::get<Perspective>(camera.projection).vertical_field_of_view / 2.0);
        double widest = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p =
                camera_from_world(Point<World>{{corner & 1 ? 5.0 : -3.0, corner & 2 ? 2.0 : 0.0,
                                                corner & 4 ? 4.0 : 1.0}})
                    .v;
            ASSERT_LT(p.z, 0.0);
            widest = std::max({widest, std::abs(p.x / p.z) / (half_height * aspect),
                               std::abs(p.y / p.z) / half_height});
        }
        EXPECT_LT(widest, 1.0) << aspect;
        EXPECT_GT(widest, 0.3) << aspect;  // and does not look at it from far away
    }
    // Nothing to see is no reason to fail.
    EXPECT_TRUE(is_finite(frame_bounds({}, 1.0).world_from_camera.affine().apply({})));
}

TEST(EmptyScene, IsInAirOfTheLowestPriority) {
    const Scene scene = make_empty_scene();
    EXPECT_EQ(scene.surroundings->index, air());
    EXPECT_EQ(scene.surroundings->priority, std::numeric_limits<int>::min());
    EXPECT_NO_THROW(validate(scene));
}

TEST(Studio, HasBrightBoxesInADarkRoom) {
    const auto studio = make_studio_environment();
    ASSERT_EQ(studio->pixels.size(), std::size_t(studio->width) * std::size_t(studio->height));
    // Light on a white surface that looks up: its radiance is E / π, by the sum over the pixels.
    double irradiance = 0.0, brightest = 0.0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < studio->pixels.size(); ++i) {
        const double theta =
            std::numbers::pi * (double(i / std::size_t(studio->width)) + 0.5) / studio->height;
        const double y = xyz_from_rgb(studio->pixels[i])[1];
        const double solid_angle = 2.0 * std::numbers::pi * std::numbers::pi * std::sin(theta) /
                                   (double(studio->width) * studio->height);
        irradiance += y * std::max(0.0, std::cos(theta)) * solid_angle;
        brightest = std::max(brightest, y);
        dark += y < 0.2;
    }
    EXPECT_NEAR(irradiance / std::numbers::pi, 1.2, 0.2);  // near the film's white
    EXPECT_GT(brightest, 30.0 * 0.1);                      // stones need contrast
    EXPECT_GT(double(dark) / double(studio->pixels.size()), 0.7);
}

// ---- validate ----------------------------------------------------------------------------------

Scene good_scene() {
    Scene scene = make_empty_scene();
    scene.add({"grey", Diffuse{make_constant(0.5)}, nullptr, false});
    scene.shapes.push_back(shape_of(Sphere{1.0 * unit::m}));
    scene.lights.push_back(PointLight{{{0, 5, 0}}, make_constant(1.0)});
    return scene;
}

struct Fault {
    void (*make)(Scene&);
    const char* sentence;
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::shared_ptr<Mesh> triangle() {
    auto mesh = std::make_shared<Mesh>();
    mesh->vertices = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
    mesh->triangles = {{0, 1, 2}};
    return mesh;
}

ThinLens lens_of(double aperture_m, double focus_m) {
    ThinLens lens;
    lens.aperture_radius = aperture_m * unit::m;
    lens.focus_distance = focus_m * unit::m;
    return lens;
}

const Fault kFaults[] = {
    {[](Scene& s) { s.camera.projection = Perspective{180.0 * unit::deg}; },
     "the vertical field of view is 180"},
    {[](Scene& s) { s.camera.projection = Perspective{kNan * unit::deg}; },
     "the vertical field of view is nan"},
    {[](Scene& s) { s.camera.projection = Orthographic{-1.0 * unit::m}; },
     "camera \"\": height is -1; it must be greater than 0"},
    {[](Scene& s) { s.camera.lens = lens_of(-0.01, 2.0); }, "aperture radius is -0.01"},
    {[](Scene& s) { s.camera.lens = lens_of(0.01, kNan); }, "focus distance is nan"},
    {[](Scene& s) {
         s.camera.lens = lens_of(0.01, 2.0);
         s.camera.lens->blades = 2;
     },
     "the number of blades is 2; it must be between 3 and 64"},
    {[](Scene& s) {
         s.camera.lens = lens_of(0.01, 2.0);
         s.camera.lens->glass = LensGlass{air(), 0.1 * unit::m};
     },
     "the glass of its lens has the index 1 in air, and bends nothing"},
    {[](Scene& s) {
         s.camera.lens = lens_of(0.01, 0.05);
         s.camera.lens->glass = LensGlass{make_dispersion({"abbe", {1.7, 30.0}}), 0.1 * unit::m};
     },
     "the focus distance is 0.05 m; it must be greater than the focal length, 0.1 m"},
    {[](Scene& s) {
         s.camera.lens = lens_of(0.01, 2.0);
         s.camera.projection = Panorama{};
     },
     "it has a lens; only a perspective camera can"},
    {[](Scene& s) {
         s.camera.stereo = StereoPair{0.06 * unit::m, 3.0 * unit::m};
         s.camera.projection = Orthographic{};
     },
     "it is a stereo pair; only a perspective camera can be one"},
    {[](Scene& s) {
         s.camera.stereo = StereoPair{0.06 * unit::m, 0.0 * unit::m};
     },
     "convergence distance is 0"},
    {[](Scene& s) {
         s.camera.stereo = StereoPair{0.06 * unit::m, 3.0 * unit::m};
         s.film.width = 961;
     },
     "two eyes side by side share the width; 961 pixels are odd"},
    {[](Scene& s) { s.film.width = 0; }, "film: width is 0; it must be between 1 and 65536"},
    {[](Scene& s) { s.film.white_luminance = 0.0; }, "film: white luminance is 0"},
    {[](Scene& s) { s.film.filter.radius = kInf; }, "film: filter radius is inf"},
    {[](Scene& s) { s.film.exposure_stops = kNan; }, "film: exposure is nan"},
    {[](Scene& s) { s.film.spectral_bins = -1; }, "spectral bins is -1"},
    {[](Scene& s) { s.render.samples_per_pixel = 0; }, "render: samples per pixel is 0"},
    {[](Scene& s) { s.render.packet = 2; }, "render: packet is 2"},
    {[](Scene& s) { s.render.max_depth = -1; }, "the greatest depth is -1"},
    {[](Scene& s) { s.surroundings = nullptr; }, "surroundings: its medium is missing"},
    {[](Scene& s) { s.surroundings = hazy(*s.surroundings, -1.0, henyey_greenstein(0.0)); },
     "surroundings: scattering is -1 at 360 nm"},
    {[](Scene& s) { s.surroundings = hazy(*s.surroundings, 1.0, nullptr); },
     "surroundings: its medium scatters, but has no phase function"},
    {[](Scene& s) { s.materials[0].surface = Diffuse{}; },
     "material \"grey\": reflectance is missing"},
    {[](Scene& s) { s.materials[0].surface = Diffuse{make_constant(1.1)}; },
     "material \"grey\": reflectance is 1.1"},
    {[](Scene& s) { s.materials[0].emission = make_constant(-1.0); }, "emission is -1"},
    {[](Scene& s) { s.materials[0].emission = make_constant(kInf); }, "emission is inf"},
    {[](Scene& s) { s.materials[0].surface = Dielectric{}; }, "its medium is missing"},
    {[](Scene& s) { s.materials[0].surface = ThinDielectric{}; },
     "its index of refraction is missing"},
    {[](Scene& s) {
         s.materials[0].surface = Dielectric{s.surroundings, 2.0, nullptr};
     },
     "roughness is 2"},
    {[](Scene& s) {
         s.materials[0].surface = MetallicRoughness{make_constant(1.0), kNan, 1.0, 1.5};
     },
     "metalness is nan"},
    {[](Scene& s) {
         s.materials[0].surface = Mix{0, 1, 0.5};
     },
     "the second material of the mix has the index 1"},
    {[](Scene& s) {
         s.materials[0].surface = Mix{0, 0, 0.5};
     },
     "this mix contains itself"},
    {[](Scene& s) { s.shapes[0].material = 1; }, "shape \"thing\": its material has the index 1"},
    {[](Scene& s) { s.shapes[0].geometry = Sphere{0.0 * unit::m}; },
     "shape \"thing\": radius is 0"},
    {[](Scene& s) {
         s.shapes[0].geometry = Box{1.0 * unit::m, 1.0 * unit::m, kNan * unit::m};
     },
     "depth is nan"},
    {[](Scene& s) {
         s.shapes[0].geometry = Prism{180.0 * unit::deg, 1.0 * unit::m, 1.0 * unit::m};
     },
     "apex is 180"},
    {[](Scene& s) { s.shapes[0].geometry = std::shared_ptr<const Mesh>(); }, "its mesh is missing"},
    {[](Scene& s) { s.shapes[0].geometry = std::make_shared<const Mesh>(); },
     "its mesh has no triangle"},
    {[](Scene& s) {
         auto m = triangle();
         m->triangles[0][2] = 3;
         s.shapes[0].geometry = m;
     },
     "a triangle uses vertex 3 of 3"},
    {[](Scene& s) {
         auto m = triangle();
         m->vertices[0].v.x = kNan;
         s.shapes[0].geometry = m;
     },
     "a vertex is not finite"},
    {[](Scene& s) {
         auto m = triangle();
         m->normals.resize(2);
         s.shapes[0].geometry = m;
     },
     "2 normals for 3 vertices"},
    {[](Scene& s) {
         auto m = triangle();
         m->normals.resize(3);
         s.shapes[0].geometry = m;
     },
     "a normal has no direction"},
    {[](Scene& s) {
         s.lights[0] = PointLight{{{0, kNan, 0}}, make_constant(1.0)};
     },
     "light 1: position is not finite"},
    {[](Scene& s) { s.lights[0] = PointLight{}; }, "light 1: intensity is missing"},
    {[](Scene& s) {
         s.lights[0] = DistantLight{{{0, 2, 0}}, {}, make_constant(1.0)};
     },
     "direction has the length 2"},
    {[](Scene& s) {
         s.lights[0] =
             SpotLight{{}, {{0, 1, 0}}, 0.5 * unit::rad, 0.5 * unit::rad, make_constant(1.0)};
     },
     "the inner angle must be less"},
    {[](Scene& s) { s.lights[0] = std::shared_ptr<const ImageEnvironment>(); },
     "its picture is missing"},
    {[](Scene& s) {
         auto e = std::make_shared<ImageEnvironment>(*make_studio_environment());
         e->height = 1;
         s.lights[0] = std::shared_ptr<const ImageEnvironment>(e);
     },
     "its picture has 32768 pixels for 256 x 1"},
};

TEST(Validate, TakesAGoodScene) { EXPECT_NO_THROW(validate(good_scene())); }

TEST(Validate, NamesTheFirstFault) {
    for (const Fault& fault : kFaults) {
        Scene scene = good_scene();
        fault.make(scene);
        try {
            validate(scene);
            ADD_FAILURE() << "taken: " << fault.sentence;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(fault.sentence), std::string::npos)
                << error.what();
        }
    }
}

TEST(Validate, MixesMayShareAndNest) {
    Scene scene = good_scene();
    scene.add({"inner", Mix{0, 0, 0.5}, nullptr, false});
    scene.add({"outer", Mix{1, 0, 0.5}, nullptr, false});
    EXPECT_NO_THROW(validate(scene));
    scene.materials[1].surface = Mix{0, 2, 0.5};
    EXPECT_THROW(validate(scene), InputError);
}

}  // namespace
}  // namespace dewbow
