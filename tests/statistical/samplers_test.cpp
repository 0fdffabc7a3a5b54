// SPDX-License-Identifier: Apache-2.0

// Samplers draw what their densities say: χ² on the sphere of directions, and the density that a
// sample brings equals the density of its direction.

#include <gtest/gtest.h>

#include <functional>

#include "../analytic/scene_kit.h"
#include "../analytic/statistics.h"
#include "dewbow/optics/refraction.h"
#include "dewbow/render/bsdf.h"
#include "dewbow/render/environment.h"
#include "dewbow/render/light_set.h"
#include "dewbow/render/microfacet.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kSamples = 1000000;
constexpr int kRows = 24, kColumns = 24;
/// Midpoints a side of a cell over which densities are integrated.
constexpr int kFine = 32;
/// Cells that expect fewer samples are pooled.
constexpr double kLeastExpected = 10.0;
/// (χ² − ν) / √(2ν) with some hundred degrees of freedom: about 1e-6.
constexpr double kChiLimit = 5.2;
/// Midpoints integrate the densities here to this, by halving the cells.
constexpr double kQuadrature = 2e-3;

using SampleDirection = std::function<std::optional<Vec3>(const SampleKey&)>;
using Density = std::function<double(Vec3)>;

struct ChiSquare {
    double score;     // (χ² − ν) / √(2ν)
    double integral;  // of the density over the sphere
    bool in_void;     // a sample where the density is 0
};

/// χ² of samples in cells of equal solid angle, the failed samples as one more cell.
ChiSquare chi_square(const SampleDirection& sample, const Density& density,
                     int samples = kSamples) {
    std::vector<double> expected(kRows * kColumns), found(kRows * kColumns, 0.0);
    ChiSquare result{0.0, 0.0, false};
    const double cell = 4.0 * kPi / double(kRows * kColumns);
    for (int i = 0; i < kRows * kColumns; ++i) {
        double sum = 0.0;
        for (int a = 0; a < kFine * kFine; ++a) {
            const double z = 1.0 - 2.0 * (i / kColumns + (a / kFine + 0.5) / kFine) / kRows;
            const double phi = 2.0 * kPi * (i % kColumns + (a % kFine + 0.5) / kFine) / kColumns;
            const double s = std::sqrt(1.0 - z * z);
            sum += density({s * std::cos(phi), s * std::sin(phi), z});
        }
        expected[std::size_t(i)] = sum / (kFine * kFine) * cell * samples;
        result.integral += expected[std::size_t(i)] / samples;
    }
    double failed = 0.0;
    for (int i = 0; i < samples; ++i) {
        const std::optional<Vec3> d = sample(independent_key(30, std::size_t(i)));
        if (!d) {
            failed += 1.0;
            continue;
        }
        double turn = std::atan2(d->y, d->x) / (2.0 * kPi);
        if (turn < 0.0) turn += 1.0;
        const int row = std::clamp(int(0.5 * (1.0 - d->z) * kRows), 0, kRows - 1);
        found[std::size_t(row * kColumns + std::min(kColumns - 1, int(turn * kColumns)))] += 1.0;
        result.in_void = result.in_void || !(density(*d) > 0.0);
    }
    double chi = 0.0, pooled_expected = samples * std::max(0.0, 1.0 - result.integral),
           pooled_found = failed;
    int freedom = -1;
    // The quadrature's own error, in samples, counts as variance.
    const auto take = [&](double e, double f, double quadrature) {
        chi += (f - e) * (f - e) / (e + quadrature * quadrature);
        ++freedom;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] >= kLeastExpected)
            take(expected[i], found[i], kQuadrature * expected[i]);
        else
            pooled_expected += expected[i], pooled_found += found[i];
    }
    take(std::max(kLeastExpected, pooled_expected), std::max(kLeastExpected, pooled_found),
         kQuadrature * samples);
    result.score = (chi - freedom) / std::sqrt(2.0 * freedom);
    return result;
}

