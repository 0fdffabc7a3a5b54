// SPDX-License-Identifier: Apache-2.0
// With everything put right that 1989 left out, distributed_1989 is a second way to compute what
// `path` computes: with 400 samples of the CIE's spectrum, real indices, reflectance by wavelength,
// spectral transport and a free sum the two agree. Light of first order: nothing is rough.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "dewbow/import/import.h"
#include "dewbow/render/distributed_1989/ray_tree.h"
#include "estimate.h"

namespace dewbow {
namespace {

using namespace kit;

/// Along rays through the middles of a grid of the picture, so that only what the two methods draw
/// at random differs, and no edges between pixels do.
constexpr std::size_t kRaysASide = 8, kRays = kRaysASide * kRaysASide;
/// Independent numbers of path, each the mean of paths that are stratified against each other; and
/// trees.
constexpr std::uint32_t kReplicates = 16, kPaths = 1024, kTrees = 16;
/// Surfaces that a ray meets; without roulette and least weight both methods see the same light.
constexpr int kDepth = 5;

/// The error of all of XYZ that is found with a probability of 0.99: three thousandths at the most.
constexpr double kFinds = 0.003;

/// What a test plants.
struct Plant {
    void (*settings)(Distributed1989Settings&) = nullptr;
    void (*result)(Triple&) = nullptr;
};

Distributed1989Settings corrected() {
    Distributed1989Settings settings;
    settings.model.colours = SpectralColours::cie;
    // One offset for all intervals: the sum over them is the integral on average.
    settings.sampling = {400, Jitter::both, true, false};
    settings.sum = SampleSum::free;
    settings.transport = RgbOrSpectral::spectral;
    settings.index = IndexSource::scene;
    settings.reflectance = ReflectanceAt::spectral;
    settings.least_weight = 0.0;
    return settings;
}

/// The mean of kPaths paths.
Triple by_path(const PreparedScene& prepared, const Ray& ray, std::uint64_t stream) {
    Triple mean{};
    for (std::uint32_t i = 0; i < kPaths; ++i) {
        const SampleKey key(stream, i);
        // As trace_pixel_sample does: stratified with the first choice.
        const WavelengthPacket packet = sample_wavelengths(
            WavelengthSampling::visual, 8, key.third(0, Purpose::pixel_filter) / 8.0);
        const PixelSample sample = trace_sample(prepared, ray, prepared.camera_media, packet, key);
        const Colour<Xyz> xyz = xyz_from_lanes(packet, std::span(sample.radiance).first(8));
        for (std::size_t c = 0; c < 3; ++c) mean[c] += xyz[c] / (cie_y_integral() * kPaths);
    }
    return mean;
}

using SumsOfRays = std::array<VectorSums, kRays>;

Ray ray_of(const CameraRays& camera, const Film& film, std::size_t i) {
    const double side = double(film.width) / kRaysASide;
    return camera.ray_through((double(i % kRaysASide) + 0.5) * side,
                              (double(i / kRaysASide) + 0.5) * side);
}

struct Reference {
    Scene scene;
    SumsOfRays path;
};

/// That of a scene of bench/scenes, computed once.
const Reference& reference(const std::string& file) {
    static std::map<std::string, Reference> references;
    const auto [place, is_new] = references.try_emplace(file);
    Reference& reference = place->second;
    if (!is_new) return reference;
    const auto path = std::filesystem::path(DEWBOW_SOURCE_DIR) / "bench/scenes" / file;
    reference.scene = load_scene(path).scene;
    Scene& scene = reference.scene;
    scene.render.max_depth = scene.render.roulette_depth = kDepth;
    const PreparedScene prepared(scene);
    parallel_for(kRays, [&](std::size_t i) {
        const Ray ray = ray_of(prepared.camera, scene.film, i);
        for (std::uint32_t n = 0; n < kReplicates; ++n)
            reference.path[i].add(by_path(prepared, ray, stream_key(1, std::uint32_t(i), n)));
    });
    return reference;
}

SumsOfRays by_trees(const Scene& scene, const Plant& plant) {
    const distributed_1989::Method method(scene);
    const PreparedScene& prepared = method.prepared();
    SumsOfRays sums;
    parallel_for(kRays, [&](std::size_t i) {
        distributed_1989::Workspace workspace(method);
        for (std::uint32_t n = 0; n < kTrees; ++n) {
            const SampleKey key(stream_key(2, std::uint32_t(i), n), 0);
            distributed_1989::RayTree tree(method, key, workspace);
            Triple xyz =
                tree.grow(ray_of(prepared.camera, scene.film, i), prepared.camera_media).colour->v;
            if (plant.result) plant.result(xyz);
            sums[i].add(xyz);
        }
    });
    return sums;
}

struct Comparison {
    double score;       ///< T² of the difference of the two methods, summed over all rays
    double detectable;  ///< the share of all of XYZ that it would find
};

Comparison compare(const std::string& file, const Plant& plant = {}) {
    const Reference& reference = dewbow::reference(file);
    Scene scene = reference.scene;
    scene.render.distributed_1989 = corrected();
    if (plant.settings) plant.settings(scene.render.distributed_1989);
    const SumsOfRays trees = by_trees(scene, plant);
    Triple difference{};
    Matrix3 covariance;
    double luminance = 0.0;
    for (std::size_t i = 0; i < kRays; ++i) {
        const VectorSums& path = reference.path[i];
        const Matrix3 a = path.covariance_of_mean(), b = trees[i].covariance_of_mean();
        luminance += path.mean()[1];
        for (std::size_t c = 0; c < 3; ++c) {
            difference[c] += path.mean()[c] - trees[i].mean()[c];
            for (std::size_t d = 0; d < 3; ++d) covariance[c][d] += a[c][d] + b[c][d];
        }
    }
    return {hotelling(difference, covariance), detectable_share(covariance[1][1], luminance)};
}

// The covariance is a sum over some tens of rays that matter, of 16 replicates and 16 trees each:
// false alarms are a few times as frequent as kChi3At1em6 says, below 1e-5 a scene.
TEST(Distributed1989AndPath, AgreeWhereEverythingIsPutRight) {
    for (const char* file : {"disc.toml", "slab.toml", "diamond.toml"}) {
        const Comparison found = compare(file);
        EXPECT_LT(found.score, kChi3At1em6) << file;
        EXPECT_LT(found.detectable, kFinds) << file;
    }
}

struct Bug {
    const char* name;
    Plant plant;
    std::vector<std::string> files{"disc.toml", "slab.toml", "diamond.toml"};
};
const Bug kBugs[] = {
    {"reflectance by the nominal index",
     {[](Distributed1989Settings& s) { s.reflectance = ReflectanceAt::nominal; }}},
    {"a straight index", {[](Distributed1989Settings& s) { s.index = IndexSource::linear; }}},
    {"colours jittered about 13 indices",
     {[](Distributed1989Settings& s) {
         s.sampling = {13, Jitter::colour, true, false};
     }},
     {"disc.toml"}},
    {"sums clamped",
     {[](Distributed1989Settings& s) { s.sum = SampleSum::clamp; }},
     {"diamond.toml"}},  // elsewhere nothing is brighter than white
    {"a sample of 400 lost",
     {nullptr,
      [](Triple& xyz) {
          for (double& value : xyz) value *= 399.0 / 400.0;
      }}},
    {"red and blue exchanged", {nullptr, [](Triple& xyz) { std::swap(xyz[0], xyz[2]); }}},
};

TEST(Distributed1989AndPath, PlantedBugsAreFound) {
    for (const Bug& bug : kBugs)
        for (const std::string& file : bug.files) {
            const Comparison found = compare(file, bug.plant);
            EXPECT_GT(found.score, kChi3At1em6) << bug.name << " in " << file;
        }
}

}  // namespace
}  // namespace dewbow
