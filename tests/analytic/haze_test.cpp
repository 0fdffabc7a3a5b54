// SPDX-License-Identifier: Apache-2.0

// Light that haze scatters once into a ray, against quadrature of
//     L = ∫ σ_s p(cos θ) E(t) e^(−σ_t t) dt
// with the irradiance E of each kind of lamp in closed form, dimmed on its way.

#include <gtest/gtest.h>

#include "dewbow/math/quadrature.h"
#include "scene_kit.h"
#include "statistics.h"

namespace dewbow {
namespace {

using namespace kit;

/// Two-sided 1e-8 for one z: below 1e-6 for all of this file.
constexpr double kSigmas = 5.73;
/// An error of this share of what is expected is found with probability 0.99.
constexpr double kDetectable = 0.02;
constexpr double kExact = 1e-10;
/// Henyey–Greenstein's g of the haze.
constexpr double kG = 0.6;

SpectrumPtr scattering() {
    return make_tabulated({360, 550, 830}, {0.3, 0.2, 0.1}, OutsideTable::hold);
}
constexpr double kAbsorption = 0.05;  // m⁻¹

double sigma_s(double lambda_nm) { return (*scattering())(lambda_nm * unit::nm); }
double sigma_t(double lambda_nm) { return sigma_s(lambda_nm) + kAbsorption; }
double phase(double cosine) {
    return (1.0 - kG * kG) / (4.0 * kPi * std::pow(1.0 + kG * kG - 2.0 * kG * cosine, 1.5));
}

MediumPtr haze(double n = 1.0) {
    Medium haze = *plain(n, make_constant(kAbsorption), -1000);
    haze.scattering = scattering();
    haze.phase = henyey_greenstein(kG);
    return std::make_shared<Medium>(haze);
}

Scene hazy_scene() {
    Scene scene = empty_scene(16);
    scene.surroundings = haze();
    return scene;
}
/// Black, in z = −`distance`: where rays along −z end.
void add_wall(Scene& scene, double distance) {
    add(scene, Rectangle{100.0 * m, 100.0 * m}, {"wall", Black{}}, translation({0, 0, -distance}));
}

const Ray kRay{{0, 0, 0}, {0, 0, -1}, {}};
constexpr double kLength = 4.0;

/// ∫ f(t) dt along the ray, with the piece around a lamp at `centre` by itself.
template <class F>
double along_ray(double length, double centre, F&& f) {
    static const QuadratureRule rule = gauss_legendre(200);
    return integrate(rule, 0.0, centre, f) + integrate(rule, centre, length, f);
}

/// The statistics of the difference to `expected(lambda_nm)`, as a share of it, over four lanes.
template <class Expected>
MeanSums difference(const Scene& scene, const Ray& ray, std::size_t samples, Expected&& expected) {
    const PreparedScene prepared(scene);
    const MediaStack start = media_at(ray.origin, scene, prepared.media, prepared.accelerator);
    constexpr int kLanes = 4;
    const WavelengthPacket packet = among_others(400.0, kLanes, 0);
    std::array<double, kLanes> mean;
    for (std::size_t k = 0; k < kLanes; ++k) mean[k] = expected(packet.lambda_nm[k]);
    constexpr std::size_t kChunks = 64;
    std::vector<MeanSums> parts(kChunks);
    in_chunks(samples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const PixelSample sample =
                trace_sample(prepared, ray, start, packet, independent_key(7, i));
            double difference = 0.0;
            for (std::size_t k = 0; k < kLanes; ++k)
                difference += sample.radiance[k] / mean[k] - 1.0;
            parts[chunk].add(difference / kLanes);
        }
    });
    MeanSums all;
    for (const MeanSums& part : parts) all.add(part);
    return all;
}

template <class Expected>
void expect_light(const Scene& scene, std::size_t samples, Expected&& expected,
                  const Ray& ray = kRay) {
    const MeanSums sums = difference(scene, ray, samples, expected);
    // Where nothing is left to chance there is rounding alone.
    if (std::abs(sums.mean()) < kExact && sums.standard_error() < kExact) return;
    EXPECT_LT(std::abs(sums.z()), kSigmas) << "mean " << sums.mean();
    EXPECT_LT((kSigmas + kPower99) * sums.standard_error(), kDetectable);
    std::printf("    mean %+.4f, z %+.2f, detectable %.4f\n", sums.mean(), sums.z(),
                (kSigmas + kPower99) * sums.standard_error());
}

