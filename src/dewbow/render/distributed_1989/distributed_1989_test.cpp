// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/distributed_1989.h"

#include <gtest/gtest.h>

#include "dewbow/scene/scene.h"

namespace dewbow {
namespace {

class SomeAir final : public Aerial {
    void eval_lanes(double, Dir<World>, double, std::span<const double>, std::span<double>,
                    std::span<double>) const override {}
};

TEST(Distributed1989, SaysThatItLeavesOutTheAirsVeil) {
    Scene scene = make_empty_scene();
    EXPECT_EQ(make_distributed_1989_estimator(scene)->leaves_out(), "");
    scene.aerial = std::make_shared<const SomeAir>();
    EXPECT_NE(make_distributed_1989_estimator(scene)->leaves_out().find("aerial_perspective"),
              std::string::npos);
}

}  // namespace
}  // namespace dewbow
