// SPDX-License-Identifier: Apache-2.0

// Glass files with the traps that makers' files have.

#include "dewbow/import/glass/glass_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/file.h"
#include "dewbow/import/glass/agf.h"
#include "dewbow/import/glass/rii_page.h"
#include "dewbow/import/import.h"
#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

const std::string kBk7 =
    "NM N-BK7 2 517642 1.516800 64.17 0 1 -1\n"
    "ED 7.1 8.3 2.51 -0.0009 0\n"
    "CD 1.039612120E+00 6.000698670E-03 2.317923440E-01 2.001791440E-02 1.010469450E+00 "
    "1.035606530E+02 0 0 0 0\n"
    "TD 1.86E-06 1.31E-08 -1.37E-11 4.34E-07 6.27E-10 0.17 20\n"
    "LD 3.0E-01 2.5E+00\n"
    "IT 4.0E-01 9.96792E-01 1.0E+01\n";

GlassFile agf(const std::string& bytes) {
    return glass_import::read_agf(bytes, "maker.agf", "maker");
}
double n_d_of(const Glass& glass) {
    return (*make_dispersion(glass.data))(kLined).value / (*air())(kLined).value;
}
std::string notes_of(const GlassFile& file) {
    std::string text;
    for (const Diagnostic& note : file.notes) text += note.text + "\n";
    return text;
}
void expect_bk7(const GlassFile& file) {
    ASSERT_EQ(file.glasses.size(), 1u) << notes_of(file);
    EXPECT_EQ(file.glasses[0].name, "maker/N-BK7");
    EXPECT_NEAR(n_d_of(file.glasses[0]), 1.5168, 5e-6);
    EXPECT_EQ(file.glasses[0].lambda_max_nm, 2500.0);
}
void expect_note(const GlassFile& file, const std::string& part) {
    EXPECT_NE(notes_of(file).find(part), std::string::npos) << notes_of(file);
}
std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}
std::string utf16(const std::string& latin, bool little) {
    std::string bytes;
    for (const char c : latin) {
        if (!little) bytes.push_back('\0');
        bytes.push_back(c);
        if (little) bytes.push_back('\0');
    }
    return bytes;
}

TEST(Agf, ReadsARecord) {
    const GlassFile file = agf("CC a comment\n! another\n" + kBk7);
    expect_bk7(file);
    EXPECT_TRUE(file.notes.empty()) << notes_of(file);
    // The same glass's k at 400 nm in the catalogue is 1.0227e-8.
    ASSERT_EQ(file.glasses[0].k.size(), 1u);
    EXPECT_NEAR(file.glasses[0].k[0].k, 1.0227e-8, 1e-12);
}

TEST(Agf, ReadsEveryEncodingAndLineEnd) {
    expect_bk7(agf("\xEF\xBB\xBF" + kBk7));
    expect_bk7(agf(replaced(kBk7, "\n", "\r\n")));
    expect_bk7(agf(replaced(kBk7, "\n", "\r")));
    expect_bk7(agf(replaced(kBk7, " ", "\t")));
    for (const bool little : {true, false}) {
        const std::string mark = little ? "\xFF\xFE" : "\xFE\xFF";
        for (const std::string& start : {mark, std::string()}) {
            const GlassFile file = agf(start + utf16(kBk7, little));
            expect_bk7(file);
            expect_note(file, little ? "UTF-16, little-endian" : "UTF-16, big-endian");
        }
    }
    for (const std::string& nel : {std::string("\x85"), std::string("\xC2\x85")}) {
        const GlassFile file = agf(replaced(kBk7, "\n", nel));
        expect_bk7(file);
        expect_note(file, "NEL");
    }
    const std::string nel_utf16 = "\xFF\xFE" + utf16(replaced(kBk7, "\n", "\x85"), true);
    expect_bk7(agf(nel_utf16));
}

