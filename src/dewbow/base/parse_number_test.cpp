// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/parse_number.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdint>

namespace dewbow {
namespace {

TEST(ParseNumber, WholeTextsOnly) {
    EXPECT_EQ(parse_number<double>("1.5"), 1.5);
    EXPECT_EQ(parse_number<double>("+1.5"), 1.5);
    EXPECT_EQ(parse_number<double>("-2e-3"), -2e-3);
    EXPECT_EQ(parse_number<int>("42"), 42);
    for (const char* wrong : {"", "+", "-", ".", "1,5", " 1", "1 ", "1.5m", "0x10", "++1", "1e"})
        EXPECT_FALSE(parse_number<double>(wrong)) << wrong;
    EXPECT_FALSE(parse_number<int>("1.5"));
    EXPECT_FALSE(parse_number<unsigned>("-1"));
}

TEST(ParseNumber, SignsDoNotPileUp) {
    EXPECT_FALSE(parse_number<double>("+-1"));
    EXPECT_FALSE(parse_number<int>("+-1"));
}

TEST(ParseNumber, OutOfRangeIsNoNumber) {
    EXPECT_FALSE(parse_number<std::uint8_t>("256"));
    EXPECT_FALSE(parse_number<double>("1e999"));
    EXPECT_TRUE(std::isinf(parse_number<double>("inf").value()));
    EXPECT_TRUE(std::isnan(parse_number<double>("nan").value()));
}

TEST(ParseNumber, LocaleDoesNotMatter) {
    const char* german = std::setlocale(LC_ALL, "de_DE.UTF-8");
    EXPECT_EQ(parse_number<double>("1.5"), 1.5);
    EXPECT_FALSE(parse_number<double>("1,5"));
    std::setlocale(LC_ALL, "C");
    if (!german) GTEST_SKIP() << "no German locale here: only the C locale was tried";
}

}  // namespace
}  // namespace dewbow
