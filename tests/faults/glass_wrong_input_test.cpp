// SPDX-License-Identifier: Apache-2.0

// Wrong glasses, wavelengths, numbers and glass files, given to `dewbow glass`.

#include <gtest/gtest.h>

#include "run_program.h"

namespace dewbow::faults {
namespace {

constexpr int kWrongInput = 1, kWrongUse = 2;
using Words = std::vector<std::string>;

struct Row {
    Words arguments;  ///< after "glass"
    int exit_code;
    Words phrases;
    std::string bytes = {};  ///< of the file that the arguments name, if they name one
};

void check(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        const Folder folder;
        Words arguments{"glass"};
        for (const std::string& word : row.arguments) {
            arguments.push_back(word);
            if (word.starts_with("file.")) folder.put(word.substr(0, word.find('#')), row.bytes);
        }
        const auto before = folder.snapshot();
        const Outcome outcome = run_program(DEWBOW_BINARY, arguments, folder.path());
        EXPECT_EQ(faults_of_answer(outcome, row.exit_code, row.phrases), "")
            << row.arguments[0] << ' ' << (row.arguments.size() > 1 ? row.arguments[1] : "");
        EXPECT_EQ(folder.snapshot(), before) << row.arguments[0];
    }
}

TEST(GlassWrongInput, NamesAndWavelengths) {
    const Words many(25, "N-BK7");
    Words compare_many{"compare"};
    compare_many.insert(compare_many.end(), many.begin(), many.end());
    check({
        {{"show", "F55"}, kWrongUse, {"unknown glass \"F55\"", "did you mean schott/F5, cdgm/F5"}},
        {{"show", "BAF4"}, kWrongUse, {"ambiguous", "cdgm/BAF4, hikari/BAF4"}},
        {{"show", "zeiss/F2"}, kWrongUse, {"unknown glass \"zeiss/F2\""}},
        {{"show", ""}, kWrongUse, {"the name is missing"}},
        {{"show", "\x1b[31m"}, kWrongUse, {"unknown glass"}},
        {{"show", "water@"}, kWrongUse, {"no temperature", "25C"}},
        {{"show", "water@25"}, kWrongUse, {"\"25\" is no temperature"}},
        {{"show", "water@101C"}, kWrongUse, {"water of 101 °C; expected 0 to 100 °C"}},
        {{"show", "F2@25C"}, kWrongUse, {"schott/F2 has no temperature"}},
        {{"show", "F2", "--at", "0.1nm"}, kWrongUse, {"--at is \"0.1nm\"", "200 to 3000 nm"}},
        {{"show", "F2", "--at", "500pm"}, kWrongUse, {"--at is \"500pm\"", "such as 500nm"}},
        {{"show", "F2", "--at", "K"}, kWrongUse, {"--at is \"K\"", "a line such as D"}},
        {{"show", "F2", "--plot", "f2.pdf"}, kWrongUse, {"--plot is \"f2.pdf\"", "ends in .svg"}},
        {{"show", "F2", "--plot", "missing/f2.svg"}, kWrongInput, {"missing/f2.svg"}},
        {{"show", "F2", "--json=1"}, kWrongUse, {"--json takes no value"}},
        {{"list", "unobtainium"}, kWrongUse, {"no glass has \"unobtainium\""}},
        {{"compare", "F2"}, kWrongUse, {"two names or more"}},
        {{"compare", "F2", "N-BK8"}, kWrongUse, {"unknown glass \"N-BK8\""}},
        {compare_many, kWrongUse, {"25 names; at most 24"}},
    });
}

TEST(GlassWrongInput, Conversions) {
    check({
        {{"convert"}, kWrongUse, {"nothing to convert", "--n-d"}},
        {{"convert", "--n-d", "1.5"}, kWrongUse, {"0 numbers for the dispersion; expected one"}},
        {{"convert", "--abbe", "60"}, kWrongUse, {"--n-d is missing"}},
        {{"convert", "--n-d", "0.5", "--abbe", "60"}, kWrongUse, {"--n-d is 0.5"}},
        {{"convert", "--n-d", "1.5", "--abbe", "-3"}, kWrongUse, {"--abbe is -3"}},
        {{"convert", "--n-d", "1.5", "--abbe", "60", "--gltf", "1"}, kWrongUse, {"2 numbers"}},
        {{"convert", "--n-d", "1.5", "--pov-ray", "0.9"}, kWrongUse, {"is no dispersion"}},
        {{"convert", "F2", "--n-d", "1.5"}, kWrongUse, {"one of them is too many"}},
        {{"convert", "vacuum"}, kWrongUse, {"has no dispersion"}},
        {{"convert", "--n-d", "nan", "--abbe", "60"}, kWrongUse, {"--n-d is"}},
    });
}

TEST(GlassWrongInput, PapersIndex) {
    check({
        {{"paper", "F55"}, kWrongUse, {"unknown glass \"F55\"", "did you mean schott/F5"}},
        {{"paper", "air"}, kWrongUse, {"has no dispersion against air"}},
        {{"paper", "vacuum"}, kWrongUse, {"has no dispersion against air"}},
        {{"paper", "F2", "--w", "0.5"}, kWrongUse, {"one of them is too many"}},
        {{"paper", "--w", "0.5"}, kWrongUse, {"--eta-red is missing"}},
        {{"paper", "--eta-red", "1.5"}, kWrongUse, {"--w is missing"}},
        {{"paper", "--eta-red", "1", "--w", "0.5"}, kWrongUse, {"--eta-red is 1"}},
        {{"paper", "--eta-red", "1.5", "--w", "nan"}, kWrongUse, {"--w is"}},
        {{"paper", "F2", "--spacing", "frequenzy"}, kWrongUse, {"frequency"}},
        {{"paper", "--plot", "missing/all.svg"}, kWrongInput, {"missing/all.svg"}},
        {{"paper", "F2", "--plot", "missing/f2.svg"}, kWrongInput, {"missing/f2.svg"}},
    });
}

TEST(GlassWrongInput, Files) {
    const std::string bk7 =
        "NM A 2 0 1.5168 64.17\nCD 1.04 0.006 0.23 0.02 1.01 103.6\nLD 0.3 2.5\n";
    std::string binary = "NM";
    for (std::uint32_t i = 0; i < 3000; ++i)
        binary += static_cast<char>((i * 2654435761u + 12345u) >> 23);
    check({
        {{"import"}, kWrongUse, {"the file is missing"}},
        {{"import", "nothing.agf"}, kWrongInput, {"nothing.agf"}},
        {{"import", "file.txt"}, kWrongInput, {"file.txt: expected a glass file", ".agf"}, bk7},
        {{"import", "file.agf"}, kWrongInput, {"file.agf: no glass in it", "NM"}, ""},
        {{"import", "file.agf"}, kWrongInput, {"file.agf: no glass in it"}, "hello\n"},
        {{"import", "file.agf"}, kWrongInput, {"file.agf: not a text"}, binary},
        {{"import", "file.agf"},
         kWrongInput,
         {"no glass in it that can be used", "no coefficients"},
         "NM A 2 0 1.5 60\nLD 0.3 2\n"},
        {{"import", "file.agf"}, kWrongInput, {"14 as the formula"}, "NM A 14 0 1.5 60\nCD 1 2\n"},
        {{"import", "file.agf#B"},
         kWrongInput,
         {"unknown glass of this file \"B\"", "file/A"},
         bk7},
        {{"import", "file.agf", "--rows", "a.txt"}, kWrongUse, {"--rows is", ".csv"}, bk7},
        {{"import", "file.agf", "--rows", "missing/a.csv"}, kWrongInput, {"missing/a.csv"}, bk7},
        {{"show", "file.agf"},
         kWrongInput,
         {"2 glasses in it, and none is named", "file.agf#A"},
         bk7 + "NM B" + bk7.substr(4)},
        {{"import", "file.yml"}, kWrongInput, {"file.yml: nothing in it"}, ""},
        {{"import", "file.yml"}, kWrongInput, {"no DATA in it"}, "COMMENTS: x\n"},
        {{"import", "file.yml"},
         kWrongInput,
         {"file.yml:2: formula 10; expected 1 to 9"},
         "DATA:\n  - type: formula 10\n    coefficients: 1\n"},
        {{"import", "file.yml"},
         kWrongInput,
         {"file.yml:4: \"1.5x\" is not a number"},
         "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 2\n    coefficients: 0 1.5x\n"},
        {{"import", "file.yml"},
         kWrongInput,
         {"expected 1 to 10"},
         "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 2\n    coefficients: 0.5\n"},
        {{"import", "file.yml"},
         kWrongInput,
         {"file.yml:1:1: expected a key"},
         binary.substr(2, 40)},
    });
}

}  // namespace
}  // namespace dewbow::faults
