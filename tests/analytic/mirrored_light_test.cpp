// SPDX-License-Identifier: Apache-2.0

// A lamp under a mirror lights the floor as if a second lamp hung behind it, weaker by the mirror's
// reflectance: light that starts at every kind of lamp, against direct light of its mirror image.

#include <gtest/gtest.h>

#include "pictures.h"
#include "scene_kit.h"
#include "welch.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr double kMirrorHeight = 1.5, kReflectance = 0.9;
constexpr int kReplicates = 8, kSamples = 16;
/// Of a quarter of one picture; 4e-5 for the file.
constexpr double kFalseAlarm = 1e-6;
/// An error of this share of what a quarter shows is found with probability 0.99.
constexpr double kDetectable = 0.2;
constexpr double kLightPaths = 12.0;  ///< for each sample of a pixel

/// What hangs in the room, and how it looks behind the mirror.
struct Lamps {
    const char* name;
    /// Adds the lamp, or with `image` its mirror image.
    void (*add_to)(Scene& scene, bool image);
};
void PrintTo(const Lamps& lamps, std::ostream* out) { *out << lamps.name; }

Vec3 place(Vec3 p, bool image) { return image ? Vec3{p.x, 2.0 * kMirrorHeight - p.y, p.z} : p; }
Vec3 way(Vec3 d, bool image) { return normalised(image ? Vec3{d.x, -d.y, d.z} : d); }
SpectrumPtr strength(double value, bool image) {
    return make_constant(image ? kReflectance * value : value);
}
/// Small enough for the sun to pass it by on the way up.
constexpr double kFloor_m = 1.6;
const Vec3 kAslant{1.0, 1.0, 0.1};
const Vec3 kAt{0.15, 0.6, -0.1}, kUp{-0.05, 1.0, 0.03};

/// At kAt, facing kUp; everything that is added so looks alike in a mirror.
void add_facing(Scene& scene, bool image, Geometry geometry, double radiance) {
    const Affine stand = translation(place(kAt, image)) *
                         looking_at({}, -1.0 * way(kUp, image), way({0, 0, 1}, image));
    const SpectrumPtr light = strength(radiance, image);
    add(scene, std::move(geometry), lamp(light), stand);
}

const Lamps kLamps[] = {
    {"Point",
     [](Scene& s, bool image) {
         s.lights.push_back(PointLight{{place(kAt, image)}, strength(1.0, image)});
     }},
    {"Spot",
     [](Scene& s, bool image) {
         s.lights.push_back(SpotLight{
             {place(kAt, image)}, {way(kUp, image)}, 10.0 * deg, 25.0 * deg, strength(3.0, image)});
     }},
    {"Profile",
     [](Scene& s, bool image) {
         // Round about its axis, +y of its own frame.
         PhotometricTable table{{0, 120, 150, 180}, {0}, {0.0, 0.0, 300.0, 500.0}};
         const Affine stand =
             looking_at({}, -1.0 * way(kUp, image), {0, 0, 1}) * rotation({1, 0, 0}, 90.0 * deg);
         s.lights.push_back(ProfileLight{{place(kAt, image)},
                                         Transform<World, Object>(stand),
                                         std::make_shared<const PhotometricWeb>(table),
                                         strength(0.01, image)});
     }},
    {"Beam",
     [](Scene& s, bool image) {
         s.lights.push_back(
             BeamLight{{place(kAt, image)}, {way(kUp, image)}, 0.7 * m, strength(2.0, image)});
     }},
    {"ParallelSun",
     [](Scene& s, bool image) {
         s.lights.push_back(DistantLight{{way(kAslant, image)}, 0.0 * deg, strength(1.0, image)});
     }},
    {"Sun",
     [](Scene& s, bool image) {
         s.lights.push_back(DistantLight{{way(kAslant, image)}, 3.0 * deg, strength(1.0, image)});
     }},
    {"Disc", [](Scene& s, bool image) { add_facing(s, image, Disc{0.2 * m}, 3.0); }},
    {"Rectangle",
     [](Scene& s, bool image) {
         add_facing(s, image, Rectangle{0.3 * m, 0.4 * m}, 3.0);
     }},
    {"Sphere", [](Scene& s, bool image) { add_facing(s, image, Sphere{0.15 * m}, 3.0); }},
    {"Box",
     [](Scene& s, bool image) {
         add_facing(s, image, Box{0.2 * m, 0.2 * m, 0.3 * m}, 3.0);
     }},
};

Scene room(const Lamps& lamps, bool image) {
    Scene scene = empty_scene(2);
    scene.film.width = scene.film.height = 16;
    scene.render.caustics.light_paths = kLightPaths;
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 0.2, 0}, {0, 0, 0}, {0, 0, -1}));
    scene.camera.projection = Orthographic{0.95 * kFloor_m * m};
    add(scene, Rectangle{kFloor_m * m, kFloor_m * m}, diffuse(0.7),
        rotation({1, 0, 0}, -90.0 * deg));
    lamps.add_to(scene, false);
    if (image)
        lamps.add_to(scene, true);
    else
        add(scene, Rectangle{6.0 * m, 6.0 * m}, {"mirror", Mirror{make_constant(kReflectance)}},
            translation({0, kMirrorHeight, 0}) * rotation({1, 0, 0}, 90.0 * deg));
    return scene;
}

/// Y of the picture's quarters.
std::array<double, 4> quarters(const Scene& scene, const MakeEstimator& make, std::uint64_t seed) {
    const FilmSums film = film_of(scene, make, kSamples, seed).film;
    std::array<double, 4> sums{};
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x)
            sums[std::size_t((2 * y / film.height()) * 2 + 2 * x / film.width())] +=
                film.xyz(x, y)[1];
    return sums;
}

class MirroredLight : public ::testing::TestWithParam<Lamps> {};

TEST_P(MirroredLight, IsThatOfTheMirrorImage) {
    std::array<std::vector<double>, 4> mirrored, image;
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        const auto a = quarters(room(GetParam(), false), method("caustics"), r);
        const auto b = quarters(room(GetParam(), true), method("path"), 1000 + r);
        for (std::size_t i = 0; i < 4; ++i) mirrored[i].push_back(a[i]), image[i].push_back(b[i]);
    }
    double least = 1.0, weakest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const WelchTest test = welch(mirrored[i], image[i]);
        const double expected = mean_of(image[i]).mean;
        EXPECT_GT(test.chance, kFalseAlarm) << mean_of(mirrored[i]).mean << " for " << expected;
        EXPECT_LT(test.detectable(kFalseAlarm), kDetectable * expected) << "too few samples";
        least = std::min(least, test.chance);
        weakest = std::max(weakest, test.detectable(kFalseAlarm) / expected);
    }
    std::printf("    %s: least chance %.2g, detectable %.4f\n", GetParam().name, least, weakest);
}
INSTANTIATE_TEST_SUITE_P(Lights, MirroredLight, ::testing::ValuesIn(kLamps),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace dewbow
