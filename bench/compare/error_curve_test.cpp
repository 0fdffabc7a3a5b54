// SPDX-License-Identifier: Apache-2.0
#include "error_curve.h"

#include <gtest/gtest.h>

namespace dewbow::bench {
namespace {

TEST(ErrorCurve, FollowsAPowerLawExactly) {
    // error = 3 / time, given at two times in the wrong order.
    const ErrorCurve curve({{8.0, 3.0 / 8.0}, {0.5, 6.0}});
    for (const double time : {0.5, 1.0, 2.0, 7.0, 8.0})
        EXPECT_NEAR(curve.error_at(time).value(), 3.0 / time, 1e-12);
}

TEST(ErrorCurve, ClaimsNothingBeyondItsEnds) {
    const ErrorCurve curve({{1.0, 1.0}, {2.0, 0.5}});
    EXPECT_FALSE(curve.error_at(0.99));
    EXPECT_FALSE(curve.error_at(2.01));
    EXPECT_FALSE(ErrorCurve({}).error_at(1.0));
    EXPECT_EQ(ErrorCurve({{1.0, 0.25}}).error_at(1.0), 0.25);
}

TEST(ErrorCurve, HasNoLogarithmOfZero) {
    const ErrorCurve curve({{1.0, 1.0}, {2.0, 0.0}});
    EXPECT_FALSE(curve.error_at(1.5));
    EXPECT_EQ(curve.error_at(2.0), 0.0);
}

}  // namespace
}  // namespace dewbow::bench
