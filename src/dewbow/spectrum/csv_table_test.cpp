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

TEST(CsvTable, NamesItsColumns) {
    EXPECT_EQ(column_names_of_csv("# c\nnm,FL3.1,x\n1,2,3\n"),
              (std::vector<std::string>{"nm", "FL3.1", "x"}));
}

TEST(CsvTable, ReadsRowsOfText) {
    const auto rows = rows_of_csv("# c\nname,what\na,\"b, \"\"c\"\"\"\n\nd,\n", "name,what");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"a", "b, \"c\""}));
    EXPECT_EQ(rows[1], (std::vector<std::string>{"d", ""}));
    EXPECT_EQ(numbers_of_field("1 -2.5e3"), (std::vector<double>{1.0, -2500.0}));
    EXPECT_TRUE(numbers_of_field("").empty());
}

TEST(CsvTableDeathTest, StopsAtAFaultOfATable) {
    EXPECT_DEATH(columns_of_csv("a,b\n1,two\n"), "number");
    EXPECT_DEATH(columns_of_csv("a,b\n1,2,3\n"), "wide");
    EXPECT_DEATH(columns_of_csv("a,b\n1\n"), "number");
    EXPECT_DEATH(rows_of_csv("a,b\n1,2\n", "a,c"), "columns");
    EXPECT_DEATH(rows_of_csv("a,b\n1\n", "a,b"), "wide");
    EXPECT_DEATH(numbers_of_field("1  2"), "number");
}

}  // namespace
}  // namespace dewbow