// A lamp at (2, 1, −3).
const Vec3 kLamp{2, 1, -3};
constexpr double kIntensity = 5.0;
double by_point(double lambda, double t) {
    const Vec3 to_lamp = kLamp - Vec3{0, 0, -t};
    const double r = length(to_lamp);
    return phase(-to_lamp.z / r) * kIntensity / (r * r) * std::exp(-sigma_t(lambda) * (r + t));
}

TEST(Haze, ScattersTheLightOfAPoint) {
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    scene.lights.push_back(PointLight{{kLamp}, make_constant(kIntensity)});
    expect_light(scene, 200000, [](double lambda) {
        return sigma_s(lambda) *
               along_ray(kLength, 3.0, [&](double t) { return by_point(lambda, t); });
    });
}

TEST(Haze, ScattersFromHereToInfinity) {
    Scene scene = hazy_scene();
    scene.lights.push_back(PointLight{{kLamp}, make_constant(kIntensity)});
    constexpr double kAllButAll = 200.0;  // e^(−30) of it lies beyond
    expect_light(scene, 300000, [](double lambda) {
        return sigma_s(lambda) *
               along_ray(kAllButAll, 3.0, [&](double t) { return by_point(lambda, t); });
    });
}

/// A black disc between lamp and ray: its shadow on the ray is dark.
TEST(Haze, LiesInShadow) {
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    scene.lights.push_back(PointLight{{kLamp}, make_constant(kIntensity)});
    // Half-way between the lamp and the ray: its shadow is twice as wide. It stands in the plane
    // of the lamp and the ray's points at t = 2 to 4.
    const Vec3 aside = normalised(Vec3{2, 1, 0});
    const Affine place = looking_at(0.5 * (kLamp + Vec3{0, 0, -3}), kLamp, {0, 0, 1});
    add(scene, Disc{0.25 * m}, {"disc", Black{}}, place);
    ASSERT_NEAR(dot(aside, normalised(kLamp - Vec3{0, 0, -3})), 1.0, 1e-12);
    expect_light(scene, 200000, [](double lambda) {
        const auto f = [&](double t) { return by_point(lambda, t); };
        static const QuadratureRule rule = gauss_legendre(200);
        return sigma_s(lambda) * (integrate(rule, 0.0, 2.5, f) + integrate(rule, 3.5, kLength, f));
    });
}

/// A ball of isotropic phase has the fluence 2π (1 − cos α) L; ours does not scatter alike, so that
/// a small ball is compared with a point.
TEST(Haze, ScattersTheLightOfASmallBall) {
    constexpr double kRadius = 0.01;
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    const double radiance = kIntensity / (kPi * kRadius * kRadius);
    add(scene, Sphere{kRadius * m}, lamp(radiance), translation(kLamp));
    // Its face is nearer than its centre by 2/3 of the radius on average.
    expect_light(scene, 200000, [](double lambda) {
        return std::exp(sigma_t(lambda) * 2.0 / 3.0 * kRadius) * sigma_s(lambda) *
               along_ray(kLength, 3.0, [&](double t) { return by_point(lambda, t); });
    });
}

/// A rectangle beside the ray that glows to one side, by quadrature over it.
TEST(Haze, ScattersTheLightOfAPanel) {
    constexpr double kRadiance = 2.0, kSide = 1.5;
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    // In the plane x = 1, glowing towards −x.
    add(scene, Rectangle{kSide * m, kSide * m}, lamp(kRadiance),
        translation({1, 0, -2}) * rotation({0, 1, 0}, -90.0 * deg));
    const QuadratureRule rule = gauss_legendre(24);
    expect_light(scene, 200000, [&](double lambda) {
        return sigma_s(lambda) * integrate(rule, 0.0, kLength, [&](double t) {
                   const auto at = [&](double y, double z) {
                       const Vec3 way{1.0, y, z + t};
                       const double r = length(way);
                       return phase(-way.z / r) * way.x / (r * r * r) *
                              std::exp(-sigma_t(lambda) * (r + t));
                   };
                   return kRadiance * integrate(rule, -0.5 * kSide, 0.5 * kSide, [&](double y) {
                              return integrate(rule, -2.0 - 0.5 * kSide, -2.0 + 0.5 * kSide,
                                               [&](double z) { return at(y, z); });
                          });
               });
    });
}