void expect_good(const SampleDirection& sample, const Density& density, bool whole) {
    const ChiSquare found = chi_square(sample, density);
    EXPECT_LT(found.score, kChiLimit);
    EXPECT_FALSE(found.in_void);
    EXPECT_LE(found.integral, 1.0 + kQuadrature);
    if (whole) {
        EXPECT_NEAR(found.integral, 1.0, kQuadrature);
    }
}

Vec3 tilted(double cosine) { return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine}; }

TEST(Samplers, VisibleNormals) {
    for (const double alpha : {0.3, 0.7, 1.0})
        for (const double cosine : {1.0, 0.6, 0.1}) {
            SCOPED_TRACE(::testing::Message() << alpha << " " << cosine);
            const Vec3 w = tilted(cosine);
            expect_good(
                [&](const SampleKey& key) {
                    return sample_visible_normal(w, alpha, test_numbers(key, 0));
                },
                [&](Vec3 d) { return d.z > 0.0 ? ggx_visible_pdf(w, d, alpha) : 0.0; }, true);
        }
}

/// Planted: 2 % more roughness in the density than in the samples.
TEST(Samplers, SeeAPlantedError) {
    const Vec3 w = tilted(0.6);
    const ChiSquare found = chi_square(
        [&](const SampleKey& key) { return sample_visible_normal(w, 0.5, test_numbers(key, 0)); },
        [&](Vec3 d) { return d.z > 0.0 ? ggx_visible_pdf(w, d, 0.51) : 0.0; });
    EXPECT_GT(found.score, kChiLimit);
}

struct Surface {
    const char* name;
    Material material;
};
std::vector<Surface> surfaces() {
    return {{"white paper", diffuse(1.0)},
            {"plastic", {"", MetallicRoughness{make_constant(0.8), 0.0, 0.6, 1.5}, nullptr}},
            {"metal", {"", MetallicRoughness{make_constant(0.9), 1.0, 0.7, 1.5}, nullptr}},
            {"half metal", {"", MetallicRoughness{make_constant(0.5), 0.5, 0.8, 1.8}, nullptr}}};
}

TEST(Samplers, OpaqueSurfaces) {
    const LaneSet lanes = LaneSet::all(one_wavelength(550.0));
    const SurfaceCoordinates nowhere;
    RgbReflectanceLanes rgb;
    const SurfaceInputs inputs(nowhere, rgb);
    for (const Surface& row : surfaces())
        for (const double cosine : {0.95, 0.2}) {
            SCOPED_TRACE(::testing::Message() << row.name << " " << cosine);
            const OpaqueSurface surface(row.material, inputs, lanes, tilted(cosine));
            expect_good(
                [&](const SampleKey& key) {
                    return surface.sample(test_numbers(key, 0)[0], test_numbers(key, 1));
                },
                [&](Vec3 d) {
                    LaneValues f;
                    return surface.eval(d, f);
                },
                false);
        }
}

/// f(ω_o, ω_i) = f(ω_i, ω_o); and no surface gives back more than it gets.
TEST(Samplers, OpaqueSurfacesAreReciprocalAndKeepEnergy) {
    constexpr double kRounding = 1e-10;
    const LaneSet lanes = LaneSet::all(one_wavelength(550.0));
    const SurfaceCoordinates nowhere;
    RgbReflectanceLanes rgb;
    const SurfaceInputs inputs(nowhere, rgb);
    for (const Surface& row : surfaces()) {
        SCOPED_TRACE(row.name);
        for (std::size_t i = 0; i < 10000; ++i) {
            const SampleKey key = independent_key(31, i);
            const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
            const Vec3 x = sample_cosine_hemisphere(a[0], a[1]).v,
                       y = sample_cosine_hemisphere(b[0], b[1]).v;
            LaneValues xy, yx;
            OpaqueSurface(row.material, inputs, lanes, x).eval(y, xy);
            OpaqueSurface(row.material, inputs, lanes, y).eval(x, yx);
            const double there = xy[0] / y.z, back = yx[0] / x.z;
            ASSERT_NEAR(there / back, 1.0, kRounding);
        }
        for (const double cosine : {1.0, 0.5, 0.05}) {
            const OpaqueSurface surface(row.material, inputs, lanes, tilted(cosine));
            MeanSums albedo;
            for (std::size_t i = 0; i < 100000; ++i) {
                const SampleKey key = independent_key(32, i);
                const auto d = surface.sample(test_numbers(key, 0)[0], test_numbers(key, 1));
                LaneValues f;
                const double pdf = d ? surface.eval(*d, f) : 0.0;
                albedo.add(pdf > 0.0 ? f[0] / pdf : 0.0);
            }
            EXPECT_LE(albedo.mean(), 1.0 + 4.9 * albedo.standard_error()) << cosine;
            EXPECT_GT(albedo.mean(), 0.2) << cosine;
        }
    }
}

