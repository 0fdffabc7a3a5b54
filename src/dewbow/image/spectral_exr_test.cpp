// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/spectral_exr.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "dewbow/image/exr.h"

namespace dewbow {
namespace {

/// A unit conversion rounds at most three times.
constexpr double kConversionTolerance = 1e-15;

double wavelength_nm(std::string_view name) {
    const std::optional<Wavelength> wavelength = emissive_channel_wavelength(name);
    return wavelength ? wavelength->to(unit::nm) : -1.0;
}

TEST(SpectralExr, NamesHaveACommaAndSixDecimals) {
    EXPECT_EQ(emissive_channel_name(550.0 * unit::nm), "S0.550,000000nm");
    EXPECT_EQ(emissive_channel_name(392.64705882 * unit::nm), "S0.392,647059nm");
}

TEST(SpectralExr, NamesReadBack) {
    for (double lambda_nm = 360.0; lambda_nm <= 830.0; lambda_nm += 0.015625)
        ASSERT_EQ(wavelength_nm(emissive_channel_name(lambda_nm * unit::nm)), lambda_nm);
}

TEST(SpectralExr, EveryNumberFormOfTheLayoutIsRead) {
    EXPECT_EQ(wavelength_nm("S0.550nm"), 550.0);
    EXPECT_EQ(wavelength_nm("S0.550,5nm"), 550.5);
    EXPECT_EQ(wavelength_nm("S0.550,nm"), 550.0);
    EXPECT_EQ(wavelength_nm("S0.,5nm"), 0.5);
    EXPECT_EQ(wavelength_nm("S0.5,5e2nm"), 550.0);
    EXPECT_EQ(wavelength_nm("S0.5,5E+2nm"), 550.0);
    EXPECT_EQ(wavelength_nm("S0.55000e-2nm"), 550.0);
}

TEST(SpectralExr, EveryUnitOfTheLayoutIsRead) {
    const std::map<std::string, double> nm_by_name{
        {"S0.1m", 1e9},
        {"S0.1dm", 1e8},
        {"S0.1cm", 1e7},
        {"S0.1mm", 1e6},
        {"S0.0,55um", 550.0},
        {"S0.550000pm", 550.0},
        {"S0.1dam", 1e10},
        {"S0.1hm", 1e11},
        {"S0.1km", 1e12},
        {"S0.1Mm", 1e15},
        {"S0.1Gm", 1e18},
        {"S0.1Tm", 1e21},
        {"S0.1Pm", 1e24},
        {"S0.1Em", 1e27},
        {"S0.1Zm", 1e30},
        {"S0.1Ym", 1e33},
        {"S0.2E1Em", 20e27},
        {"S0.1Hz", 299792458e9},
        {"S0.1kHz", 299792458e6},
        {"S0.5E14Hz", 599.584916},
        {"S0.500THz", 599.584916},
        {"S0.0,5PHz", 599.584916},
    };
    for (const auto& [name, expected] : nm_by_name)
        EXPECT_NEAR(wavelength_nm(name) / expected, 1.0, kConversionTolerance) << name;
}

TEST(SpectralExr, OtherNamesStateNoWavelength) {
    for (const char* name :
         {"",           "R",        "S0",         "S0.",        "S0.nm",     "S0.,nm",
          "S0.550",     "S0.550n",  "S0.550.0nm", "S0.-550nm",  "S0.+550nm", "S0. 550nm",
          "S0.550nm ",  "S0.550xm", "S0.550nnm",  "S0.5e",      "S0.5enm",   "S1.550nm",
          "S4.550nm",   "T.550nm",  "s0.550nm",   "S0.550nm.R", "S0.0nm",    "S0.0Hz",
          "S0.1e999nm", "S0.infnm", "S0.0x10nm",  "S0.550fm",   "S0.5,5,5nm"})
        EXPECT_FALSE(emissive_channel_wavelength(name)) << name;
    EXPECT_FALSE(emissive_channel_wavelength(std::string_view("S0.550nm\0", 9)));
}

TEST(SpectralExr, HeaderStatesTheLayout) {
    std::map<std::string, std::variant<std::string, double, std::int64_t>> facts;
    for (const Attribute& attribute : spectral_attributes())
        facts[attribute.name] = attribute.value;
    EXPECT_EQ(std::get<std::string>(facts.at("spectralLayoutVersion")), "1.0");
    EXPECT_EQ(std::get<std::string>(facts.at("emissiveUnits")), "W.m^-2.sr^-1");
    EXPECT_EQ(std::get<double>(facts.at("EV")), 0.0);
}

/// The layout's reference implementation wrote this file: D65, one pixel, every 5 nm.
TEST(SpectralExr, ReferenceImplementationsFileIsRead) {
    const std::filesystem::path path =
        std::filesystem::path(DEWBOW_SHARED_DATA) / "exr" / "spectral-exr_D65.exr";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is absent: set DEWBOW_SHARED_DATA to the folder that has it";
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};

    const DecodedExr decoded = decode_exr(bytes, path.string());
    EXPECT_EQ(decoded.image.channels.size(), 93u);
    std::map<double, float> spectrum;
    for (const Channel& channel : decoded.image.channels)
        if (const auto wavelength = emissive_channel_wavelength(channel.name))
            spectrum[wavelength->to(unit::nm)] = channel.values.at(0);
    ASSERT_EQ(spectrum.size(), 90u);
    for (const auto& [lambda_nm, value] : spectrum) {
        EXPECT_GE(lambda_nm, 380.0);
        EXPECT_EQ(std::fmod(lambda_nm, 5.0), 0.0);
        EXPECT_GT(value, 0.0f);
    }
    // CIE 15: D65 at 450 and 600 nm, relative to 560 nm. The file's values are rounded floats.
    const double tolerance = 1e-4;
    EXPECT_NEAR(spectrum.at(450.0) / spectrum.at(560.0), 1.170080, tolerance);
    EXPECT_NEAR(spectrum.at(600.0) / spectrum.at(560.0), 0.900062, tolerance);

    bool names_version = false;
    for (const Attribute& attribute : decoded.attributes)
        names_version |= attribute.name == "spectralLayoutVersion" &&
                         std::get<std::string>(attribute.value) == "1.0";
    EXPECT_TRUE(names_version);
}

}  // namespace
}  // namespace dewbow
