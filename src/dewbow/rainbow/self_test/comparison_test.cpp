// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/self_test/comparison.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewbow::self_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(SelfTestComparison, WorstOfIsTheLargestErrorOrNan) {
    Rows rows;
    Comparison comparison(rows, "a book");
    comparison.worst_of([](Comparison& all) {
        all.compare("near", 1.01, 1.0, 0.1);
        all.compare("far", 1.5, 1.0, 0.1);
        all.compare("exact", 1.0, 1.0, 0.1);
    });
    comparison.worst_of([](Comparison& all) {
        all.compare("far", 1.5, 1.0, 0.1);
        all.compare("none", kNan, 1.0, 0.1);
        all.compare("exact", 1.0, 1.0, 0.1);
    });
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].quantity, "far");
    EXPECT_EQ(rows[0].error, 0.5);
    EXPECT_EQ(rows[1].quantity, "none");
    EXPECT_FALSE(rows[1].ok());
}

TEST(SelfTestComparison, ComplexNumbersDifferByTheirPhaseToo) {
    Rows rows;
    Comparison(rows, "a book").compare("turned", std::complex<double>{0.0, 2.0}, {2.0, 0.0}, 0.1);
    EXPECT_EQ(rows[0].expected, rows[0].computed);
    EXPECT_FALSE(rows[0].ok());
}

}  // namespace
}  // namespace dewbow::self_test
