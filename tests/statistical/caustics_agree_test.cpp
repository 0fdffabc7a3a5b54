// SPDX-License-Identifier: Apache-2.0

// Camera and light paths together give what camera paths give alone, where lamps are so large that
// those find them: the weights of each path's shape sum to one, whoever finds it.

#include <gtest/gtest.h>

#include "../analytic/pictures.h"
#include "../analytic/welch.h"
#include "caustic_scenes.h"
#include "planted_caustics.h"

namespace dewbow {
namespace {

using namespace kit;

constexpr int kReplicates = 16;
/// Of one comparison. A scene makes kRegions, all together below 1e-4.
constexpr double kFalseAlarm = 1e-6;
/// X, Y, Z of the whole picture and Y of its quarters.
constexpr std::size_t kRegions = 7;
/// An error of this share of the whole's Y is found with probability 0.99, or the test calls itself
/// too weak.
constexpr double kDetectable = 0.09;
/// Of `path` (the other method is less noisy).
constexpr int kSamples = 24;

using Regions = std::array<double, kRegions>;

Regions picture(const Scene& scene, const MakeEstimator& make, int samples, std::uint64_t seed) {
    const FilmSums film = film_of(scene, make, samples, seed).film;
    Regions regions{};
    const double pixels = double(film.crop().area());
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
            const Colour<Xyz> xyz = film.xyz(x, y);
            for (std::size_t c = 0; c < 3; ++c) regions[c] += xyz[c] / pixels;
            const int quarter = (2 * y / film.height()) * 2 + 2 * x / film.width();
            regions[std::size_t(3 + quarter)] += xyz[1] / pixels;
        }
    return regions;
}

/// One list of pictures for each region.
using Pictures = std::array<std::vector<double>, kRegions>;
Pictures pictures(const Scene& scene, const MakeEstimator& make, int samples, std::uint64_t seed) {
    Pictures result;
    for (std::uint64_t r = 0; r < kReplicates; ++r) {
        const Regions one = picture(scene, make, samples, seed + r);
        for (std::size_t i = 0; i < kRegions; ++i) result[i].push_back(one[i]);
    }
    return result;
}

struct Compared {
    double chance = 1.0;      ///< least of all regions
    double difference = 0.0;  ///< of the whole's Y, share of it
    double detectable = 0.0;  ///< of the whole's Y, share of it
};
Compared compare(const Pictures& a, const Pictures& b) {
    Compared result;
    for (std::size_t i = 0; i < kRegions; ++i)
        result.chance = std::min(result.chance, welch(a[i], b[i]).chance);
    const WelchTest y = welch(a[1], b[1]);
    result.difference = y.difference / mean_of(b[1]).mean;
    result.detectable = y.detectable(kFalseAlarm) / mean_of(b[1]).mean;
    return result;
}
constexpr std::uint64_t kOtherSeed = 1000;

void expect_agreement(const NamedScene& row, double samples_factor, double detectable) {
    const Scene scene = row.make();
    const int samples = int(kSamples * samples_factor);
    const Compared found = compare(pictures(scene, method("caustics"), samples, 0),
                                   pictures(scene, method("path"), samples, kOtherSeed));
    EXPECT_GT(found.chance, kFalseAlarm) << row.name;
    EXPECT_LT(found.detectable, detectable) << "too few samples";
    std::printf("    %s: least chance %.2g, difference %.4f, detectable %.4f\n", row.name,
                found.chance, found.difference, found.detectable);
}

class CausticsAgree : public ::testing::TestWithParam<NamedScene> {};
TEST_P(CausticsAgree, WithPath) { expect_agreement(GetParam(), 1.0, kDetectable); }
INSTANTIATE_TEST_SUITE_P(Scenes, CausticsAgree, ::testing::ValuesIn(kCausticScenes),
                         [](const auto& each) { return std::string(each.param.name); });

/// 100 times the samples: 0.9 %. About half an hour on 2 cores.
class LongCausticsAgree : public ::testing::TestWithParam<NamedScene> {};
TEST_P(LongCausticsAgree, WithPath) { expect_agreement(GetParam(), 100.0, kDetectable / 10.0); }
INSTANTIATE_TEST_SUITE_P(LongScenes, LongCausticsAgree, ::testing::ValuesIn(kCausticScenes),
                         [](const auto& each) { return std::string(each.param.name); });

// ---- planted bugs ------------------------------------------------------------------------------

/// Camera paths of one method with light paths of another.
class Joined : public Estimator {
public:
    Joined(EstimatorPtr camera, EstimatorPtr light)
        : camera_(std::move(camera)), light_(std::move(light)) {}
    void render(const Unit& unit, FilmSums& film) const override { camera_->render(unit, film); }
    double light_paths() const override { return light_->light_paths(); }
    void trace_light(const LightUnit& unit, SplatList& splats) const override {
        light_->trace_light(unit, splats);
    }

private:
    EstimatorPtr camera_, light_;
};
/// The scene of one side's method; it lives as long as the test.
EstimatorPtr caustics_of(const Scene& scene, double light_paths) {
    static std::vector<std::unique_ptr<Scene>> scenes;
    scenes.push_back(std::make_unique<Scene>(scene));
    scenes.back()->render.caustics.light_paths = light_paths;
    return method("caustics")(*scenes.back());
}

/// The scene of most plants.
Compared compare_planted(const MakeEstimator& planted) {
    constexpr int kSamplesOfPlants = 2 * kSamples;
    static const Scene scene = glass_ball();
    static const Pictures path = pictures(scene, method("path"), kSamplesOfPlants, kOtherSeed);
    return compare(pictures(scene, planted, kSamplesOfPlants, 0), path);
}
void expect_red(const MakeEstimator& planted) {
    const Compared found = compare_planted(planted);
    EXPECT_LT(found.chance, kFalseAlarm);
    std::printf("    least chance %.2g, difference %.4f\n", found.chance, found.difference);
}

TEST(CausticsAgreePlants, AShapeCountedTwice) {
    expect_red([](const Scene& scene) {
        return std::make_unique<Joined>(method("path")(scene), caustics_of(scene, 1.0));
    });
}
TEST(CausticsAgreePlants, AShapeLost) {
    expect_red([](const Scene& scene) {
        return std::make_unique<Joined>(caustics_of(scene, 1.0), method("path")(scene));
    });
}
TEST(CausticsAgreePlants, ANumberOfLightPathsThatOneSideDoesNotKnow) {
    expect_red([](const Scene& scene) {
        return std::make_unique<Joined>(caustics_of(scene, 0.001), caustics_of(scene, 1.0));
    });
}

template <class Walk>
MakeEstimator by() {
    return [](const Scene& scene) { return std::make_unique<CausticsBy<Walk>>(scene); };
}
TEST(CausticsAgreePlants, ALaneOfEightThatNeverArrives) { expect_red(by<LosesALane>()); }
TEST(CausticsAgreePlants, OpenedLanesThatWeighTwice) { expect_red(by<WeighsOpenLanesTwice>()); }
TEST(CausticsAgreePlants, ReflectionAndRefractionSwapped) {
    expect_red(by<SwapsReflectionAndRefraction>());
}
TEST(CausticsAgreePlants, AndWithoutAFaultAllIsWell) {
    EXPECT_GT(compare_planted(by<SoundWalk>()).chance, kFalseAlarm);
}

/// Rain takes 40 % of what it is to take from light paths.
TEST(CausticsAgreePlants, RainThatLightPathsDoNotKnow) {
    const Scene scene = glass_ball_in_rain();
    const Compared found =
        compare(pictures(
                    scene,
                    [](const Scene& wet) {
                        static std::vector<std::unique_ptr<Scene>> dry;
                        dry.push_back(std::make_unique<Scene>(wet));
                        dry.back()->rains.clear();
                        return std::make_unique<Joined>(caustics_of(wet, 1.0),
                                                        method("caustics")(*dry.back()));
                    },
                    2 * kSamples, 0),
                pictures(scene, method("path"), 2 * kSamples, kOtherSeed));
    EXPECT_LT(found.chance, kFalseAlarm);
    std::printf("    least chance %.2g, difference %.4f\n", found.chance, found.difference);
}

/// Of casters rough glass alone is asked for the lamp.
TEST(CausticsAgreePlants, ADensityOfNextEventThatOneSideDoesNotKnow) {
    constexpr int kSamplesOfPlant = 2 * kSamples;
    const Scene scene = rough_glass();
    const Pictures path = pictures(scene, method("path"), kSamplesOfPlant, kOtherSeed);
    const Compared found =
        compare(pictures(scene, by<LeavesRoughGlassToNextEvent>(), kSamplesOfPlant, 0), path);
    const Compared sound = compare(pictures(scene, by<SoundWalk>(), kSamplesOfPlant, 0), path);
    EXPECT_LT(found.chance, kFalseAlarm);
    EXPECT_GT(sound.chance, kFalseAlarm);
    std::printf("    least chance %.2g, difference %.4f; without the fault %.2g, %.4f\n",
                found.chance, found.difference, sound.chance, sound.difference);
}

}  // namespace
}  // namespace dewbow
