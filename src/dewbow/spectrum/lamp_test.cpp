// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/lamp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow {
namespace {

struct Chromaticity {
    double x, y;
};
Chromaticity chromaticity(const Spectrum& spectrum) {
    const auto xyz = xyz_from_spectrum(spectrum);
    const double sum = xyz[0] + xyz[1] + xyz[2];
    return {xyz[0] / sum, xyz[1] / sum};
}

/// Of the CIE 1960 diagram.
struct Uv {
    double u, v;
};
Uv uv(Chromaticity c) {
    const double denominator = -2.0 * c.x + 12.0 * c.y + 3.0;
    return {4.0 * c.x / denominator, 6.0 * c.y / denominator};
}

/// Temperature of the black body nearest to `spectrum` in (u, v), by golden sections.
double correlated_temperature_K(const Spectrum& spectrum) {
    const Uv own = uv(chromaticity(spectrum));
    const auto distance = [&](double log_K) {
        const Uv body = uv(chromaticity(*make_blackbody(std::exp(log_K) * unit::K)));
        return std::hypot(body.u - own.u, body.v - own.v);
    };
    const double section = 0.5 * (std::sqrt(5.0) - 1.0);
    double low = std::log(1500.0), high = std::log(20000.0);
    while (high - low > 1e-4) {
        const double a = high - section * (high - low), b = low + section * (high - low);
        (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    return std::exp(0.5 * (low + high));
}

TEST(Lamps, AreAsBrightAsOneAndSayWhereTheyAreFrom) {
    constexpr double kRounding = 1e-12;
    const std::set<std::string> kinds{"illuminant", "incandescent", "fluorescent",
                                      "discharge",  "led",          "laser"};
    std::set<std::string> names;
    for (const Lamp& lamp : lamp_catalogue()) {
        EXPECT_TRUE(names.insert(lamp.name).second) << lamp.name << " is there twice";
        EXPECT_EQ(kinds.count(lamp.kind), 1u) << lamp.name;
        EXPECT_FALSE(lamp.description.empty() || lamp.source.empty() || lamp.licence.empty())
            << lamp.name;
        EXPECT_NEAR(xyz_from_spectrum(*lamp.spectrum)[1] / cie_y_integral(), 1.0, kRounding)
            << lamp.name;
        for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 0.25) {
            ASSERT_GE((*lamp.spectrum)(nm * unit::nm), 0.0) << lamp.name << " at " << nm;
        }
    }
}

TEST(Lamps, OfTheCieHaveThePublishedChromaticities) {
    struct Published {
        const char* name;
        double x, y;
    };
    // CIE 15:2018: tables of illuminants D, FL, FL3, HP and LED.
    constexpr Published kPublished[] = {
        {"D50", 0.34567, 0.35851},  {"D55", 0.33243, 0.34744},   {"D75", 0.29903, 0.31488},
        {"FL1", 0.3131, 0.3371},    {"FL2", 0.3721, 0.3751},     {"FL3", 0.4091, 0.3941},
        {"FL4", 0.4402, 0.4031},    {"FL5", 0.3138, 0.3452},     {"FL6", 0.3779, 0.3882},
        {"FL7", 0.3129, 0.3292},    {"FL8", 0.3458, 0.3586},     {"FL9", 0.3741, 0.3727},
        {"FL10", 0.3458, 0.3588},   {"FL11", 0.3805, 0.3769},    {"FL12", 0.4370, 0.4042},
        {"FL3.1", 0.4407, 0.4033},  {"FL3.2", 0.3808, 0.3734},   {"FL3.3", 0.3153, 0.3439},
        {"FL3.4", 0.4429, 0.4043},  {"FL3.5", 0.3749, 0.3672},   {"FL3.6", 0.3488, 0.3600},
        {"FL3.7", 0.4384, 0.4045},  {"FL3.8", 0.3820, 0.3832},   {"FL3.9", 0.3499, 0.3591},
        {"FL3.10", 0.3455, 0.3560}, {"FL3.11", 0.3245, 0.3434},  {"FL3.12", 0.4377, 0.4037},
        {"FL3.13", 0.3830, 0.3724}, {"FL3.14", 0.3447, 0.3609},  {"FL3.15", 0.3127, 0.3288},
        {"HP1", 0.5330, 0.4150},    {"HP2", 0.4778, 0.4158},     {"HP3", 0.4302, 0.4075},
        {"HP4", 0.3812, 0.3797},    {"HP5", 0.3776, 0.3713},     {"LED-B1", 0.4560, 0.4078},
        {"LED-B2", 0.4357, 0.4012}, {"LED-B3", 0.3756, 0.3723},  {"LED-B4", 0.3422, 0.3502},
        {"LED-B5", 0.3118, 0.3236}, {"LED-BH1", 0.4474, 0.4066}, {"LED-RGB1", 0.4557, 0.4211},
        {"LED-V1", 0.4548, 0.4044}, {"LED-V2", 0.3781, 0.3775},
    };
    // They were published from 5 nm sums. Linear interpolation widens each mercury line of a table
    // to a triangle of the same area.
    constexpr double kInterpolation = 5e-4;
    for (const Published& published : kPublished) {
        const auto [x, y] = chromaticity(*find_illuminant(published.name));
        EXPECT_NEAR(x, published.x, kInterpolation) << published.name;
        EXPECT_NEAR(y, published.y, kInterpolation) << published.name;
    }
}

TEST(Lamps, HaveTheSunAboveTheAtmosphere) {
    // Of ASTM G173's extraterrestrial spectrum (Gueymard's), another evaluation.
    constexpr double kEvaluations = 5e-4;
    const auto [x, y] = chromaticity(*find_illuminant("sun-am0"));
    EXPECT_NEAR(x, 0.32338, kEvaluations);
    EXPECT_NEAR(y, 0.33266, kEvaluations);
}

// Chromaticities as another program computes them from its tables: colour-science, datasets of
// light sources.
TEST(Lamps, OfNistHaveTheirChromaticities) {
    struct Computed {
        const char* name;
        double x, y;
    };
    constexpr Computed kComputed[] = {
        {"lamp/mercury", 0.39202, 0.38378},
        {"lamp/mercury-coated", 0.38979, 0.37339},
        {"lamp/metal-halide-3000K", 0.42858, 0.38817},
        {"lamp/metal-halide-4000K", 0.37315, 0.37137},
        {"lamp/sodium-high-pressure", 0.52923, 0.41137},
        {"lamp/incandescent", 0.45073, 0.40805},
        {"lamp/incandescent-neodymium", 0.44740, 0.39501},
        {"lamp/fluorescent-cool-white", 0.36926, 0.37255},
        {"lamp/fluorescent-daylight", 0.31266, 0.33199},
        {"lamp/fluorescent-triphosphor", 0.41316, 0.39642},
        {"led/phosphor-yag", 0.30776, 0.32527},
        {"lamp/xenon-projector", 0.31525, 0.33287},
    };
    constexpr double kInterpolation = 5e-4;  // as above
    for (const Computed& computed : kComputed) {
        const auto [x, y] = chromaticity(*find_lamp(computed.name).spectrum);
        EXPECT_NEAR(x, computed.x, kInterpolation) << computed.name;
        EXPECT_NEAR(y, computed.y, kInterpolation) << computed.name;
    }
}

TEST(Lamps, HaveThePublishedColourTemperatures) {
    struct Published {
        const char* name;
        double kelvin;
    };
    // CIE 15:2018, beside the chromaticities.
    constexpr Published kPublished[] = {
        {"D50", 5003},    {"D75", 7504},    {"FL2", 4230},    {"FL11", 4000},    {"HP2", 2506},
        {"LED-B1", 2733}, {"LED-B3", 4103}, {"LED-B5", 6598}, {"LED-BH1", 2851}, {"LED-V2", 4070}};
    constexpr double kShare = 0.005;  // 5 nm sums again, and FL to 10 K
    for (const Published& published : kPublished) {
        EXPECT_NEAR(correlated_temperature_K(*find_illuminant(published.name)) / published.kelvin,
                    1.0, kShare)
            << published.name;
    }
}

/// λ in vacuum of what NIST lists in air, by the index of air. [Ciddor 1996, eq. 1, 15 °C, 450 ppm]
double vacuum_nm(double air_nm) {
    const double s2 = 1e6 / (air_nm * air_nm);  // µm⁻²
    return air_nm * (1.0 + 0.05792105 / (238.0185 - s2) + 0.00167917 / (57.362 - s2));
}

/// Power per nm in the middle of the line at `nm`, over the strongest of the lamp.
double strength_at(const std::string& lamp, double nm) {
    const SpectrumPtr spectrum = find_lamp(lamp).spectrum;
    return (*spectrum)(nm * unit::nm) / spectrum->max_value();
}

TEST(Lamps, ShineAtTheLinesOfTheirGas) {
    struct Strong {
        const char* lamp;
        double air_nm;      ///< NIST Handbook of Basic Atomic Spectroscopic Data, persistent lines
        bool alone = true;  ///< no other box touches it
    };
    constexpr Strong kLines[] = {
        {"helium", 388.8648},
        {"helium", 447.1479},
        {"helium", 501.5678},
        {"helium", 587.5621},
        {"helium", 667.8151},
        {"helium", 706.5190, false},
        {"neon", 585.24879},
        {"neon", 614.30626, false},
        {"neon", 640.2248, false},
        {"neon", 703.24131, false},
        {"hydrogen", 656.2819},
        {"hydrogen", 486.1333},
        {"hydrogen", 434.0471},
        {"cadmium", 508.5822},
        {"cadmium", 643.8470},
        {"krypton", 557.0289, false},
        {"krypton", 587.0916},
        {"mercury-low-pressure", 404.6563},
        {"mercury-low-pressure", 435.8328, false},
        {"mercury-low-pressure", 546.0735},
        {"mercury-low-pressure", 576.9598},
        {"sodium-low-pressure", 588.9950, false},
        {"hene", 632.8164},
        {"hene-green", 543.3650},
        {"argon-488", 487.9864},
        {"argon-514", 514.5308},
        {"hecd-442", 441.5630},
    };
    constexpr double kHalfWidth_nm = 1.0;
    constexpr double kWavelength_nm = 0.02;  // fine structure of hydrogen, 0.016 nm
    constexpr double kFaint = 0.03;          // the fainter ones are this part of the strongest
    for (const Strong& line : kLines) {
        const double nm = vacuum_nm(line.air_nm);
        const auto strength = [&](double from_nm) { return strength_at(line.lamp, nm + from_nm); };
        EXPECT_GT(strength(0.0), kFaint) << line.lamp << " at " << nm;
        EXPECT_GT(strength(-kHalfWidth_nm + kWavelength_nm), kFaint) << line.lamp << " at " << nm;
        EXPECT_GT(strength(kHalfWidth_nm - kWavelength_nm), kFaint) << line.lamp << " at " << nm;
        if (!line.alone) continue;
        EXPECT_EQ(strength(-kHalfWidth_nm - kWavelength_nm), 0.0) << line.lamp << " at " << nm;
        EXPECT_EQ(strength(kHalfWidth_nm + kWavelength_nm), 0.0) << line.lamp << " at " << nm;
    }
}

TEST(Lamps, OfOneColourLieOnTheSpectralLocus) {
    // CIE 1931: of 633 nm between those of 630 and 635 nm; of the D lines between 589 and 590 nm.
    struct Locus {
        const char* name;
        double x, y;
    };
    constexpr Locus kLocus[] = {{"laser/hene", 0.7116, 0.2883},
                                {"laser/diode-520", 0.0743, 0.8338},
                                {"laser/diode-450", 0.1566, 0.0177},
                                {"lamp/sodium-low-pressure", 0.5715, 0.4279}};
    // Steps of 0.5 nm see a box of 2 nm by up to 0.25 nm off its middle; the locus moves by 0.007
    // per nm at 520 nm.
    constexpr double kBox = 2.5e-3;
    for (const Locus& locus : kLocus) {
        const auto [x, y] = chromaticity(*find_lamp(locus.name).spectrum);
        EXPECT_NEAR(x, locus.x, kBox) << locus.name;
        EXPECT_NEAR(y, locus.y, kBox) << locus.name;
    }
}

TEST(Lamps, HaveTheColoursThatPeopleSee) {
    const auto neon = chromaticity(*find_lamp("neon").spectrum);
    EXPECT_GT(neon.x, 0.63);  // orange-red
    EXPECT_LT(neon.y, 0.36);
    const auto hydrogen = chromaticity(*find_lamp("hydrogen").spectrum);
    EXPECT_LT(hydrogen.y, 0.25);  // pink
}

std::string refusal(const char* name) {
    try {
        find_lamp(name);
    } catch (const InputError& error) {
        return error.sentence() + "; " + error.hint();
    }
    return "found";
}

TEST(FindLamp, FoldsNames) {
    EXPECT_EQ(find_lamp("LED/Cool_White").name, "led/cool-white");
    EXPECT_EQ(find_lamp("HeNe").name, "laser/hene");
    EXPECT_EQ(find_lamp("d65").name, "illuminant/D65");
    EXPECT_EQ(find_lamp("FL3.1").name, "illuminant/FL3.1");
    for (const Lamp& lamp : lamp_catalogue()) EXPECT_EQ(&find_lamp(lamp.name), &lamp);
}

TEST(FindLamp, NamesTheNearestOfAnUnknownLamp) {
    EXPECT_EQ(refusal("led/cool-wite"),
              "unknown lamp \"led/cool-wite\"; did you mean "
              "led/cool-white?");
    EXPECT_EQ(refusal("laser/henne"), "unknown lamp \"laser/henne\"; did you mean laser/hene?");
    EXPECT_EQ(refusal("lamp/sodium-low-presure"),
              "unknown lamp \"lamp/sodium-low-presure\"; did you mean lamp/sodium-low-pressure?");
    EXPECT_EQ(refusal("kripton"), "unknown lamp \"kripton\"; did you mean lamp/krypton?");
    EXPECT_EQ(refusal("lamp/cool-white"),
              "unknown lamp \"lamp/cool-white\"; did you mean "
              "led/cool-white?");
    EXPECT_NE(refusal("").find("known are illuminant/D65"), std::string::npos) << refusal("");
    EXPECT_NE(refusal("a candle on a birthday cake").find("and more"), std::string::npos);
}

}  // namespace
}  // namespace dewbow