TEST(Agf, JoinsWrappedLines) {
    const GlassFile file = agf(replaced(replaced(kBk7, " 1.010469450E+00", "\n1.010469450E+00"),
                                        "4.34E-07", "\n 4.34E-07"));
    expect_bk7(file);
    expect_note(file, "2 wrapped lines");
}

TEST(Agf, TakesPlaceholdersAndMissingFieldsForUnknown) {
    GlassFile file = agf(replaced(kBk7, "1.516800 64.17", "1.0 0"));
    expect_bk7(file);
    EXPECT_EQ(file.glasses[0].n_d, 0.0);
    expect_note(file, "placeholder");
    file = agf(replaced(kBk7, "1.516800 64.17", "- -"));
    expect_bk7(file);
    expect_note(file, "2 fields missing");
    file = agf(replaced(kBk7, "LD 3.0E-01 2.5E+00", "LD 0 0"));
    ASSERT_EQ(file.glasses.size(), 1u);
    EXPECT_EQ(file.glasses[0].lambda_max_nm, 0.0);
    EXPECT_FALSE(file.glasses[0].data.range);
    expect_note(file, "without a range");
    EXPECT_TRUE(range_warning(file.glasses[0]));
}

TEST(Agf, FindsCoefficientsInAnotherOrder) {
    // K1 K2 K3 L1 L2 L3, as one file in the world has them: n_d would be another.
    const GlassFile file = agf(
        "NM X 2 0 1.60342 38.03\n"
        "CD 1.3104463E+00 1.9603426E-01 9.6612977E-01 9.5863305E-03 4.5762763E-02 1.1501188E+02\n"
        "LD 0.32 2.5\n" +
        kBk7);
    expect_note(file, "X");
    EXPECT_GE(file.notes.size(), 1u);
}

TEST(Agf, LeavesOutWhatCannotBeUsedAndSaysSo) {
    const GlassFile file =
        agf(kBk7 + "NM B 14 0 1.5 60\nCD 1 2 3\n" + "NM C\n" + "NM D 2 0 1.5 60\nLD 0.3 2\n" +
            "NM E 2 0 1.5 60\nCD -9 0.01\n" + kBk7);
    expect_bk7(file);
    expect_note(file, "B: 14 as the formula");
    expect_note(file, "C: nothing as the formula");
    expect_note(file, "D: no coefficients");
    expect_note(file, "E: agf_2: the index of refraction at");
    expect_note(file, "a second glass of this name");
}

TEST(Agf, SurvivesAnyBytes) {
    std::uint32_t state = 1;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 16; };
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = kBk7 + kBk7;
        for (std::uint32_t hits = 1 + random() % 8; hits > 0; --hits)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        if (round % 3 == 0) bytes.resize(random() % bytes.size());
        try {
            for (const Glass& glass : agf(bytes).glasses) EXPECT_GE(n_d_of(glass), 1.0);
        } catch (const InputError&) {
        }
    }
}

// ---- pages of refractiveindex.info ----

const std::string kPage =
    "# a comment\nREFERENCES: |\n    F. <b>Author</b>,\n    <a href=\"x\">J. 1, 2</a>\n"
    "COMMENTS: |\n    20 °C\nDATA:\n  - type: formula 2\n    wavelength_range: 0.3 2.5\n"
    "    coefficients: 0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653\n"
    "  - type: tabulated k\n    data: |\n        0.300 2.8607E-06\n        0.310 1.3679E-06\n"
    "CONDITIONS:\n    temperature: 293\nPROPERTIES:\n    nd: 1.5168\n    Vd: 64.17\n"
    "    thermal_dispersion:\n      - type: formula A\n        coefficients: 1 2\n";

