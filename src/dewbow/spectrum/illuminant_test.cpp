// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/illuminant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"

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

TEST(Illuminants, HaveThePublishedChromaticities) {
    struct Published {
        const char* name;
        double x, y;
    };
    // D65, A, C: CIE 15:2004. B: Wyszecki & Stiles 1982. E: by definition.
    constexpr Published kPublished[] = {{"D65", 0.31272, 0.32903},
                                        {"A", 0.44758, 0.40745},
                                        {"B", 0.34842, 0.35161},
                                        {"C", 0.31006, 0.31616},
                                        {"E", 1.0 / 3.0, 1.0 / 3.0}};
    // Those of B and C were published from 5 nm sums; linear interpolation to 1 nm moves them this
    // far.
    constexpr double kInterpolation = 7e-5;
    for (const Published& published : kPublished) {
        const auto [x, y] = chromaticity(*find_illuminant(published.name));
        EXPECT_NEAR(x, published.x, kInterpolation) << published.name;
        EXPECT_NEAR(y, published.y, kInterpolation) << published.name;
    }
    const auto [x, y] = chromaticity(*find_illuminant("D65"));
    constexpr double kLastDigit = 1.1e-5;
    EXPECT_NEAR(x, 0.31272, kLastDigit);
    EXPECT_NEAR(y, 0.32903, kLastDigit);
}

TEST(Illuminants, AreAsBrightAsOne) {
    constexpr double kRounding = 1e-12;
    for (const std::string& name : illuminant_names()) {
        const double y = xyz_from_spectrum(*find_illuminant(name))[1];
        EXPECT_NEAR(y / cie_y_integral(), 1.0, kRounding) << name;
    }
}

TEST(Illuminants, AreFoundByNameOnly) {
    const std::vector<std::string> names = illuminant_names();
    for (const char* name :
         {"D50", "D55", "D65", "D75", "A", "B", "C", "E", "FL12", "FL3.15", "HP5", "LED-RGB1"}) {
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
    }
    EXPECT_EQ(find_illuminant("D60"), nullptr);
    EXPECT_EQ(find_illuminant("cool-white"), nullptr) << "a lamp";
    EXPECT_EQ(find_illuminant(""), nullptr);
    EXPECT_TRUE(find_illuminant("E")->is_constant());
}

TEST(Illuminants, AIsTheBlackBodyThatDefinesIt) {
    // A is Planck's law at 2848 K with c₂ = 1.435e-2 m K. [CIE S 014-2]  With today's c₂ that is
    // 2855.5 K.
    constexpr double kSecondRadiationConstant_m_K = 1.438776877e-2;
    const double temperature_K = 2848.0 * kSecondRadiationConstant_m_K / 1.435e-2;
    const SpectrumPtr body = make_blackbody(temperature_K * unit::K);
    const SpectrumPtr a = find_illuminant("A");
    constexpr double kSixDigits = 2e-5;  // of the table, and of linear interpolation
    for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
        EXPECT_NEAR((*body)(nm * unit::nm) / (*a)(nm * unit::nm), 1.0, kSixDigits) << nm;
    }
}

TEST(Planck, PeaksWhereWienSays) {
    constexpr double kWien_m_K = 2.897771955e-3;  // CODATA 2018
    for (double temperature_K : {300.0, 2856.0, 5772.0, 20000.0}) {
        const double peak_nm = kWien_m_K / temperature_K * 1e9;
        const auto at = [&](double nm) {
            return planck_radiance(temperature_K * unit::K, nm * unit::nm).to(unit::W_per_m2_sr_nm);
        };
        // Equal values 1e-3 to both sides of a maximum, but for the third derivative.
        EXPECT_LT(at(peak_nm * 0.999), at(peak_nm));
        EXPECT_LT(at(peak_nm * 1.001), at(peak_nm));
        const double slope = (at(peak_nm * 1.0001) - at(peak_nm * 0.9999)) / at(peak_nm);
        EXPECT_NEAR(slope, 0.0, 1e-9);
    }
}

TEST(Planck, IntegratesToStefanBoltzmann) {
    constexpr double kStefanBoltzmann = 5.670374419e-8;  // W m⁻² K⁻⁴, CODATA 2018
    for (double temperature_K : {500.0, 5772.0}) {
        // Trapezoid in ln λ from λT = 1e-4 to 1e3 m K: beyond lies less than 1e-8 of the whole.
        constexpr int kSteps = 4000;
        const double log_step = std::log(1e7) / kSteps;
        double sum = 0.0;
        for (int i = 0; i <= kSteps; ++i) {
            const double nm = 1e9 * 1e-4 / temperature_K * std::exp(i * log_step);
            const auto radiance = planck_radiance(temperature_K * unit::K, nm * unit::nm);
            sum += radiance.to(unit::W_per_m2_sr_nm) * nm * log_step;
        }
        const double expected = kStefanBoltzmann * std::pow(temperature_K, 4) / std::numbers::pi;
        EXPECT_NEAR(sum / expected, 1.0, 1e-8);
    }
}

TEST(Blackbody, FollowsPlanck) {
    // What kBlackbodyStep_nm promises for 500 K; hotter bodies are smoother.
    constexpr double kInterpolation = 4e-4;
    for (double temperature_K : {500.0, 2500.0, 6500.0, 1e6}) {
        const SpectrumPtr body = make_blackbody(temperature_K * unit::K);
        const auto ratio = [&](double nm) {
            return (*body)(nm * unit::nm) /
                   planck_radiance(temperature_K * unit::K, nm * unit::nm).to(unit::W_per_m2_sr_nm);
        };
        const double at_555 = ratio(555.0);
        for (double nm = 360.1; nm < 830.0; nm += 7.3) {
            EXPECT_NEAR(ratio(nm) / at_555, 1.0, kInterpolation) << temperature_K << " K, " << nm;
        }
        EXPECT_NEAR(xyz_from_spectrum(*body)[1] / cie_y_integral(), 1.0, 1e-12);
    }
}

TEST(Blackbody, RefusesTemperaturesOutsideItsRange) {
    EXPECT_THROW(make_blackbody(499.0 * unit::K), InputError);
    EXPECT_THROW(make_blackbody(1.1e6 * unit::K), InputError);
    EXPECT_THROW(make_blackbody(std::nan("") * unit::K), InputError);
}

}  // namespace
}  // namespace dewbow