/// Parallel light is dimmed between the point and the eye alone: it is stated as it arrives.
TEST(Haze, ScattersSunlight) {
    const Vec3 travels = normalised({-1, -2, -1});
    Scene scene = hazy_scene();
    scene.lights.push_back(DistantLight{{travels}, 0.0 * deg, make_constant(3.0)});
    const auto share = [](double lambda, double length) {
        return sigma_s(lambda) / sigma_t(lambda) * -std::expm1(-sigma_t(lambda) * length);
    };
    expect_light(scene, 100000,
                 [&](double lambda) { return 3.0 * phase(travels.z) * share(lambda, 1e9); });
    add_wall(scene, kLength);
    expect_light(scene, 100000,
                 [&](double lambda) { return 3.0 * phase(travels.z) * share(lambda, kLength); });
    // In a sky that is the same everywhere each direction brings the same: p integrates to 1.
    scene.lights = {UniformEnvironment{make_constant(0.5)}};
    scene.shapes.clear();
    expect_light(scene, 400000, [&](double lambda) { return 0.5 * (1.0 + share(lambda, 1e9)); });
}

/// A beam across the ray, and a spot that shines past it in part.
TEST(Haze, ShowsABeamAndASpot) {
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    const Vec3 axis = normalised({-1, 0, -1});  // meets the ray at t = 2, aslant by 45°
    constexpr double kRadius = 0.01;
    const double half = kRadius * std::sqrt(2.0);
    scene.lights.push_back(
        BeamLight{{Vec3{0, 0, -2} - axis}, {axis}, kRadius * m, make_constant(40.0)});
    static const QuadratureRule rule = gauss_legendre(100);
    const double turned = phase(axis.z);
    const auto beam = [&](double lambda) {
        return sigma_s(lambda) * integrate(rule, 2.0 - half, 2.0 + half, [&](double t) {
                   const double way = 1.0 + (t - 2.0) * std::sqrt(0.5);
                   return 40.0 * turned * std::exp(-sigma_t(lambda) * (way + t));
               });
    };
    expect_light(scene, 200000, beam);

    scene.lights = {SpotLight{{kLamp},
                              {normalised(Vec3{0, 0, -3} - kLamp)},
                              0.0 * deg,
                              20.0 * deg,
                              make_constant(kIntensity)}};
    const double r = length(kLamp - Vec3{0, 0, -3}), reach = r * std::tan(20.0 * kPi / 180.0);
    const double cos_outer = std::cos(20.0 * kPi / 180.0);
    expect_light(scene, 200000, [&](double lambda) {
        return sigma_s(lambda) * along_ray(3.0 + reach, 3.0, [&](double t) {
                   if (t < 3.0 - reach) return 0.0;
                   const double cosine = r / std::hypot(r, t - 3.0);
                   const double inside = (cosine - cos_outer) / (1.0 - cos_outer);
                   return inside * inside * by_point(lambda, t);
               });
    });
}

/// By a mirror the ray goes on through haze, dimmed by all of its way.
TEST(Haze, IsSeenInAMirror) {
    Scene scene = hazy_scene();
    add(scene, Disc{1.0 * m}, {"mirror", Mirror{make_constant(1.0)}}, translation({0, 0, -1}));
    add(scene, Rectangle{9.0 * m, 9.0 * m}, {"wall", Black{}}, translation({0, 0, 3}));
    scene.lights.push_back(PointLight{{{0, 1, 0.5}}, make_constant(kIntensity)});
    expect_light(scene, 200000, [](double lambda) {
        const auto f = [&](double z, double direction, double way) {
            const Vec3 to_lamp = Vec3{0, 1, 0.5} - Vec3{0, 0, z};
            const double r = length(to_lamp);
            return phase(to_lamp.z * direction / r) * kIntensity / (r * r) *
                   std::exp(-sigma_t(lambda) * (r + way));
        };
        static const QuadratureRule rule = gauss_legendre(200);
        return sigma_s(lambda) *
               (integrate(rule, 0.0, 1.0, [&](double t) { return f(-t, -1.0, t); }) +
                integrate(rule, 0.0, 4.0, [&](double t) { return f(-1.0 + t, 1.0, 1.0 + t); }));
    });
}