TEST(Samplers, RoughDielectric) {
    constexpr double kAlpha = 0.4;
    for (const double n : {1.5, 1.0 / 1.5, 2.4})
        for (const double cosine : {0.95, 0.3}) {
            SCOPED_TRACE(::testing::Message() << n << " " << cosine);
            const Vec3 wo = tilted(cosine);
            MeanSums energy;
            const auto sample = [&](const SampleKey& key) -> std::optional<Vec3> {
                const Vec3 facet = sample_visible_normal(wo, kAlpha, test_numbers(key, 0));
                const double c = dot(wo, facet);
                if (c <= 0.0) return std::nullopt;
                const bool reflects =
                    test_numbers(key, 1)[0] < fresnel_dielectric(std::min(1.0, c), n).unpolarised();
                const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(c, n)));
                const Vec3 wi = normalised(reflects ? facet * (2.0 * c) - wo
                                                    : facet * (c / n - cos_t) - wo * (1.0 / n));
                if ((wi.z > 0.0) != reflects) return std::nullopt;
                const RoughDielectricValue value = eval_rough_dielectric(wo, wi, kAlpha, n);
                energy.add(value.f_cos / value.pdf);
                return wi;
            };
            expect_good(
                sample, [&](Vec3 d) { return eval_rough_dielectric(wo, d, kAlpha, n).pdf; }, false);
            EXPECT_LE(energy.sum / kSamples, 1.0);
            EXPECT_GT(energy.sum / kSamples, 0.6);
        }
}

/// Reflected radiance is the same both ways, and so is what is let through, of radiance / n².
TEST(Samplers, RoughDielectricIsReciprocal) {
    constexpr double kRounding = 1e-6;  // of Fresnel next to total reflection
    int seen = 0;
    for (std::size_t i = 0; i < 20000; ++i) {
        const SampleKey key = independent_key(33, i);
        const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
        const Vec3 x = sample_cosine_hemisphere(a[0], a[1]).v;
        Vec3 y = sample_cosine_hemisphere(b[0], b[1]).v;
        const bool through = i % 2 == 0;
        if (through) y.z = -y.z;
        const double n = 1.5;
        // From below, everything is seen upside down and the index is 1/n.
        const double there = eval_rough_dielectric(x, y, 0.5, n).f_cos / std::abs(y.z);
        const double back =
            through
                ? eval_rough_dielectric({y.x, y.y, -y.z}, {x.x, x.y, -x.z}, 0.5, 1.0 / n).f_cos /
                      x.z
                : eval_rough_dielectric(y, x, 0.5, n).f_cos / x.z;
        // f(x → y) dω_y in glass carries n² more directions.
        const double scale = through ? n * n : 1.0;
        if (!(there > 0.0)) {
            EXPECT_EQ(back, 0.0);
            continue;
        }
        ++seen;
        ASSERT_NEAR(there / (back * scale), 1.0, kRounding) << through;
    }
    EXPECT_GT(seen, 5000);
}

// ---- lights ------------------------------------------------------------------------------------

