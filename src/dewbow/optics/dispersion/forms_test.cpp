// SPDX-License-Identifier: Apache-2.0

// Formulas against numbers that others computed or published.

#include <gtest/gtest.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/optics/dispersion.h"

namespace dewbow {
namespace {

double index(const std::string& form, const std::vector<double>& c, double lambda_nm,
             std::optional<DataRange> range = std::nullopt) {
    return (*make_dispersion({form, c, IndexReference::vacuum, range}))(lambda_nm * unit::nm).value;
}

// Fits of each AGF formula to SCHOTT N-BK7, with n_d and V_d from an independent program in another
// language; six decimals of each are stated.
struct Fit {
    const char* form;
    double n_d, V_d;
    std::vector<double> coefficients;
};
const Fit kFits[] = {
    {"agf_1",
     1.516800,
     64.167353,
     {2.271537834, -9.934643839e-3, 1.082664570e-2, 1.413701482e-4, 8.201765651e-7,
      1.047865234e-7}},
    {"agf_2",
     1.516800,
     64.167336,
     {1.039612120, 6.000698670e-3, 2.317923440e-1, 2.001791440e-2, 1.010469450, 1.035606530e2}},
    {"agf_3",
     1.516800,
     64.167021,
     {1.508387304, 3.378631074e-3, -3.779095927e-5, -6.726765134e-3, 4.752508546e-3,
      -2.584815207e-3}},
    {"agf_4", 1.516713, 64.665532, {0.0, 1.388888605, 9.249976158e-2, 1.233417089e1, 10.0}},
    {"agf_5", 1.516801, 64.105328, {1.497370919, 1.019416837e-2, 3.234309410e-4}},
    {"agf_6",
     1.516800,
     64.167336,
     {1.039612120, 6.000698670e-3, 2.317923440e-1, 2.001791440e-2, 1.010469450, 1.035606530e2, 0.0,
      1e-2}},
    {"agf_7", 1.516793, 64.065814, {2.270296578, 1.116103037e-2, 1.03e-2, 8.567386200e-3}},
    {"agf_8", 1.516793, 64.065814, {1.186701396, 1.083595182, 1.03e-2, 8.567386200e-3}},
    {"agf_9", 1.516794, 64.068043, {1.186491550, 1.083781624, 1.03e-2, 8.485920887e-1, 100.0}},
    {"agf_10",
     1.516800,
     64.167339,
     {2.271638130, -9.986184503e-3, 1.074666150e-2, 1.752548212e-4, -7.423957427e-6, 1.258789369e-6,
      -8.624243568e-8, 2.660577765e-9}},
    {"agf_11",
     1.516800,
     64.167336,
     {1.039612120, 6.000698670e-3, 2.317923440e-1, 2.001791440e-2, 1.010469450, 1.035606530e2, 0.0,
      1e-2, 0.0, 2e-2}},
    {"agf_12",
     1.516800,
     64.167335,
     {2.271462219, -9.857081120e-3, 1.085829495e-2, 1.346064088e-4, 1.542596936e-6, 7.423995046e-8,
      9.312939616e-7, -3.931459772e-5}},
    {"agf_13",
     1.516800,
     64.167336,
     {2.271402672, -9.754460785e-3, -9.667461977e-5, 1.087909373e-2, 1.301508312e-4, 2.107564784e-6,
      3.701252569e-8, 7.273458151e-10, 2.442118036e-11}},
};
constexpr double kSixDecimals = 5.1e-7;
/// n_F − n_C = 0.008 of coefficients with ten figures: 1e-6 of V_d.
constexpr double kAbbeOfTenFigures = 2e-4;

TEST(AgfForms, GiveWhatAnotherProgramComputes) {
    for (const Fit& fit : kFits) {
        const auto n = [&](double l) { return index(fit.form, fit.coefficients, l); };
        EXPECT_NEAR(n(kAird_nm), fit.n_d, kSixDecimals) << fit.form;
        EXPECT_NEAR((n(kAird_nm) - 1.0) / (n(kAirF_nm) - n(kAirC_nm)), fit.V_d, kAbbeOfTenFigures)
            << fit.form;
    }
}

// The database's materials at d, by the same program; eight decimals.
constexpr double kEightDecimals = 5.1e-9;

TEST(RiiForms, GiveWhatAnotherProgramComputes) {
    const auto at_d = [](const std::string& form, const std::vector<double>& c) {
        return index(form, c, kAird_nm);
    };
    // Fused silica (Malitson 1965, whose table has 1.45846), quartz o, PMMA, zinc sulfide,
    // soda-lime glass, carbon dioxide.
    EXPECT_NEAR(
        at_d("rii_1", {0.0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161}),
        1.45846369, kEightDecimals);
    EXPECT_NEAR(at_d("rii_2", {0.28604141, 1.07044083, 0.0100585997, 1.10202242, 100.0}),
                1.54427619, kEightDecimals);
    EXPECT_NEAR(at_d("rii_3", {2.1778, 0.0061209, 2.0, -0.0015004, 4.0, 0.023678, -2.0, -0.0042137,
                               -4.0, 0.00073417, -6.0, -4.5042e-05, -8.0}),
                1.49252744, kEightDecimals);
    EXPECT_NEAR(index("rii_4", {8.393, 0.14383, 0.0, 0.2421, 2.0, 4430.99, 0.0, 36.71, 2.0},
                      kAird_nm, DataRange{405.0, 13000.0}),
                2.36769434, kEightDecimals);
    EXPECT_NEAR(at_d("rii_5", {1.513, -0.003169, 2.0, 0.003962, -2.0}), 1.52338241, kEightDecimals);
    EXPECT_NEAR(at_d("rii_6", {0.0, 0.06991, 166.175, 0.0014472, 79.609, 6.42941e-05, 56.3064,
                               5.21306e-05, 46.0196, 1.46847e-06, 0.0584738}),
                1.00044893, kEightDecimals);
}

// Three that hardly any material uses. Silver bromide n_D = 2.2536 and urea n_e = 1.602 are those
// of the CRC Handbook, silicon at 10 µm 3.4215 that of the paper's own table.
constexpr double kHandbookIndex = 5e-3;

TEST(RiiForms, GiveThePublishedIndicesOfTheirOnlyMaterials) {
    const DataRange infrared{2437.3, 25000.0}, visible{495.0, 670.0};
    const std::vector<double> silicon{3.41983, 0.159906, -0.123109, 1.26878e-6, -1.95104e-9};
    EXPECT_NEAR(index("rii_7", silicon, 10000.0, infrared), 3.421524557665201, 1e-13);
    EXPECT_NEAR(index("rii_7", silicon, 3000.0, infrared), 3.436134677527718, 1e-13);
    const double bromide = index("rii_8", {0.452505, 0.09939, 0.070537, -0.000150}, 589.3, visible);
    EXPECT_NEAR(bromide, 2.2572448070069675, 1e-13);
    EXPECT_NEAR(bromide, 2.2536, kHandbookIndex);
    const double urea = index("rii_9", {2.51527, 0.0240, 0.0300, 0.020, 1.52, 0.8771}, 589.3);
    EXPECT_NEAR(urea, 1.6063115648309017, 1e-13);
    EXPECT_NEAR(urea, 1.602, kHandbookIndex);
}

TEST(Hartmann, IsThePapersFormulaAndTheGeneralOne) {
    // η = 1 + b/(c − λ) with b < 0, [Musgrave 1989].
    EXPECT_NEAR(index("hartmann", {1.0, 0.25, 0.1}, 600.0), 1.0 - 0.25 / (0.1 - 0.6), 1e-15);
    EXPECT_NEAR(index("hartmann", {1.4924, 0.0068, 0.12, 1.2}, 550.0),
                1.4924 + 0.0068 / std::pow(0.43, 1.2), 1e-15);
}

TEST(Conrady, OfThePaperIsAPolynomial) {
    const double l = 0.55;  // η = a + b/λ + c/λ²
    EXPECT_NEAR(index("rii_5", {1.5, 0.005, -1.0, 0.002, -2.0}, 550.0),
                1.5 + 0.005 / l + 0.002 / (l * l), 1e-15);
}

TEST(PovRay, HasItsRatioBetween380And730Nanometres) {
    for (double dispersion : {1.0, 1.007, 1.035, 1.15}) {
        const auto n = [&](double l) { return index("pov_ray", {1.5, dispersion}, l); };
        EXPECT_NEAR(n(380.0) / n(730.0), dispersion, 1e-14);
        EXPECT_NEAR(n(555.0), 1.5, 1e-14);  // the middle of its spectrum has the ior itself
    }
}

// IAPWS R9-97, table 3 and the program checks that go with it.
constexpr double kReleaseDecimals = 5.1e-7, kEightDecimalsOfWater = 5.1e-9;

TEST(Water, GivesTheCheckValuesOfTheRelease) {
    EXPECT_NEAR(index("water", {25.0, 997.047435}, 226.5), 1.39277824, kEightDecimalsOfWater);
    EXPECT_NEAR(index("water", {500.0, 30.4758534}, 589.3), 1.00949307, kEightDecimalsOfWater);
    // 0 °C and 0.1 MPa
    EXPECT_NEAR(index("water", {0.0, 999.843}, 226.5), 1.394527, kReleaseDecimals);
    EXPECT_NEAR(index("water", {0.0, 999.843}, 589.0), 1.334344, kReleaseDecimals);
    EXPECT_NEAR(index("water", {0.0, 999.843}, 1013.98), 1.326135, kReleaseDecimals);
}

TEST(Water, HasTheDensityOfOneAtmosphere) {
    // 998.2071 kg/m³ at 20 °C, 958.35 at 100 °C [IAPWS-95 at 101325 Pa]; Kell is within 0.006.
    constexpr double kDensityError = 3e-6;
    for (double l : {400.0, 589.3, 700.0}) {
        EXPECT_NEAR(index("water", {20.0}, l), index("water", {20.0, 998.2071}, l), kDensityError);
        EXPECT_NEAR(index("water", {100.0}, l), index("water", {100.0, 958.35}, l), 1e-5);
        EXPECT_LT(index("water", {30.0}, l), index("water", {20.0}, l));
    }
}

TEST(SeaWater, AddsWhatAnotherFormulaSays) {
    // W. Matthäus, Beitr. Meereskunde 33, 73 (1974), of other measurements; λ from 400 to 700 nm.
    constexpr double kFormulas = 6e-5;
    const double S = 35.0;
    for (double t : {0.0, 10.0, 20.0, 30.0})
        for (double l : {420.0, 500.0, 589.3, 680.0}) {
            const double L = 1e-3 * l;
            const double matthaeus = S * (3.011e-4 - 7.9362e-7 * t + 8.06e-9 * t * t -
                                          4.249e-4 * L + 5.847e-4 * L * L - 2.812e-4 * L * L * L);
            EXPECT_NEAR(index("sea_water", {t, S}, l) - index("water", {t}, l), matthaeus,
                        kFormulas)
                << t << " " << l;
        }
}

TEST(SeaWater, IsTheFormulaForSeaWaterAgainstAir) {
    // Quan & Fry's whole formula, pure water included, is against air; IAPWS times 1/1.00027 is
    // too. It errs by 3.5e-5 for pure water at 20 °C.
    constexpr double kPureWater = 4e-5;
    for (double t : {5.0, 20.0, 30.0})
        for (double S : {0.0, 20.0, 35.0})
            for (double l : {400.0, 500.0, 600.0, 700.0}) {
                const double n = 1.31405 + (1.779e-4 - 1.05e-6 * t + 1.6e-8 * t * t) * S -
                                 2.02e-6 * t * t + (15.868 + 0.01155 * S - 0.00423 * t) / l -
                                 4382.0 / (l * l) + 1.1455e6 / (l * l * l);
                EXPECT_NEAR(index("sea_water", {t, S}, l) / (*air())(l * unit::nm).value, n,
                            kPureWater)
                    << t << " " << S << " " << l;
            }
}

}  // namespace
}  // namespace dewbow