/// What gives light is dimmed by what haze scatters and absorbs. A path of depth 0 looks for
/// nothing that is scattered.
TEST(Haze, DimsWhatIsBehindIt) {
    Scene scene = hazy_scene();
    scene.render.max_depth = 0;
    add(scene, Rectangle{1.0 * m, 1.0 * m}, lamp(7.0), translation({0, 0, -kLength}));
    const PreparedScene prepared(scene);
    for (const double nm : {400.0, 700.0})
        EXPECT_NEAR(
            trace_sample(prepared, kRay, {}, one_wavelength(nm), independent_key(3, 0)).radiance[0],
            7.0 * std::exp(-sigma_t(nm) * kLength), 1e-12);
}

/// The power that haze scatters out of a beam is σ_s × length × flux. All rays that meet a ball
/// around it see all of it.
TEST(Haze, KeepsThePowerOfABeam) {
    constexpr double kRadius = 0.2, kBall = 0.5, kThin = 1e-9;
    Scene scene = empty_scene(16);
    Medium thin = *plain(1.0, nullptr, -1000);
    thin.scattering = make_constant(kThin);
    thin.phase = henyey_greenstein(kG);
    scene.surroundings = std::make_shared<Medium>(thin);
    // From x = −0.4 to 0.4, where a black wall takes it. Rays that come from the wall begin there.
    scene.lights.push_back(BeamLight{{{-0.4, 0, 0}}, {{1, 0, 0}}, kRadius * m, make_constant(1.0)});
    add(scene, Disc{kRadius * m}, {"end", Black{}},
        translation({0.4, 0, 0}) * rotation({0, 1, 0}, 90.0 * deg));
    const PreparedScene prepared(scene);
    const double power = kThin * 0.8 * kPi * kRadius * kRadius;
    const double lines = 4.0 * kPi * kPi * kBall * kBall;  // m² sr
    constexpr std::size_t kSamples = 800000, kChunks = 64;
    std::vector<MeanSums> parts(kChunks);
    in_chunks(kSamples, kChunks, [&](std::size_t chunk, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const SampleKey key = independent_key(11, i);
            const auto a = test_numbers(key, 0), b = test_numbers(key, 1);
            const Dir<World> direction = sample_uniform_sphere<World>(a[0], a[1]);
            const DiscPoint p = sample_concentric_disc(b[0], b[1]);
            Vec3 from = around(direction, {{kBall * p.x, kBall * p.y, -1.0}}).v;
            if (from.x >= 0.4 && direction.v.x < 0.0)
                from += direction.v * ((0.4 - 1e-9 - from.x) / direction.v.x);
            const double radiance =
                trace_sample(prepared, {from, direction.v, {}}, {}, one_wavelength(500.0), key)
                    .radiance[0];
            parts[chunk].add(radiance * lines / power - 1.0);
        }
    });
    MeanSums all;
    for (const MeanSums& part : parts) all.add(part);
    EXPECT_LT(std::abs(all.z()), kSigmas) << all.mean();
    EXPECT_LT((kSigmas + kPower99) * all.standard_error(), 2.0 * kDetectable);
}

/// Each of these wrong expectations is found.
TEST(Haze, SeesPlantedErrors) {
    Scene scene = hazy_scene();
    add_wall(scene, kLength);
    scene.lights.push_back(PointLight{{kLamp}, make_constant(kIntensity)});
    const auto found = [&](auto&& wrong) {
        return std::abs(difference(scene, kRay, 200000, [&](double lambda) {
                            return along_ray(kLength, 3.0,
                                             [&](double t) { return wrong(lambda, t); });
                        }).z()) > kSigmas;
    };
    EXPECT_FALSE(found([](double l, double t) { return sigma_s(l) * by_point(l, t); }));
    // Scattering by extinction; a way that is dimmed by scattering alone; the phase function's
    // angle turned round; the wavelength beside.
    EXPECT_TRUE(found([](double l, double t) { return sigma_t(l) * by_point(l, t); }));
    EXPECT_TRUE(found([](double l, double t) {
        return sigma_s(l) * by_point(l, t) * std::exp(kAbsorption * t);
    }));
    EXPECT_TRUE(found([](double l, double t) {
        const double cosine = (t - 3.0) / length(kLamp - Vec3{0, 0, -t});
        return sigma_s(l) * by_point(l, t) * phase(cosine) / phase(-cosine);
    }));
    EXPECT_TRUE(found([](double l, double t) { return sigma_s(l + 15.0) * by_point(l, t); }));
}

}  // namespace
}  // namespace dewbow
