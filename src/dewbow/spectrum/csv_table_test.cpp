// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/csv_table.h"

#include <gtest/gtest.h>

namespace dewbow {
namespace {

TEST(CsvTable, SkipsCommentsAndNames) {
    const auto columns = columns_of_csv("# a comment, with a comma\nnm,x\n\n360,0.5\n365,-1e-3\n");
    ASSERT_EQ(columns.size(), 2u);
    EXPECT_EQ(columns[0], (std::vector<double>{360.0, 365.0}));
    EXPECT_EQ(columns[1], (std::vector<double>{0.5, -1e-3}));
}

TEST(CsvTable, TakesEitherLineEndAndNoLastOne) {
    EXPECT_EQ(columns_of_csv("a,b\r\n1,2\r\n3,4"), columns_of_csv("a,b\n1,2\n3,4\n"));
}

TEST(CsvTableDeathTest, StopsAtAFaultOfATable) {
    EXPECT_DEATH(columns_of_csv("a,b\n1,two\n"), "number");
    EXPECT_DEATH(columns_of_csv("a,b\n1,2,3\n"), "wide");
    EXPECT_DEATH(columns_of_csv("a,b\n1\n"), "number");
}

}  // namespace
}  // namespace dewbow
