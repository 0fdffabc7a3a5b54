// SPDX-License-Identifier: Apache-2.0

// Direct light on a diffuse surface, found in three ways: by sampling lights, by sampling the
// surface, and by both with the power heuristic. All have the same mean, for each kind of light
// alone and for hundreds of them together. And what is sampled has the density that is said: χ².

#include <gtest/gtest.h>

#include <functional>

#include "../analytic/scene_kit.h"
#include "../analytic/statistics.h"
#include "chi_square.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/scene_opacity.h"

namespace dewbow {
namespace {

using namespace kit;

/// Two-sided 1e-7 for one z: below 1e-5 for all of this file.
constexpr double kSigmas = 5.33;
/// An error of this share of the mean is found with probability 0.99. (SampledLight sees smaller
/// ones of a density, by its integral.)
constexpr double kDetectable = 0.1;
constexpr std::size_t kSamples = 400000;

/// Checks, red and green, as a picture with a dark frame.
TexturePtr screen_picture() {
    auto image = std::make_shared<TextureImage>();
    image->name = "screen";
    image->width = image->height = 16;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            const bool frame = x < 2 || y < 2 || x > 13 || y > 13;
            const bool red = (x / 3 + y / 3) % 2 == 0;
            for (const int value : {frame ? 0
                                    : red ? 255
                                          : 20,
                                    frame ? 0
                                    : red ? 10
                                          : 200,
                                    0, x < 8 ? 255 : 90})
                image->texels8.push_back(std::uint8_t(value));
        }
    auto texture = std::make_shared<Texture>();
    texture->image = image;
    return texture;
}
Material screen(bool veiled = false) {
    Material material{"screen", Black{}, nullptr, false};
    material.emission_texture = EmissionTexture{screen_picture(), {{3.0, 2.0, 1.0}}};
    if (veiled) {
        material.coverage.emplace();
        material.coverage->alpha = 1.0;
        material.coverage->alpha.texture = screen_picture();
        material.coverage->alpha.channel = 3;
    }
    return material;
}
/// Two triangles of 2 x 2 m in z = 0 with texture coordinates.
std::shared_ptr<const Mesh> screen_mesh() {
    auto result = std::make_shared<Mesh>(
        *mesh({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}));
    result->texcoords[0] = {{{0, 1}}, {{1, 1}}, {{1, 0}}, {{0, 0}}};
    return result;
}

/// What midpoints miss of a cell that the edge of a light crosses; and where the density rises
/// without bound towards the rim, as of a round surface that is sampled by its area.
constexpr double kEdges = 1.5e-2, kRim = 8e-2;

struct Case {
    std::string name;
    std::function<void(Scene&)> fill;
    double missed = kEdges;  ///< share of a cell's density that midpoints miss
};

/// Over the origin, facing down.
Affine overhead(double height, double x = 0.0) {
    return translation({x, height, 0}) * rotation({1, 0, 0}, 90.0 * deg);
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all{
        {"Sphere",
         [](Scene& s) {
             add(s, Sphere{0.5 * m}, lamp(1.0), translation({1, 2, 0}));
         }},
        {"Ellipsoid",
         [](Scene& s) {
             add(s, Sphere{0.5 * m}, lamp(1.0), translation({1, 2, 0}) * scaling({1, 0.5, 2}));
         },
         kRim},
        {"Disc", [](Scene& s) { add(s, Disc{1.0 * m}, lamp(1.0), overhead(1.5, 1.0)); }},
        {"Rectangle",
         [](Scene& s) {
             add(s, Rectangle{1.0 * m, 3.0 * m}, lamp(1.0), overhead(1.5, 1.0));
         }},
        {"Box",
         [](Scene& s) {
             add(s, Box{1.0 * m, 0.5 * m, 2.0 * m}, lamp(1.0),
                 translation({1, 2, 0}) * rotation(normalised({1, 2, 3}), 40.0 * deg));
         }},
        {"Prism",
         [](Scene& s) {
             add(s, Prism{50.0 * deg, 1.0 * m, 2.0 * m}, lamp(1.0),
                 translation({1, 2, 0}) * rotation(normalised({1, 2, 3}), 40.0 * deg));
         }},
        {"Mesh",
         [](Scene& s) {
             add(s, sphere_mesh(0.7, 2), lamp(1.0), translation({1, 2, 0}) * scaling({1, 1, 1.5}));
         }},
        {"Sun",
         [](Scene& s) {
             s.lights.push_back(
                 DistantLight{{normalised({1, -1, 0})}, 12.0 * deg, make_constant(1.0)});
         }},
        {"EvenSky", [](Scene& s) { s.lights.push_back(UniformEnvironment{make_constant(1.0)}); }},
        {"ScreenOfARectangle",
         [](Scene& s) {
             add(s, Rectangle{2.0 * m, 2.0 * m}, screen(), overhead(1.5));
         }},
        {"ScreenOfABox",
         [](Scene& s) {
             add(s, Box{2.0 * m, 1.0 * m, 1.0 * m}, screen(),
                 translation({0, 2, 0}) * rotation(normalised({1, 2, 3}), 40.0 * deg));
         }},
        {"ScreenOfAMesh", [](Scene& s) { add(s, screen_mesh(), screen(), overhead(1.5)); }},
        {"PictureOnASphere",
         [](Scene& s) {
             add(s, Sphere{0.5 * m}, screen(), translation({1, 2, 0}));
         }},
        {"VeiledScreen",
         [](Scene& s) {
             add(s, Rectangle{2.0 * m, 2.0 * m}, screen(true), overhead(1.5));
             add(s, Sphere{0.4 * m}, lamp(3.0), translation({0, 2.5, 0}));
         }},
        {"HundredsOfAllKinds",
         [](Scene& s) {
             for (int i = 0; i < 15; ++i)
                 for (int k = 0; k < 15; ++k) {
                     const Affine at = translation({i - 7.0, 1.0 + 0.1 * k, k - 7.0});
                     const double radiance = 1.0 + (i * 7 + k * 3) % 11;
                     if ((i + k) % 3 == 0)
                         add(s, Sphere{0.1 * m}, lamp(radiance), at);
                     else if ((i + k) % 3 == 1)
                         add(s, Rectangle{0.3 * m, 0.3 * m}, lamp(radiance, true),
                             at * rotation({0, 0, 1}, 10.0 * i * deg));
                     else
                         add(s, Box{0.2 * m, 0.1 * m, 0.2 * m}, lamp(radiance), at);
                 }
             s.lights.push_back(UniformEnvironment{make_constant(0.05)});
         }},
    };
    return all;
}

/// What a fault of the density would be, for the test of the test.
using Plant = double (*)(double pdf);
double none(double pdf) { return pdf; }

class DirectLight {
public:
    DirectLight(const Case& of, Plant plant) : plant_(plant) {
        scene_ = empty_scene();
        of.fill(scene_);
        opacity_.emplace(scene_);
        accelerator_.emplace(scene_, std::vector<bool>(scene_.shapes.size(), false), &*opacity_);
        lights_.emplace(scene_);
    }

