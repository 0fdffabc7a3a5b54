// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/glass.h"

#include <gtest/gtest.h>

#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

TEST(RangeWarning, SaysWhatIsNotMeasured) {
    EXPECT_EQ(range_warning(find_glass("N-BK7")), std::nullopt);
    EXPECT_EQ(range_warning(find_glass("SF11")),
              "schott/SF11: data of 390 to 2500 nm; 360 to 390 nm is extrapolated");
    EXPECT_EQ(range_warning(find_glass("diamond")),
              "gem/diamond: data of 226 to 760 nm; 760 to 830 nm is extrapolated");
    EXPECT_EQ(range_warning(find_glass("hikari/E-F2")),
              "hikari/E-F2: data of 400 to 700 nm; 360 to 400 nm and 700 to 830 nm are "
              "extrapolated");
}

TEST(BirefringenceNote, IsSaidOfCrystalsAlone) {
    EXPECT_EQ(birefringence_note(find_glass("N-BK7")), std::nullopt);
    EXPECT_EQ(birefringence_note(find_glass("crystal/CaF2")), std::nullopt);
    EXPECT_EQ(birefringence_note(find_glass("calcite")),
              "mineral/calcite is birefringent: its ordinary ray is followed alone, and nothing is "
              "seen double");
    EXPECT_NE(birefringence_note(find_glass("calcite-e"))->find("extraordinary"),
              std::string::npos);
    // Both rays of calcite, which Bartholinus saw apart in 1669.
    const auto n = [](const char* name) {
        return (*make_dispersion(find_glass(name).data))(kLineD).value;
    };
    EXPECT_NEAR(n("calcite") - n("calcite-e"), 0.172, 1e-3);
}

/// α = 4πk/λ turns the maker's internal transmittance of a plate into itself again.
TEST(Absorption, IsThatOfTheMakersPlate) {
    // N-BK7, 10 mm, 400 nm: τ = 0.997 [SCHOTT's data sheet, three decimals].
    const SpectrumPtr bk7 = absorption_of(find_glass("N-BK7"));
    ASSERT_TRUE(bk7);
    EXPECT_NEAR(std::exp(-0.010 * (*bk7)(400.0 * unit::nm)), 0.997, 5.1e-4);
    // SF66, 10 mm: yellow, for it takes violet away.
    const SpectrumPtr sf66 = absorption_of(find_glass("SF66"));
    EXPECT_LT(std::exp(-0.010 * (*sf66)(400.0 * unit::nm)), 0.6);
    EXPECT_GT(std::exp(-0.010 * (*sf66)(700.0 * unit::nm)), 0.98);
    // Water absorbs red: 0.624 1/m at 700 nm [Pope & Fry 1997].
    const SpectrumPtr water = absorption_of(find_glass("water"));
    EXPECT_NEAR((*water)(700.0 * unit::nm), 0.624, 0.05);
    EXPECT_LT((*water)(440.0 * unit::nm), 0.05);
    EXPECT_FALSE(absorption_of(find_glass("diamond")));
}

TEST(GlassCsv, ComesBackAsItWent) {
    std::string text(glass_csv_header());
    for (const Glass& glass : glass_catalogue()) text.append("\n").append(csv_line_of(glass));
    const auto read = glasses_of_csv(text, "again.csv");
    ASSERT_EQ(read.size(), glass_catalogue().size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const Glass& glass = glass_catalogue()[i];
        EXPECT_EQ(read[i].name, glass.name);
        EXPECT_EQ(read[i].aliases, glass.aliases);
        EXPECT_EQ(read[i].description, glass.description);
        EXPECT_EQ(read[i].data.coefficients, glass.data.coefficients);
        EXPECT_EQ(read[i].data.reference, glass.data.reference);
        EXPECT_EQ(read[i].n_d, glass.n_d);
        EXPECT_EQ(read[i].birefringent, glass.birefringent);
        EXPECT_EQ(read[i].extraordinary, glass.extraordinary);
        EXPECT_EQ(read[i].source, glass.source);
    }
}

TEST(FraunhoferLines, AreThoseInVacuum) {
    EXPECT_NEAR(vacuum_wavelength(kAirF_nm).to(unit::nm), kLineF.to(unit::nm), 1e-8);
    EXPECT_NEAR(vacuum_wavelength(kAird_nm).to(unit::nm), kLined.to(unit::nm), 1e-8);
    EXPECT_NEAR(vacuum_wavelength(kAirC_nm).to(unit::nm), kLineC.to(unit::nm), 1e-8);
    EXPECT_NEAR(vacuum_wavelength(fraunhofer_line("D")->air_nm).to(unit::nm), kLineD.to(unit::nm),
                1e-8);
    // Helium's line in vacuum is at 587.725 nm [NIST ASD]; its tables have air of 15 °C.
    EXPECT_NEAR(kLined.to(unit::nm), 587.725, 0.005);
    EXPECT_FALSE(fraunhofer_line("x"));
}

}  // namespace
}  // namespace dewbow
