// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/named.h"

#include <gtest/gtest.h>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

const std::vector<std::string> kNames{"schott/F2", "ohara/F-2", "gem/diamond"};

TEST(FindNamed, FoldsCaseAndHyphensAndLeavesTheGroupOut) {
    EXPECT_EQ(find_named("glass", "schott/f2", kNames), 0u);
    EXPECT_EQ(find_named("glass", "OHARA/F_2", kNames), 1u);
    EXPECT_EQ(find_named("glass", "Dia mond", kNames), 2u);
}

TEST(MatchNamed, IsNothingWhereNoneOrSeveralAreMeant) {
    EXPECT_EQ(match_named("diamond", kNames), 2u);
    EXPECT_EQ(match_named("f2", kNames), std::nullopt);
    EXPECT_EQ(match_named("quartz", kNames), std::nullopt);
}

TEST(FindNamed, RefusesWhatIsUnknownOrAmbiguous) {
    const auto refusal = [](const char* name, const std::vector<std::string>& names) {
        try {
            find_named("glass", name, names);
        } catch (const InputError& error) {
            return error.sentence() + "; " + error.hint();
        }
        return std::string("found");
    };
    EXPECT_EQ(refusal("f2", kNames),
              "glass \"f2\" is ambiguous; write one of schott/F2, ohara/F-2");
    EXPECT_EQ(refusal("gem/dimond", kNames),
              "unknown glass \"gem/dimond\"; did you mean "
              "gem/diamond?");
    EXPECT_EQ(refusal("quartz", kNames),
              "unknown glass \"quartz\"; known are schott/F2, ohara/F-2, "
              "gem/diamond");
    EXPECT_NE(refusal("quartz", std::vector<std::string>(50, "a/b")).find(" and more"),
              std::string::npos);
}

}  // namespace
}  // namespace dewbow