    const LightSet& lights() const { return *lights_; }
    const Accelerator& accelerator() const { return *accelerator_; }

    /// Mean over the lanes of the light that one sample of the lights brings, weighted or not.
    double by_light(const Receiver& at, const SampleKey& key, bool weighted) {
        const auto s = lights_->sample(at, test_numbers(key, 1)[0], test_numbers(key, 2));
        if (!s || dot(s->direction, at.normal) <= 0.0) return 0.0;
        if (accelerator_->occluded({at.position, s->direction, {}}, s->distance)) return 0.0;
        begin(key);
        LaneValues radiance;
        lights_->radiance(*s, lanes_, rgb_, radiance);
        const double cosine = dot(s->direction, at.normal), own = cosine / kPi;
        const double pdf = plant_(s->pdf);
        const double weight = weighted ? power(pdf, own) : 1.0;
        return weight * mean(radiance) * cosine / pdf;
    }
    double by_surface(const Receiver& at, const SampleKey& key, bool weighted) {
        const auto u = test_numbers(key, 3);
        const Vec3 d = around(Dir<World>{at.normal}, sample_cosine_hemisphere(u[0], u[1])).v;
        const double own = dot(d, at.normal) / kPi;
        begin(key);
        LaneValues radiance;
        const Hit hit = accelerator_->intersect({at.position, d, {}});
        if (hit) {
            if (!lights_->emits(hit, d)) return 0.0;
            lights_->emission(hit, accelerator_->coordinates(hit, at.position + d * hit.t), lanes_,
                              rgb_, radiance);
            const double pdf = plant_(lights_->pdf_of_hit(at, d, hit));
            return (weighted ? power(own, pdf) : 1.0) * mean(radiance) * kPi;
        }
        double sum = 0.0;
        for (int i = 0; i < lights_->infinite_count(); ++i) {
            if (!lights_->infinite_radiance(i, d, lanes_, rgb_, radiance)) continue;
            const double pdf = plant_(lights_->pdf_of_infinite(at, i, d));
            sum += (weighted ? power(own, pdf) : 1.0) * mean(radiance) * kPi;
        }
        return sum;
    }

private:
    static double power(double a, double b) { return a * a / (a * a + b * b); }
    void begin(const SampleKey& key) {
        packet_ = packet_of(key, 4);
        lanes_ = LaneSet::all(packet_);
        rgb_.begin(packet_);
    }
    double mean(const LaneValues& values) const {
        double sum = 0.0;
        for (int k = 0; k < lanes_.count; ++k) sum += values[k] / lanes_.count;
        return sum;
    }

