// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/weather/drop_collisions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/optics/catalogue.h"
#include "dewbow/sky/drop_cloud.h"

namespace dewbow {
namespace {

using namespace unit;

DropCloudPtr drops(const char* sizes, double extinction_per_m) {
    DropCloudRequest request;
    request.model = "descartes";
    request.showers = {parse_drop_sizes(sizes)};
    request.optics = {make_dispersion(find_glass("water@20C").data),
                      make_dispersion(find_glass("air").data), 0.0};
    request.amount = RainExtinction{extinction_per_m};
    return make_drop_cloud(request);
}

/// Two layers that overlap between 2 and 3 m, and a ray straight up from 1 m below them.
class RainInTwoLayers : public ::testing::Test {
protected:
    RainInTwoLayers() : scene_(make_empty_scene()) {
        static const DropCloudPtr low = drops("0.5mm", 0.2), high = drops("0.1mm", 0.5);
        scene_.rains.push_back({"low", ConvexRegion::layer(0.0 * m, 3.0 * m), low, {}});
        scene_.rains.push_back({"high", ConvexRegion::layer(2.0 * m, 5.0 * m), high, {}});
        weather_.emplace(scene_);
        packet_ = sample_wavelengths(WavelengthSampling::uniform, 4, 0.5);
        lanes_ = LaneSet::all(packet_);
        memory_.begin(scene_.rains, weather_->suns(), packet_);
    }
    Way way(double length) const {
        return {{0, -1, 0}, {0, 1, 0}, length, 0, Purpose::drop_distance};
    }
    /// Optical depth from the ray's start to `t`.
    double depth(int k, double t) {
        const auto within = [&](double a, double b) { return std::max(0.0, std::min(t, b) - a); };
        return memory_.rain(0).extinction[std::size_t(k)] * within(1.0, 4.0) +
               memory_.rain(1).extinction[std::size_t(k)] * within(3.0, 6.0);
    }
    /// Mean over lanes of the probability to meet a drop before `t`.
    double met(double t) {
        double sum = 0.0;
        for (int k = 0; k < lanes_.count; ++k) sum -= std::expm1(-depth(k, t)) / lanes_.count;
        return sum;
    }

    Scene scene_;
    std::optional<Weather> weather_;
    WavelengthPacket packet_;
    LaneSet lanes_;
    PacketWeather memory_;
};

TEST_F(RainInTwoLayers, DistancesHaveTheMeanDensityOfTheLanes) {
    constexpr int kCount = 20000;
    // Even steps of u are even in each lane's distances, but for its first and last step.
    constexpr double kStepError = 2.0 * 4.0 / kCount;
    for (const double length : {4.5, 100.0, std::numeric_limits<double>::infinity()}) {
        DropCollisions collisions;
        collisions.look(*weather_, memory_, lanes_, way(length));
        const double all = met(length);
        EXPECT_NEAR(collisions.probability(), all, 1e-14);
        for (const double t : {1.5, 2.9, 3.5, 4.2, 5.5}) {
            int below = 0;
            for (int i = 0; i < kCount; ++i) {
                const DropCollisions::Place place = collisions.sample((i + 0.5) / kCount);
                below += place.distance < t;
            }
            EXPECT_NEAR(below / double(kCount), std::min(met(t), all) / all, kStepError) << t;
        }
        for (const double u : {0.01, 0.3, 0.62, 0.99}) {
            const DropCollisions::Place place = collisions.sample(u);
            constexpr double kStep = 1e-5;
            const double slope =
                (met(place.distance + kStep) - met(place.distance - kStep)) / (2.0 * kStep * all);
            EXPECT_NEAR(place.pdf, slope, 1e-8);  // central difference: kStep² and rounding
        }
    }
}

TEST_F(RainInTwoLayers, NothingIsMetOutsideOfIt) {
    DropCollisions collisions;
    collisions.look(*weather_, memory_, lanes_, way(0.9));
    EXPECT_EQ(collisions.probability(), 0.0);
    EXPECT_FALSE(collisions.turn(0.5, 0.5, {0.5, 0.5}));
}

// Over all directions, what is scattered is the rains' scattering coefficients together; of one
// rain, of the other, and of both.
TEST_F(RainInTwoLayers, TurnsSendOnAllThatIsScattered) {
    constexpr int kAngles = 16384, kRains = 8;
    constexpr double kMidpoints = 5e-3;  // of a function with steps and the sharp edges of bows
    DropCollisions collisions;
    collisions.look(*weather_, memory_, lanes_, way(100.0));
    for (const double height : {1.0, 2.5, 4.0}) {
        LaneValues sum;
        sum.v.fill(0.0);
        for (int i = 0; i < kAngles; ++i)
            for (int j = 0; j < kRains; ++j) {
                const auto turn =
                    collisions.turn(height + 1.0, (j + 0.5) / kRains, {(i + 0.5) / kAngles, 0.3});
                ASSERT_TRUE(turn);
                for (int k = 0; k < lanes_.count; ++k)
                    sum[k] += turn->scattered[k] / turn->pdf / (kAngles * kRains);
            }
        for (int k = 0; k < lanes_.count; ++k) {
            double expected = 0.0;
            for (std::size_t rain = 0; rain < 2; ++rain) {
                const PacketWeather::RainLanes& there = memory_.rain(rain);
                if (rain == 0 ? height < 3.0 : height > 2.0)
                    expected += there.extinction[std::size_t(k)] * there.albedo[std::size_t(k)];
            }
            EXPECT_NEAR(sum[k], expected, kMidpoints * expected) << height << " m, lane " << k;
        }
    }
}

}  // namespace
}  // namespace dewbow
