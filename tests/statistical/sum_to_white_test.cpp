// SPDX-License-Identifier: Apache-2.0

// White light that has come apart in a body and together again is white: X, Y and Z of clear bodies
// in even light, by Hotelling's T² against the exact integral of the light.

#include <gtest/gtest.h>

#include "dewbow/render/surface/dielectric_energy.h"
#include "dewbow/spectrum/illuminant.h"
#include "estimate.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr std::size_t kSamples = 100000;
/// An error of X, Y, Z together that is found with probability 0.99 at a false-alarm rate of 1e-5.
constexpr double kDetectable = 1e-3;
const View kView{{0, 0.3, 5}, {0, 0, 0}, 0.8};

Scene in_light(const SpectrumPtr& light) {
    Scene scene = empty_scene();
    scene.lights.push_back(UniformEnvironment{light});
    return scene;
}

const Affine kAskew = rotation(normalised({1, 2, 3}), 40.0 * deg);

struct Body {
    const char* name;
    void (*put)(Scene&);
};
const Body kBodies[] = {
    {"prism",
     [](Scene& s) {
         add(s, Prism{60.0 * deg, 2.0 * m, 2.0 * m}, dielectric(glass("schott/N-SF66")), kAskew);
     }},
    {"diamond",
     [](Scene& s) {
         add(s, brilliant(), dielectric(glass("gem/diamond")), kAskew * scaling({2, 2, 2}));
     }},
    {"sphere", [](Scene& s) { add(s, Sphere{1.0 * m}, dielectric(glass("schott/N-SF11"))); }},
    // Two bodies: reflections between them take one way for all lanes, weighted.
    {"two spheres",
     [](Scene& s) {
         add(s, Sphere{0.6 * m}, dielectric(glass("schott/N-SF66")), translation({-0.6, 0, 0}));
         add(s, Sphere{0.6 * m}, dielectric(glass("gem/diamond")), translation({0.6, 0.1, 0}));
     }},
};

TEST(SumToWhite, ClearBodiesAreAsWhiteAsTheLight) {
    for (const char* light_name : {"E", "D65"}) {
        const SpectrumPtr light = find_illuminant(light_name);
        const Triple expected = xyz_of(*light);
        for (const Body& body : kBodies) {
            Scene scene = in_light(light);
            body.put(scene);
            for (const int packet : {4, 8, 16}) {
                const VectorSums sums = estimate(
                    scene, kView, {packet, WavelengthSampling::visual, kSamples, 10}, expected);
                const double t2 = hotelling(sums);
                const double share = detectable_share(sums.covariance_of_mean()[1][1], expected[1]);
                EXPECT_LT(t2, kChi3At1em5) << body.name << ", " << light_name << ", " << packet;
                // Four lanes are noisier by a factor of about 7.
                EXPECT_LT(share, packet == 4 ? 3.0 * kDetectable : kDetectable) << body.name;
                std::printf("    %-11s %-3s packet %2d: T2 %5.2f, detectable %.1e\n", body.name,
                            light_name, packet, t2, share);
            }
        }
    }
}

/// Rough glass gives back what its microfacets scatter twice, to within what its tables are wrong
/// by at each of some ten surfaces of a path; and alike however the light is carried.
TEST(SumToWhite, RoughGlassIsTheSameByAllWays) {
    Scene scene = in_light(find_illuminant("D65"));
    add(scene, Sphere{1.0 * m}, dielectric(glass("schott/N-SF66"), 0.4));
    const VectorSums reference =
        estimate(scene, kView, {16, WavelengthSampling::uniform, kSamples, 11});
    const Triple white = xyz_of(*find_illuminant("D65"));
    constexpr double kSurfacesOfAPath = 2.0;  // that are rough enough to count: a guess from above
    EXPECT_NEAR(reference.mean()[1] / white[1], 1.0, kSurfacesOfAPath * kDielectricEnergyError);
    std::printf("    Y of white: %.4f\n", reference.mean()[1] / white[1]);
    for (const int packet : {1, 8}) {
        const VectorSums sums =
            estimate(scene, kView,
                     {packet, WavelengthSampling::visual, packet == 1 ? 500000 : kSamples, 12});
        const double t2 = hotelling(sums, reference);
        const double share =
            detectable_share(sums.covariance_of_mean()[1][1] + reference.covariance_of_mean()[1][1],
                             reference.mean()[1]);
        EXPECT_LT(t2, kChi3At1em5);
        EXPECT_LT(share, 0.02);
        std::printf("    packet %d: T2 %.2f, detectable %.1e\n", packet, t2, share);
    }
}

/// Planted errors, each of which must turn the first test red.
TEST(SumToWhite, SeesPlantedErrors) {
    const SpectrumPtr light = find_illuminant("E");
    Scene scene = in_light(light);
    kBodies[0].put(scene);
    const auto t2 = [&](void (*plant)(WavelengthPacket&, PixelSample&)) {
        return hotelling(estimate(
            scene, kView, {8, WavelengthSampling::visual, kSamples, 10, plant}, xyz_of(*light)));
    };
    // The density of the wavelength 1 nm beside.
    EXPECT_GT(t2([](WavelengthPacket& lanes, PixelSample&) {
                  for (std::size_t k = 0; k < 8; ++k)
                      lanes.pdf_per_nm[k] = wavelength_pdf(
                          WavelengthSampling::visual, std::min(830.0, lanes.lambda_nm[k] + 1.0));
              }),
              kChi3At1em5);
    // One lane of eight is 1 % too dark.
    EXPECT_GT(t2([](WavelengthPacket&, PixelSample& sample) { sample.radiance[3] *= 0.99; }),
              kChi3At1em5);
    // Lanes have changed places after the split: nothing to see in even light of spectrum E, but it
    // does show in the density.
    EXPECT_GT(t2([](WavelengthPacket& lanes, PixelSample&) {
                  std::swap(lanes.lambda_nm[0], lanes.lambda_nm[1]);
              }),
              kChi3At1em5);
}

}  // namespace
}  // namespace dewbow