    Plant plant_;
    Scene scene_;
    std::optional<SceneOpacity> opacity_;
    std::optional<Accelerator> accelerator_;
    std::optional<LightSet> lights_;
    WavelengthPacket packet_;
    LaneSet lanes_;
    RgbLightLanes rgb_;
};

/// Points of the floor, so that each light is near and far, before and behind.
Receiver floor_point(const SampleKey& key) {
    const auto u = test_numbers(key, 4);
    return {{4.0 * u[0] - 2.0, 0.0, 4.0 * u[1] - 2.0}, normalised({0.2, 1.0, 0.1})};
}

struct Means {
    MeanSums light, surface, both;
};

Means means_of(const Case& of, Plant plant) {
    DirectLight direct(of, plant);
    Means means;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const SampleKey key = independent_key(77, i);
        const Receiver at = floor_point(key);
        means.light.add(direct.by_light(at, key, false));
        means.surface.add(direct.by_surface(at, key, false));
        means.both.add(direct.by_light(at, key, true) + direct.by_surface(at, key, true));
    }
    return means;
}

double z_of_difference(const MeanSums& a, const MeanSums& b) {
    return (a.mean() - b.mean()) / std::hypot(a.standard_error(), b.standard_error());
}

class ThreeWays : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ThreeWays, Agree) {
    const Means means = means_of(cases()[GetParam()], none);
    EXPECT_LT(std::abs(z_of_difference(means.light, means.surface)), kSigmas);
    EXPECT_LT(std::abs(z_of_difference(means.both, means.surface)), kSigmas);
    EXPECT_LT(std::abs(z_of_difference(means.both, means.light)), kSigmas);
    const double error = std::hypot(means.surface.standard_error(), means.light.standard_error());
    EXPECT_LT((kSigmas + kPower99) * error / means.both.mean(), kDetectable) << "too few samples";
}
INSTANTIATE_TEST_SUITE_P(Lights, ThreeWays, ::testing::Range(std::size_t{0}, cases().size()),
                         [](const auto& of) { return cases()[of.param].name; });

/// The planted bug: a density that is 10 % too large.
TEST(ThreeWays, SeeAWrongDensity) {
    const Means means = means_of(cases().front(), [](double pdf) { return 1.1 * pdf; });
    EXPECT_GT(std::abs(z_of_difference(means.light, means.surface)), kSigmas);
}

/// Directions to one light fall as its density says, on the whole sphere.
class SampledLight : public ::testing::TestWithParam<std::size_t> {};

double density_of(DirectLight& direct, const Receiver& at, Vec3 d) {
    const Hit hit = direct.accelerator().intersect({at.position, d, {}});
    double sum = 0.0;
    if (hit && direct.lights().emits(hit, d)) sum += direct.lights().pdf_of_hit(at, d, hit);
    RgbLightLanes rgb;
    const WavelengthPacket packet = one_wavelength(550.0);
    rgb.begin(packet);
    LaneValues radiance;
    for (int i = 0; i < direct.lights().infinite_count(); ++i)
        if (direct.lights().infinite_radiance(i, d, LaneSet::all(packet), rgb, radiance))
            sum += direct.lights().pdf_of_infinite(at, i, d);
    return sum;
}

TEST_P(SampledLight, FallsAsItsDensity) {
    DirectLight direct(cases()[GetParam()], none);
    const Receiver at{{0.1, 0.0, 0.2}, {0, 1, 0}};
    const ChiSquare found = chi_square(
        [&](const SampleKey& key) -> std::optional<Vec3> {
            const auto s =
                direct.lights().sample(at, test_numbers(key, 1)[0], test_numbers(key, 2));
            if (!s) return std::nullopt;
            return s->direction;
        },
        [&](Vec3 d) { return density_of(direct, at, d); }, 200000, cases()[GetParam()].missed);
    EXPECT_LT(found.integral, 1.0 + cases()[GetParam()].missed);
    EXPECT_LT(found.score, kChiLimit);
}
/// The first twelve are one shape or sky alone and whole; a sphere's picture is sampled as it is.
INSTANTIATE_TEST_SUITE_P(Lights, SampledLight, ::testing::Range(std::size_t{0}, std::size_t{12}),
                         [](const auto& of) { return cases()[of.param].name; });

}  // namespace
}  // namespace dewbow