GlassFile page(const std::string& text) {
    return glass_import::read_rii_page(text, "page.yml", "rii/page");
}
std::string refusal(const std::string& text) {
    try {
        page(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(RiiPage, ReadsAFormulaWithItsExtinction) {
    const GlassFile file = page(kPage);
    ASSERT_EQ(file.glasses.size(), 1u);
    const Glass& glass = file.glasses[0];
    EXPECT_TRUE(file.notes.empty()) << notes_of(file);
    EXPECT_NEAR(n_d_of(glass), 1.5168, 5e-6);
    EXPECT_EQ(glass.n_d, 1.5168);
    EXPECT_EQ(glass.lambda_min_nm, 300.0);
    ASSERT_EQ(glass.k.size(), 2u);
    EXPECT_EQ(glass.k[1].k, 1.3679e-6);
    EXPECT_EQ(glass.source, "F. Author, J. 1, 2");
    EXPECT_EQ(glass.description, "20 °C");
    EXPECT_FALSE(glass.birefringent);
}

TEST(RiiPage, ReadsOlderPagesTablesAndCrystals) {
    EXPECT_EQ(page(replaced(kPage, "wavelength_range", "range")).glasses[0].lambda_max_nm, 2500.0);
    EXPECT_TRUE(page(replaced(kPage, "temperature: 293", "direction: e")).glasses[0].extraordinary);
    const GlassFile table = page(
        "DATA:\n  - type: tabulated nk\n    data: |\n        0.5 1.52 1e-6\n        0.4 1.53 2e-6\n"
        "        0.5 1.52 1e-6\n        0.6 1.51 3e-6\n");
    EXPECT_EQ(table.glasses[0].data.coefficients,
              (std::vector<double>{0.4, 1.53, 0.5, 1.52, 0.6, 1.51}));
    EXPECT_EQ(table.glasses[0].k.size(), 3u);
    expect_note(table, "sorted");
    expect_note(table, "twice");
}

TEST(RiiPage, SaysWhatIsWrong) {
    const auto expect = [](const std::string& text, const std::string& part) {
        EXPECT_NE(refusal(text).find(part), std::string::npos) << refusal(text);
    };
    expect("", "page.yml: nothing in it");
    expect("A: 1\n", "no DATA in it");
    expect("DATA: 1\n", "page.yml:1: DATA is no list");
    expect("DATA:\n  - type: tabulated k\n    data: |\n        0.4 1\n", "no index in DATA");
    expect(replaced(kPage, "formula 2", "formula 12"), "page.yml:8: formula 12; expected 1 to 9");
    expect(replaced(kPage, "1.03961212", "abc"), "page.yml:10: \"abc\" is not a number");
    expect(replaced(kPage, "1.03961212", "nan"), "\"nan\" is not a number");
    expect(replaced(kPage, "0.3 2.5", "2.5 0.3"), "no pair of rising wavelengths");
    expect(replaced(kPage, "    coefficients: 0 1.0", "    coeficients: 0 1.0"), "no coefficients");
    expect(replaced(kPage, "    wavelength_range", "   wavelength_range"),
           "page.yml:9:4: expected");
    expect("DATA:\n\t- type: formula 2\n", "a tab as indentation");
    expect("hello\n", "page.yml:1:1: expected a key, a colon and a value");
    expect("DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5 3\n", "expected rows of 2");
    expect("DATA:\n  - type: tabulated n\n    data: |\n        0.4 0.2\n        0.7 0.1\n",
           "expected 1 to 10");
    std::string deep;
    for (int i = 0; i < 2000; ++i) deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
    expect(deep, "more than 16 levels");
    std::string dashes = "DATA:\n ";
    for (int i = 0; i < 5000; ++i) dashes += " -";
    EXPECT_NE(refusal(dashes + " a: 1\n"), "accepted");
}

TEST(RiiPage, SurvivesAnyBytes) {
    std::uint32_t state = 1;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 16; };
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = kPage;
        for (std::uint32_t hits = 1 + random() % 8; hits > 0; --hits)
            bytes[random() % bytes.size()] = static_cast<char>(random());
        try {
            for (const Glass& glass : page(bytes).glasses) EXPECT_GE(n_d_of(glass), 1.0);
        } catch (const InputError&) {
        }
    }
}

// ---- files of others, where they are at hand ----

TEST(GlassFiles, OfAllThirteenFormulasGiveTheirIndices) {
    const std::filesystem::path file =
        std::filesystem::path(DEWBOW_SHARED_DATA) / "glass/test_formulas_1_13.agf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
    const GlassFile read = load_glass_file(file);
    EXPECT_EQ(read.glasses.size(), 13u);
    EXPECT_TRUE(read.notes.empty()) << notes_of(read);
    for (const Glass& glass : read.glasses)
        EXPECT_NEAR(n_d_of(glass), glass.n_d, 5.1e-7) << glass.name;  // six decimals are stated
}

// ---- in scenes ----

class SceneWithGlassFile : public testing::Test {
protected:
    void SetUp() override {
        folder_ = std::filesystem::path(testing::TempDir()) /
                  (std::string("dewbow_scene_with_glass_file_") +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        write_file_atomically(folder_ / "maker.agf",
                              kBk7 + "NM F 2 0 1.5168 64\nCD 1.3 0.01\nLD 0.5 0.6\n");
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
    ImportedScene load(const std::string& glass) const {
        write_file_atomically(folder_ / "scene.toml",
                              "[materials.a]\ntype = \"glass\"\n" + glass +
                                  "\n[[shapes]]\ntype = \"sphere\"\nmaterial = \"a\"\n"
                                  "radius_m = 1\n");
        return load_scene(folder_ / "scene.toml");
    }
    static double n_d_in(const ImportedScene& imported) {
        const auto& surface = std::get<Dielectric>(imported.scene.materials.at(0).surface);
        return (*surface.interior->index)(kLined).value / (*air())(kLined).value;
    }
    std::filesystem::path folder_;
};

TEST_F(SceneWithGlassFile, TakesTheGlassAndSaysWhatIsWrongWithIt) {
    EXPECT_NEAR(n_d_in(load("glass = \"maker.agf#N-BK7\"")), 1.5168, 5e-6);
    const ImportedScene other = load("glass = \"maker.agf#F\"");
    std::string notes;
    for (const Diagnostic& note : other.diagnostics) notes += note.text + "\n";
    EXPECT_NE(notes.find("F: its coefficients give n_d"), std::string::npos) << notes;
    EXPECT_NE(notes.find("maker/F: data of 500 to 600 nm"), std::string::npos) << notes;
    for (const char* wrong : {"glass = \"maker.agf#X\"", "glass = \"maker.agf\"",
                              "glass = \"../maker.agf#N-BK7\"", "glass = \"none.agf#N-BK7\""})
        EXPECT_THROW(load(wrong), InputError) << wrong;
}

TEST_F(SceneWithGlassFile, TakesTheRangeOfAFormula) {
    // Zinc selenide's formula has a resonance at 391 nm, which its data (from 540 nm) do not reach.
    const std::string formula =
        "dispersion = { form = \"rii_1\", coefficients = [0, 4.45813734, 0.200859853, 0.467216334, "
        "0.391371166, 2.8956629, 47.1362108]";
    EXPECT_THROW(load(formula + " }"), InputError);
    EXPECT_NEAR(n_d_in(load(formula + ", range_nm = [540, 18200] }")), 2.62440, 1e-5);
    EXPECT_THROW(load(formula + ", range_nm = [540] }"), InputError);
}

TEST(GlassReference, IsAFileWithAName) {
    EXPECT_TRUE(is_glass_file_reference("glasses/schott.AGF#N-BK7"));
    EXPECT_TRUE(is_glass_file_reference("page.yml"));
    EXPECT_FALSE(is_glass_file_reference("schott/N-BK7"));
    EXPECT_FALSE(is_glass_file_reference("agf"));
    EXPECT_EQ(split_glass_reference("a.agf#N-BK7").file, "a.agf");
    EXPECT_EQ(split_glass_reference("a.agf#N-BK7").name, "N-BK7");
}

}  // namespace
}  // namespace dewbow
