// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/error.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace dewbow {
namespace {

using Words = std::vector<std::string>;

TEST(SourcePlaceTest, LeavesOutWhatIsNotKnown) {
    EXPECT_EQ(to_string({}), "");
    EXPECT_EQ(to_string({"scene.toml", 0, 0, ""}), "scene.toml");
    EXPECT_EQ(to_string({"scene.toml", 12, 0, ""}), "scene.toml:12");
    EXPECT_EQ(to_string({"scene.toml", 12, 7, ""}), "scene.toml:12:7");
    EXPECT_EQ(to_string({"scene.toml", 0, 7, ""}), "scene.toml");
    EXPECT_EQ(to_string({"ring.glb", 0, 0, "/materials/3/ior"}), "ring.glb: /materials/3/ior");
    EXPECT_EQ(to_string({"", 0, 0, "/materials"}), "/materials");
    EXPECT_EQ(to_string({"", 3, 4, ""}), "line 3:4");
}

TEST(InputErrorTest, MessageIsComposedAsDocumented) {
    const InputError error({"scene.toml", 12, 9, ""}, "unknown glass \"schott/BK7\"",
                           "glass = \"schott/BK7\"", "did you mean \"schott/N-BK7\"?");
    EXPECT_STREQ(error.what(),
                 "scene.toml:12:9: unknown glass \"schott/BK7\"\n"
                 "  12 | glass = \"schott/BK7\"\n"
                 "     |         ^\n"
                 "  hint: did you mean \"schott/N-BK7\"?");
    EXPECT_EQ(error.sentence(), "unknown glass \"schott/BK7\"");
    EXPECT_EQ(error.hint(), "did you mean \"schott/N-BK7\"?");
    EXPECT_EQ(error.place().line, 12u);
}

TEST(InputErrorTest, PartsMayBeMissing) {
    EXPECT_STREQ(InputError("no scene given").what(), "no scene given");
    EXPECT_STREQ(InputError("no scene given", "try --help").what(),
                 "no scene given\n  hint: try --help");
    EXPECT_STREQ(InputError({"a.toml", 3, 0, ""}, "odd", "x = 1").what(),
                 "a.toml:3: odd\n  3 | x = 1");
}

TEST(InputErrorTest, CaretStandsBelowItsCharacterAfterTabsAndUtf8) {
    EXPECT_STREQ(InputError({"a", 1, 3, ""}, "odd", "\t\tx = 1").what(),
                 "a:1:3: odd\n  1 | \t\tx = 1\n    | \t\t^");
    EXPECT_STREQ(InputError({"a", 1, 5, ""}, "odd", "Ökö x").what(),
                 "a:1:5: odd\n  1 | Ökö x\n    |     ^");
    // One past the end: something is missing there.
    EXPECT_STREQ(InputError({"a", 1, 4, ""}, "odd", "x =").what(),
                 "a:1:4: odd\n  1 | x =\n    |    ^");
    // No such column: no caret.
    EXPECT_STREQ(InputError({"a", 1, 99, ""}, "odd", "x =").what(), "a:1:99: odd\n  1 | x =");
}

TEST(InputErrorTest, LongLinesAreCutAroundTheColumn) {
    const std::string line = std::string(1000, 'a') + "X" + std::string(1000, 'b');
    const std::string message = InputError({"a.json", 1, 1001, ""}, "odd", line).what();
    EXPECT_LT(message.size(), 300u);
    const std::string_view shown = line_of(message, 2), marker = line_of(message, 3);
    ASSERT_NE(marker.find('^'), std::string_view::npos);
    EXPECT_EQ(shown[marker.find('^')], 'X');
    EXPECT_EQ(shown.substr(6, 3), "...");
    EXPECT_TRUE(shown.ends_with("..."));
}

TEST(InputErrorTest, EscapeSequencesDoNotReachTheTerminal) {
    const std::string message =
        InputError({"a", 1, 1, ""}, "unknown \x1b[2J", "\x1b[31m\x07", "\x7f").what();
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
    EXPECT_EQ(message.find('\x07'), std::string::npos);
    EXPECT_EQ(message.find('\x7f'), std::string::npos);
}

TEST(InputErrorTest, UsageErrorIsAnInputError) {
    static_assert(std::is_base_of_v<InputError, UsageError>);
    EXPECT_THROW(throw UsageError("unknown flag"), InputError);
}

TEST(NearestWord, FindsSlipsOfThePen) {
    const Words words{"schott/N-BK7", "schott/F5", "cdgm/F5", "water"};
    EXPECT_EQ(nearest_word("schott/BK7", words), "schott/N-BK7");
    EXPECT_EQ(nearest_word("wather", words), "water");
    EXPECT_EQ(nearest_word("wtaer", words), "water");
    EXPECT_EQ(nearest_word("WATER", words), "water");
    EXPECT_EQ(nearest_word("water", words), "water");
    EXPECT_EQ(nearest_word("diamond", words), "");
    EXPECT_EQ(nearest_word("", words), "");
    EXPECT_EQ(nearest_word("water", {}), "");
}

TEST(NearestWord, CaseCountsLessThanALetter) {
    EXPECT_EQ(nearest_word("SEED", Words{"seeds", "feed", "seed"}), "seed");
    EXPECT_EQ(nearest_word("Seed", Words{"Weed", "seed"}), "seed");
}

TEST(NearestWord, ExchangedNeighboursCountOnce) {
    // Two letters away as replacements, one as an exchange.
    EXPECT_EQ(nearest_word("abcd", Words{"abxy", "abdc"}), "abdc");
}

TEST(NearestWord, LimitIsAThirdAndAtLeastTwo) {
    EXPECT_EQ(nearest_word("abcxy", Words{"abcde"}), "abcde");              // 2 of 5: at least two
    EXPECT_EQ(nearest_word("abxyz", Words{"abcde"}), "");                   // 3 of 5
    EXPECT_EQ(nearest_word("abcdefxyz", Words{"abcdefghi"}), "abcdefghi");  // 3 of 9
    EXPECT_EQ(nearest_word("abcdewxyz", Words{"abcdefghi"}), "");           // 4 of 9
    EXPECT_EQ(nearest_word("ab", Words{"cd"}), "");  // nothing left of the word
}

TEST(NearestWord, HostileWordsCostNothing) {
    const Words words(1000, std::string(200, 'a'));
    EXPECT_EQ(nearest_word(std::string(10'000'000, 'a'), words), "");
}

TEST(HintFor, GuessesElseListsElseIsSilent) {
    const Words few{"bar", "plain", "json"};
    EXPECT_EQ(hint_for("jsn", few), "did you mean \"json\"?");
    EXPECT_EQ(hint_for("telegraph", few), "expected one of bar, plain, json");
    EXPECT_EQ(hint_for("telegraph", {}), "");
    EXPECT_EQ(hint_for("telegraph", Words(100, "x")), "");
}

TEST(LineOf, CountsFromOneAndDropsTheEnd) {
    const std::string_view text = "one\ntwo\r\n\nfour";
    EXPECT_EQ(line_of(text, 0), "");
    EXPECT_EQ(line_of(text, 1), "one");
    EXPECT_EQ(line_of(text, 2), "two");
    EXPECT_EQ(line_of(text, 3), "");
    EXPECT_EQ(line_of(text, 4), "four");
    EXPECT_EQ(line_of(text, 5), "");
    EXPECT_EQ(line_of("", 1), "");
}

}  // namespace
}  // namespace dewbow
