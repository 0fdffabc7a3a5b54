// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/self_test.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewbow {
namespace {

TEST(SelfTest, AllAgree) {
    const std::vector<SelfTestRow> rows = run_self_test();
    EXPECT_GT(rows.size(), 19u * 4u);
    for (const SelfTestRow& row : rows) {
        EXPECT_TRUE(row.ok()) << row.source << ": " << row.quantity << ", expected " << row.expected
                              << ", computed " << row.computed << ", error " << row.error;
    }
}

TEST(SelfTest, ReportNamesWhatIsWrong) {
    const std::vector<SelfTestRow> rows = {
        {"A book", "right", 2.0, 2.0, 0.0, 1e-9},
        {"A book", "wrong", 2.0, 2.2, 0.1, 1e-9},
        {"A law", "not a number", 1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::quiet_NaN(), 1e-9},
    };
    const std::string report = self_test_report(rows);
    EXPECT_EQ(report.find("A book"), report.rfind("A book"));
    const auto line_of_row = [&](const std::string& name) {
        const std::size_t begin = report.find("  " + name + " ");
        return report.substr(begin, report.find('\n', begin) - begin);
    };
    EXPECT_EQ(line_of_row("right").find("WRONG"), std::string::npos);
    EXPECT_NE(line_of_row("wrong").find("WRONG"), std::string::npos);
    EXPECT_NE(line_of_row("not a number").find("WRONG"), std::string::npos);
    EXPECT_NE(report.find("1 of 3 agree."), std::string::npos);
}

}  // namespace
}  // namespace dewbow