Scene lights_scene() {
    Scene scene = empty_scene();
    const Material two{"two", Black{}, make_constant(1.0), true};
    add(scene, Sphere{0.5 * m}, lamp(1.0), translation({2, 1, 0}));
    add(scene, Sphere{0.5 * m}, lamp(1.0), translation({-2, 0, 1}) * scaling({1, 0.4, 1.5}));
    add(scene, Disc{0.7 * m}, two, translation({0, 2, 0}) * rotation({1, 0, 0}, 60.0 * deg));
    add(scene, Rectangle{1.0 * m, 0.5 * m}, lamp(1.0), translation({0, 0, -2}));
    add(scene, Box{0.6 * m, 0.5 * m, 0.4 * m}, lamp(1.0), translation({0, -2, 0.5}));
    add(scene, sphere_mesh(0.4, 1), lamp(1.0), translation({0.3, 0.5, 2}));
    scene.lights.push_back(DistantLight{{normalised({1, 1, 1})}, 8.0 * deg, make_constant(0.2)});
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 8, image->height = 4;
    for (int i = 0; i < 32; ++i) image->pixels.push_back({{0.1 * i, 0.5, 1.0}});
    image->world_from_object = Transform<World, Object>(rotation({0, 1, 0}, 70.0 * deg));
    scene.lights.push_back(std::shared_ptr<const ImageEnvironment>(image));
    return scene;
}

/// A sampled direction has, looked at from the other end, the density that it was drawn with.
TEST(Samplers, LightsKnowTheDensityOfTheirSamples) {
    constexpr double kSame = 1e-6;  // directions at the rim of a light, cosines near 0
    const Scene scene = lights_scene();
    const LightSet lights(scene);
    std::vector<int> seen(scene.shapes.size() + scene.lights.size(), 0);
    for (std::size_t i = 0; i < 100000; ++i) {
        const SampleKey key = independent_key(34, i);
        const Vec3 from{0.1, 0.2, 0.3};
        const auto s = lights.sample(from, test_numbers(key, 0)[0], test_numbers(key, 1));
        if (!s) continue;
        ++seen[std::size_t(s->light)];
        if (std::isinf(s->distance)) {
            const int k = s->light - int(scene.shapes.size());
            ASSERT_NEAR(lights.pdf_of_infinite(k, s->direction) / s->pdf, 1.0, kSame);
            continue;
        }
        // That light alone, so that nothing stands before it.
        static std::vector<std::unique_ptr<Scene>> alone;
        static std::vector<std::unique_ptr<Accelerator>> trees;
        if (alone.empty())
            for (const Shape& shape : scene.shapes) {
                alone.push_back(std::make_unique<Scene>(empty_scene()));
                alone.back()->materials = scene.materials;
                alone.back()->shapes = {shape};
                trees.push_back(
                    std::make_unique<Accelerator>(*alone.back(), std::vector<bool>{false}));
            }
        Hit hit = trees[std::size_t(s->light)]->intersect({from, s->direction, {}});
        if (!hit || std::abs(hit.t / s->distance - 1.0) > 1e-6)
            continue;  // the far side, or the rim
        hit.shape = s->light;
        ASSERT_NEAR(lights.pdf_of_hit(from, s->direction, hit) / s->pdf, 1.0, 1e-4)
            << "light " << s->light;
    }
    for (const int count : seen) EXPECT_GT(count, 200);
}

TEST(Samplers, EnvironmentPicture) {
    auto image = std::make_shared<ImageEnvironment>();
    image->width = 8, image->height = 6;
    for (int i = 0; i < 48; ++i)
        image->pixels.push_back({{0.1 * (i % 8), 0.5, i == 21 ? 9.0 : 0.0}});
    image->world_from_object =
        Transform<World, Object>(rotation(normalised({1, 2, 0}), 50.0 * deg));
    const EnvironmentMap map(image);
    const auto sample = [&](const SampleKey& key) -> std::optional<Vec3> {
        const EnvironmentMap::Sample s = map.sample(test_numbers(key, 0));
        EXPECT_NEAR(map.pdf(s.direction) / s.pdf, 1.0, 1e-6);
        return s.direction;
    };
    const ChiSquare found = chi_square(
        sample, [&](Vec3 d) { return map.pdf(d); }, 200000);
    // The density jumps from pixel to pixel, askew to the cells: midpoints miss more of it.
    EXPECT_NEAR(found.integral, 1.0, 5e-3);
    EXPECT_LT(found.score, 4.0 * kChiLimit);
}

}  // namespace
}  // namespace dewbow
