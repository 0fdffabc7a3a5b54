// SPDX-License-Identifier: Apache-2.0

// Haze that light paths shine through, against what camera paths see of the same light, and
// against closed forms.

#include <gtest/gtest.h>

#include "dewbow/render/caustics/caustics.h"
#include "dewbow/spectrum/cie.h"
#include "scene_kit.h"
#include "statistics.h"

namespace dewbow {
namespace {

using namespace kit;

/// Two-sided 1e-8 for one z of a normal distribution. The mean of 24 replicates has Student's,
/// whose tail beyond is 1e-5: below 2e-4 for all of this file.
constexpr double kSigmas = 5.73;
constexpr std::size_t kReplicates = 24;
/// An error of this share of what is expected is found with probability 0.99.
constexpr double kDetectable = 0.05;
/// Light paths bring at least this share of what is compared.
constexpr double kLeastByLight = 0.15;

MediumPtr haze(double scattering, double absorption) {
    Medium haze = *plain(1.0, make_constant(absorption), -1000);
    haze.scattering = make_constant(scattering);
    haze.phase = henyey_greenstein(0.4);
    return std::make_shared<Medium>(haze);
}

/// Seen from the side, between x = −1 and 1, in parallel.
Scene seen_from_the_side(MediumPtr surroundings) {
    Scene scene = empty_scene(16);
    scene.surroundings = std::move(surroundings);
    scene.film.width = 8, scene.film.height = 4;
    scene.film.filter = {FilterKind::box, 0.5};  // no light of one half in the other
    scene.camera.projection = Orthographic{1.0 * m};
    scene.camera.world_from_camera =
        Transform<World, Camera>(looking_at({0, 0, 2}, {0, 0, 0}, {0, 1, 0}));
    scene.render.samples_per_pixel = 32;
    scene.render.caustics.light_paths = 4.0;
    // Walls to the right and behind. The right one is not seen; what it throws back is scattered by
    // no haze.
    add(scene, Rectangle{6.0 * m, 6.0 * m}, diffuse(0.8),
        translation({1.5, 0, 0}) * rotation({0, 1, 0}, 90.0 * deg));
    add(scene, Rectangle{3.0 * m, 6.0 * m}, {"wall", Black{}}, translation({0, 0, -1}));
    return scene;
}

/// A slab across x = 0.
void add_slab(Scene& scene, MediumPtr glass, double thickness) {
    add(scene, Box{thickness * m, 3.0 * m, 1.6 * m}, dielectric(std::move(glass)));
}

/// Mean Y of the halves x < 0 and x > 0.
struct Halves {
    double left = 0.0, right = 0.0;
    double both() const { return 0.5 * (left + right); }
};
struct Render {
    Halves camera, light;
    Halves all() const { return {camera.left + light.left, camera.right + light.right}; }
};

Render render(Scene scene, const char* estimator_name, std::size_t replicate) {
    scene.render.seed = 1000 + replicate;
    const int width = scene.film.width, height = scene.film.height;
    const double pixels = 0.5 * width * height;
    FilmLayout layout;
    layout.width = width, layout.height = height, layout.crop = {0, 0, width, height};
    const auto estimator = std::string(estimator_name) == "path" ? make_path_estimator(scene)
                                                                 : make_caustics_estimator(scene);
    FilmSums film(layout);
    estimator->render({layout.crop, 0, scene.render.samples_per_pixel}, film);
    Render result;
    const auto half = [&](Halves& halves, int x) -> double& {
        return 2 * x < width ? halves.left : halves.right;
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) half(result.camera, x) += film.xyz(x, y)[1] / pixels;
    if (!(estimator->light_paths() > 0.0)) return result;
    SplatList splats(layout);
    const auto paths =
        std::uint64_t(estimator->light_paths() * 2.0 * pixels * scene.render.samples_per_pixel);
    estimator->trace_light({0, 0, paths}, splats);
    for (const Splat& splat : splats.splats())
        half(result.light, int(splat.pixel) % width) += splat.xyz[1] / double(paths) / pixels;
    return result;
}

/// Of what `value` gives for each replicate.
template <class Value>
MeanSums replicates(Value&& value) {
    std::vector<double> values(kReplicates);
    parallel_for(kReplicates, [&](std::size_t i) { values[i] = value(i); });
    MeanSums sums;
    for (const double v : values) sums.add(v);
    return sums;
}

struct LampCase {
    const char* name;
    double scattering;  ///< of the haze, m⁻¹
    void (*add)(Scene&);
};
const LampCase kLamps[] = {
    {"point", 0.3,
     [](Scene& s) {
         s.lights.push_back(PointLight{{{-1.3, 0.1, 0.1}}, make_constant(1.0)});
     }},
    {"spot", 0.3,
     [](Scene& s) {
         s.lights.push_back(SpotLight{{{-1.3, 0.1, 0.1}},
                                      {normalised(Vec3{1, 0.1, 0})},
                                      5.0 * deg,
                                      60.0 * deg,
                                      make_constant(1.0)});
     }},
    {"beam", 0.3,
     [](Scene& s) {
         s.lights.push_back(BeamLight{
             {{-0.9, 0.1, 0}}, {normalised(Vec3{1, -0.1, 0.05})}, 0.15 * m, make_constant(1.0)});
     }},
    {"panel", 0.3,
     [](Scene& s) {
         add(s, Rectangle{0.3 * m, 0.2 * m}, lamp(1.0),
             translation({-1.3, 0.1, 0}) * rotation({0, 1, 0}, 90.0 * deg));
     }},
    // The sun's light is dimmed from the first glass on, so that a slab makes a difference: thin
    // haze.
    {"sun", 1e-3,
     [](Scene& s) {
         s.lights.push_back(
             DistantLight{{normalised(Vec3{1, -0.4, -0.2})}, 3.0 * deg, make_constant(1.0)});
     }},
    {"parallel", 1e-3,
     [](Scene& s) {
         s.lights.push_back(
             DistantLight{{normalised(Vec3{1, -0.4, -0.2})}, 0.0 * deg, make_constant(1.0)});
     }},
};

/// A slab that bends next to nothing does not show; but all light that goes through it, or would,
/// is brought by light paths.
TEST(HazeByLight, IsWhatTheCameraFindsAlone) {
    for (const LampCase& lamp : kLamps) {
        SCOPED_TRACE(lamp.name);
        Scene bare = seen_from_the_side(haze(lamp.scattering, lamp.scattering / 3.0));
        lamp.add(bare);
        Scene slab = bare;
        add_slab(slab, plain(1.0 + 1e-6), 1e-5);
        std::vector<Render> alone(kReplicates), shared(kReplicates);
        parallel_for(2 * kReplicates, [&](std::size_t i) {
            if (i < kReplicates)
                alone[i] = render(bare, "path", i);
            else
                shared[i - kReplicates] = render(slab, "caustics", i);
        });
        MeanSums left, right, twice, lost;
        double light = 0.0;
        for (std::size_t i = 0; i < kReplicates; ++i) {
            const Halves a = alone[i].camera, s = shared[i].all();
            left.add(s.left / a.left - 1.0), right.add(s.right / a.right - 1.0);
            light += shared[i].light.both() / s.both() / kReplicates;
            // Planted: light paths bring what the camera keeps; the camera gives up what is not
            // brought.
            twice.add((a.both() + shared[i].light.both()) / a.both() - 1.0);
            lost.add(shared[i].camera.both() / a.both() - 1.0);
        }
        EXPECT_LT(std::abs(left.z()), kSigmas) << left.mean();
        EXPECT_LT(std::abs(right.z()), kSigmas) << right.mean();
        for (const MeanSums* side : {&left, &right})
            EXPECT_LT((kSigmas + kPower99) * side->standard_error(), kDetectable);
        EXPECT_GT(light, kLeastByLight);
        EXPECT_GT(twice.z(), kSigmas);
        EXPECT_LT(lost.z(), -kSigmas);
        std::printf("    %s: left %+.4f, right %+.4f, detectable %.3f, by light %.2f\n", lamp.name,
                    left.mean(), right.mean(), (kSigmas + kPower99) * left.standard_error(), light);
    }
}

/// A beam meets a slab of flint squarely: R' = 2R / (1 + R) comes back, and 1 − R' goes on. Lanes
/// open at the slab, and go the same way. In thin haze each metre of the beam scatters
/// σ_s p(90°) of its flux to the side.
TEST(HazeByLight, IsABeamBeforeAndBehindASlab) {
    constexpr double kThin = 1e-9, kRadius = 0.2;
    Scene scene = seen_from_the_side(haze(kThin, 0.0));
    scene.lights.push_back(BeamLight{{{-1.2, 0, 0}}, {{1, 0, 0}}, kRadius * m, make_constant(1.0)});
    const MediumPtr flint = glass("schott/N-SF11");
    add_slab(scene, flint, 1e-3);
    std::vector<double> lambda_nm, transmitted, before;
    for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0) {
        const double n = index_of(*flint, nm), r = std::pow((n - 1.0) / (n + 1.0), 2.0);
        lambda_nm.push_back(nm);
        transmitted.push_back((1.0 - r) / (1.0 + r));
        before.push_back(1.0 + 2.0 * r / (1.0 + r));
    }
    // A metre of the beam is seen in half of the picture, a square of 1 m. g = 0.4.
    const double across =
        kThin * kPi * kRadius * kRadius * 0.84 / (4.0 * kPi * std::pow(1.16, 1.5));
    const auto y_of = [&](const std::vector<double>& values) {
        return across *
               xyz_from_spectrum(*make_tabulated(lambda_nm, values, OutsideTable::hold))[1] /
               cie_y_integral();
    };
    const double left = y_of(before), right = y_of(transmitted);
    std::vector<Render> renders(kReplicates);
    parallel_for(kReplicates, [&](std::size_t i) { renders[i] = render(scene, "caustics", i); });
    MeanSums on_left, on_right, no_return;
    for (const Render& r : renders) {
        on_left.add(r.all().left / left - 1.0), on_right.add(r.all().right / right - 1.0);
        no_return.add(r.all().left / across - 1.0);  // planted: nothing is reflected
    }
    EXPECT_LT(std::abs(on_left.z()), kSigmas) << on_left.mean();
    EXPECT_LT(std::abs(on_right.z()), kSigmas) << on_right.mean();
    EXPECT_LT((kSigmas + kPower99) * on_right.standard_error(), kDetectable);
    EXPECT_GT(no_return.z(), kSigmas);
    std::printf("    left %+.4f, right %+.4f, detectable %.3f\n", on_left.mean(), on_right.mean(),
                (kSigmas + kPower99) * on_right.standard_error());
}

}  // namespace
}  // namespace dewbow
