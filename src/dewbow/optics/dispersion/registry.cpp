// SPDX-License-Identifier: Apache-2.0

// All formulas by name.

#include "dewbow/optics/dispersion/forms.h"

namespace dewbow {
namespace {

using namespace dispersion;

constexpr std::size_t kRiiSellmeier = 1 + 2 * kMostResonances;
constexpr std::size_t kRiiPowers = 1 + 2 * kMostPowers;
constexpr std::size_t kRiiCauchy = 11;
constexpr std::size_t kRiiGas = 1 + 2 * kMostGasTerms;

std::vector<DispersionForm> named_forms() {
    return {
        {"constant", "n", "", 1, 1, make_constant},
        {"sellmeier",
         "n² = 1 + B1 λ²/(λ² − C1) + B2 λ²/(λ² − C2) + …  (B1, C1, B2, C2, …; C in µm²)",
         "Sellmeier 1871", 2, 2 * kMostResonances, make_sellmeier},
        {"cauchy", "n = A + B/λ² + C/λ⁴ + …  (A, B, C, …)", "Cauchy 1836", 1, kMostCauchy,
         make_cauchy},
        {"hartmann", "n = n0 + b/(λ − c)^p  (n0, b, c, p; p = 1 where it is left out)",
         "Hartmann 1898; with n0 = p = 1 in Musgrave 1989", 3, 4, make_hartmann},
        {"conrady", "n = n0 + A/λ + B/λ^3.5  (n0, A, B)", "Conrady 1929", 3, 3, make_conrady},
        {"herzberger", "n = A + B L + C L² + D λ² + E λ⁴ + F λ⁶, L = 1/(λ² − 0.028)  (A, B, …)",
         "Herzberger 1959", 3, 6, make_herzberger},
        {"schott", "n² = a0 + a1 λ² + a2/λ² + a3/λ⁴ + a4/λ⁶ + …  (a0, a1, …)", "Schott 1966", 3,
         kMostSchott, make_schott},
        {"extended_3", "n² = a0 + a1 λ² + a2 λ⁴ + a3/λ² + a4/λ⁴ + …  (a0, a1, …)",
         "Zemax OpticStudio, Extended 3", 4, kMostSeries, make_extended_3},
        {"handbook_1", "n² = A + B/(λ² − C) − D λ²  (A, B, C, D)", "Handbook of Optics", 4, 4,
         make_handbook_1},
        {"abbe", "n = A + B/λ² with the given n_d and Abbe number V_d  (n_d, V_d)",
         "glTF KHR_materials_dispersion; OpenPBR 1.1", 2, 2, make_abbe},
        {"pov_ray", "n = ior · dispersion^((555 nm − λ)/350 nm)  (ior, dispersion)",
         "POV-Ray 3.8, SpectralBand::GetDispersionIOR", 2, 2, make_pov_ray},
        {"table", "monotone cubic in 1/λ²  (λ1, n1, λ2, n2, …; λ in µm, rising)",
         "Fritsch & Carlson 1980", 4, kMostTableNumbers, make_table},
        {"gas", "n = 1 + B1/(C1 − 1/λ²) + B2/(C2 − 1/λ²) + …  (B1, C1, B2, C2, …; in 1/µm²)",
         "Ciddor 1996", 2, 2 * kMostGasTerms, make_gas},
        {"water", "liquid water at 101325 Pa  (temperature in °C), or of a density (…, kg/m³)",
         "IAPWS R9-97; Kell 1975", 1, 2, make_water},
        {"sea_water", "sea water at 101325 Pa  (temperature in °C, salinity in g/kg)",
         "IAPWS R9-97; Quan & Fry 1995", 2, 2, make_sea_water},
    };
}

std::vector<DispersionForm> agf_forms() {
    const char* const source = "Zemax glass catalogue (AGF)";
    return {
        {"agf_1", "n² = a0 + a1 λ² + a2/λ² + a3/λ⁴ + a4/λ⁶ + a5/λ⁸  (Schott)", source, 1, 6,
         make_agf_1},
        {"agf_2", "n² = 1 + Σ K λ²/(λ² − L)  (K1, L1, … K3, L3; Sellmeier 1)", source, 1, 6,
         make_agf_sellmeier<3>},
        {"agf_3", "n = A + B L + C L² + D λ² + E λ⁴ + F λ⁶, L = 1/(λ² − 0.028)  (Herzberger)",
         source, 1, 6, make_agf_3},
        {"agf_4", "n² = 1 + A + B1 λ²/(λ² − λ1²) + B2/(λ² − λ2²)  (A, B1, λ1, B2, λ2; Sellmeier 2)",
         source, 1, 5, make_agf_4},
        {"agf_5", "n = n0 + A/λ + B/λ^3.5  (Conrady)", source, 1, 3, make_agf_5},
        {"agf_6", "n² = 1 + Σ K λ²/(λ² − L)  (K1, L1, … K4, L4; Sellmeier 3)", source, 1, 8,
         make_agf_sellmeier<4>},
        {"agf_7", "n² = A + B/(λ² − C) − D λ²  (Handbook of Optics 1)", source, 1, 4, make_agf_7},
        {"agf_8", "n² = A + B λ²/(λ² − C) − D λ²  (Handbook of Optics 2)", source, 1, 4,
         make_agf_8},
        {"agf_9", "n² = A + B λ²/(λ² − C) + D λ²/(λ² − E)  (Sellmeier 4)", source, 1, 5,
         make_agf_9},
        {"agf_10", "n² = a0 + a1 λ² + a2/λ² + … + a7/λ¹²  (Extended)", source, 1, 8, make_agf_10},
        {"agf_11", "n² = 1 + Σ K λ²/(λ² − L)  (K1, L1, … K5, L5; Sellmeier 5)", source, 1, 10,
         make_agf_sellmeier<5>},
        {"agf_12", "n² = a0 + a1 λ² + a2/λ² + … + a5/λ⁸ + a6 λ⁴ + a7 λ⁶  (Extended 2)", source, 1,
         8, make_agf_12},
        {"agf_13", "n² = a0 + a1 λ² + a2 λ⁴ + a3/λ² + … + a8/λ¹²  (Extended 3)", source, 1, 9,
         make_agf_13},
    };
}

std::vector<DispersionForm> rii_forms() {
    const char* const source = "refractiveindex.info, Dispersion formulas (2014)";
    return {
        {"rii_1", "n² = 1 + C1 + C2 λ²/(λ² − C3²) + …  (Sellmeier)", source, 1, kRiiSellmeier,
         make_rii_1},
        {"rii_2", "n² = 1 + C1 + C2 λ²/(λ² − C3) + …  (Sellmeier-2)", source, 1, kRiiSellmeier,
         make_rii_2},
        {"rii_3", "n² = C1 + C2 λ^C3 + C4 λ^C5 + …  (Polynomial)", source, 1, kRiiPowers,
         make_rii_3},
        {"rii_4", "n² = C1 + C2 λ^C3/(λ² − C4^C5) + C6 λ^C7/(λ² − C8^C9) + C10 λ^C11 + …", source,
         1, kRiiPowers, make_rii_4},
        {"rii_5", "n = C1 + C2 λ^C3 + C4 λ^C5 + …  (Cauchy)", source, 1, kRiiCauchy, make_rii_5},
        {"rii_6", "n = 1 + C1 + C2/(C3 − 1/λ²) + …  (Gases)", source, 1, kRiiGas, make_rii_6},
        {"rii_7", "n = C1 + C2 L + C3 L² + C4 λ² + C5 λ⁴ + C6 λ⁶, L = 1/(λ² − 0.028)  (Herzberger)",
         source, 1, 6, make_herzberger},
        {"rii_8", "(n² − 1)/(n² + 2) = C1 + C2 λ²/(λ² − C3) + C4 λ²  (Retro)", source, 1, 4,
         make_rii_8},
        {"rii_9", "n² = C1 + C2/(λ² − C3) + C4 (λ − C5)/((λ − C5)² + C6)  (Exotic)", source, 1, 6,
         make_rii_9},
    };
}

}  // namespace

const std::vector<DispersionForm>& dispersion_forms() {
    static const std::vector<DispersionForm> forms = [] {
        std::vector<DispersionForm> all = named_forms();
        for (const auto& more : {agf_forms(), rii_forms()})
            all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return forms;
}

}  // namespace dewbow
