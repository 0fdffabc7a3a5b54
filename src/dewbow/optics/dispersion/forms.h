// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the rows of dispersion_forms() build with. The number of coefficients was checked; each
// throws InputError where they make no index.

#include "dewbow/optics/dispersion.h"

namespace dewbow::dispersion {

inline constexpr std::size_t kMostResonances = 8;   ///< of refractiveindex.info
inline constexpr std::size_t kMostPowers = 8;       ///< of refractiveindex.info
inline constexpr std::size_t kMostGasTerms = 5;     ///< of refractiveindex.info
inline constexpr std::size_t kMostCauchy = 6;       ///< 1 … λ⁻¹⁰
inline constexpr std::size_t kMostSchott = 8;       ///< of AGF formula 10
inline constexpr std::size_t kMostSeries = 9;       ///< of AGF formula 13
inline constexpr std::size_t kMostAgfNumbers = 10;  ///< on a line CD
inline constexpr std::size_t kMostTableNumbers = 2 * 100'000;

// sellmeier.cpp
DispersionPtr make_sellmeier(const DispersionData& data);
DispersionPtr make_handbook_1(const DispersionData& data);
template <int pairs>
DispersionPtr make_agf_sellmeier(const DispersionData& data);
DispersionPtr make_agf_4(const DispersionData& data);
DispersionPtr make_agf_7(const DispersionData& data);
DispersionPtr make_agf_8(const DispersionData& data);
DispersionPtr make_agf_9(const DispersionData& data);
DispersionPtr make_rii_1(const DispersionData& data);
DispersionPtr make_rii_2(const DispersionData& data);

// series.cpp
DispersionPtr make_cauchy(const DispersionData& data);
DispersionPtr make_schott(const DispersionData& data);
DispersionPtr make_extended_3(const DispersionData& data);
DispersionPtr make_agf_1(const DispersionData& data);
DispersionPtr make_agf_10(const DispersionData& data);
DispersionPtr make_agf_12(const DispersionData& data);
DispersionPtr make_agf_13(const DispersionData& data);

// near_visible.cpp
DispersionPtr make_herzberger(const DispersionData& data);
DispersionPtr make_conrady(const DispersionData& data);
DispersionPtr make_hartmann(const DispersionData& data);
DispersionPtr make_agf_3(const DispersionData& data);
DispersionPtr make_agf_5(const DispersionData& data);

// powers.cpp
DispersionPtr make_rii_3(const DispersionData& data);
DispersionPtr make_rii_4(const DispersionData& data);
DispersionPtr make_rii_5(const DispersionData& data);
DispersionPtr make_rii_8(const DispersionData& data);
DispersionPtr make_rii_9(const DispersionData& data);

// few_numbers.cpp
DispersionPtr make_constant(const DispersionData& data);
DispersionPtr make_abbe(const DispersionData& data);
DispersionPtr make_pov_ray(const DispersionData& data);

// gas.cpp, table.cpp, water.cpp
DispersionPtr make_gas(const DispersionData& data);
DispersionPtr make_rii_6(const DispersionData& data);
DispersionPtr make_table(const DispersionData& data);
DispersionPtr make_water(const DispersionData& data);
DispersionPtr make_sea_water(const DispersionData& data);

}  // namespace dewbow::dispersion
