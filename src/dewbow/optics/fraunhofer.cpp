// SPDX-License-Identifier: Apache-2.0
#include "dewbow/optics/fraunhofer.h"

#include "dewbow/optics/dispersion.h"

namespace dewbow {
namespace {

constexpr FraunhoferLine kLines[] = {
    {"i", "mercury", 365.0146},  {"h", "mercury", 404.6561},  {"G", "iron, calcium", 430.774},
    {"g", "mercury", 435.8343},  {"F'", "cadmium", 479.9914}, {"F", "hydrogen", kAirF_nm},
    {"e", "mercury", 546.0740},  {"d", "helium", kAird_nm},   {"D", "sodium", 589.2938},
    {"C'", "cadmium", 643.8469}, {"C", "hydrogen", kAirC_nm}, {"B", "oxygen", 686.719},
    {"r", "helium", 706.5188},   {"A'", "potassium", 768.2},  {"s", "caesium", 852.11},
    {"t", "mercury", 1013.98},
};

}  // namespace

std::span<const FraunhoferLine> fraunhofer_lines() { return kLines; }

std::optional<FraunhoferLine> fraunhofer_line(std::string_view name) {
    for (const FraunhoferLine& line : kLines)
        if (line.name == name) return line;
    return std::nullopt;
}

Wavelength vacuum_wavelength(double air_nm) {
    double vacuum_nm = air_nm;
    // The index of air changes by less than 1e-7 over the shift of 0.3 nm: each round gains seven
    // digits.
    for (int round = 0; round < 3; ++round)
        vacuum_nm = air_nm * (*air())(vacuum_nm * unit::nm).value;
    return vacuum_nm * unit::nm;
}

}  // namespace dewbow
