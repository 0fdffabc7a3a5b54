// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "dewbow/math/quadrature.h"
#include "dewbow/rainbow/embedded_data.h"
#include "dewbow/rainbow/self_test/comparison.h"
#include "dewbow/spectrum/csv_table.h"

namespace dewbow::self_test {
namespace {

using Complex = std::complex<double>;

/// The partial waves that MIEV0 sums; those beyond would change some of its answers in the sixth
/// digit, where an amplitude is small against its terms.      [Wiscombe 1980, Appl. Opt. 19, 1505]
std::size_t wiscombe_term_count(double x) {
    if (x <= 8.0) return std::size_t(x + 4.0 * std::cbrt(x) + 1.0);
    return std::size_t(x + (x < 4200.0 ? 4.05 : 4.0) * std::cbrt(x) + 2.0);
}

PartialWaves miev0_waves(ComplexIndex index, bool conductor, double x) {
    PartialWaves waves = conductor ? conductor_waves(x) : mie_waves(index, x);
    waves.a.resize(wiscombe_term_count(x));
    waves.b.resize(wiscombe_term_count(x));
    return waves;
}

/// ∫ ½ (|S_1|² + |S_2|²) dΩ / (π x²) by Gauss's rule, exact for N partial waves with N + 1 nodes.
double scattering_by_angle(const PartialWaves& waves, double x) {
    const QuadratureRule rule = gauss_legendre(int(waves.a.size()) + 1);
    return integrate(rule, -1.0, 1.0,
                     [&](double cosine) {
                         const Amplitudes s = amplitudes_at(waves, std::acos(cosine) * unit::rad);
                         return std::norm(s.perpendicular) + std::norm(s.parallel);
                     }) /
           (x * x);
}

}  // namespace

void check_miev0(Rows& rows) {
    enum { kX = 1, kN, kK, kConductor, kExt, kSca, kGSca };
    enum { kCaseOfRow, kAngle, kS1, kS2 = 4 };
    Comparison report(rows, "Wiscombe's MIEV0, its 19 test cases (1996)");
    const auto cases = columns_of_csv(rainbow::data::miev0_cases_csv());
    const auto values = columns_of_csv(rainbow::data::miev0_amplitudes_csv());
    for (std::size_t i = 0; i < cases[0].size(); ++i) {
        const double x = cases[kX][i], number = cases[0][i];
        const ComplexIndex index{cases[kN][i], std::abs(cases[kK][i])};
        const bool conductor = cases[kConductor][i] == 1.0;
        const PartialWaves waves = miev0_waves(index, conductor, x);
        // Seven digits are printed; MIEV0 took its series for small particles in three cases.
        const double allowed =
            number == 1.0 ? 1e-2 : (number == 5.0 || number == 12.0 ? 1e-5 : 1e-6);
        const std::string name =
            conductor ? fmt::format("{:2} x = {}, conductor: ", number, x)
                      : fmt::format("{:2} x = {}, m = {} + {}i: ", number, x, index.n, index.k);
        const Efficiencies q = efficiencies_of(waves, x);
        report.compare(name + "Q_ext", q.extinction, cases[kExt][i], allowed);
        report.compare(name + "Q_sca", q.scattering, cases[kSca][i], allowed);
        report.compare(name + "g Q_sca", q.asymmetry * q.scattering, cases[kGSca][i], allowed);
        report.worst_of([&](Comparison& all) {
            for (std::size_t j = 0; j < values[0].size(); ++j) {
                if (values[kCaseOfRow][j] != number) continue;
                const Amplitudes s = amplitudes_at(waves, values[kAngle][j] * unit::deg);
                const auto expected = [&](int column) {  // MIEV0's are the conjugates
                    return Complex{values[column][j], -values[column + 1][j]};
                };
                const std::string at = fmt::format(" at {}° (worst of 14)", values[kAngle][j]);
                all.compare(name + "S1" + at, s.perpendicular, expected(kS1), allowed);
                all.compare(name + "S2" + at, s.parallel, expected(kS2), allowed);
            }
        });
    }
}

void check_bohren_huffman(Rows& rows) {
    Comparison report(rows, "Bohren & Huffman (1983), table 4.1 and the sample of BHMIE");
    constexpr double kFiveDigits = 2e-5, kSixDigits = 2e-6;
    const auto table = columns_of_csv(rainbow::data::bohren_huffman_table_4_1_csv());
    const PartialWaves waves = mie_waves({1.33, 1e-8}, 3.0);
    for (std::size_t i = 0; i < table[0].size(); ++i) {
        report.compare(fmt::format("x = 3, m = 1.33 + 1e-8i: |a_{}|", i + 1), waves.a[i],
                       Complex{table[1][i], table[2][i]}, kFiveDigits);
        report.compare(fmt::format("x = 3, m = 1.33 + 1e-8i: |b_{}|", i + 1), waves.b[i],
                       Complex{table[3][i], table[4][i]}, kFiveDigits);
    }
    const double x = 2.0 * std::numbers::pi * 0.525 / 0.6328;  // radius and wavelength in µm
    const PartialWaves sample = mie_waves({1.55, 0.0}, x);
    const Efficiencies q = efficiencies_of(sample, x);
    report.compare("x = 5.213, m = 1.55: Q_ext", q.extinction, 3.10543, kSixDigits);
    report.compare("x = 5.213, m = 1.55: Q_sca", q.scattering, 3.10543, kSixDigits);
    report.compare("x = 5.213, m = 1.55: Q_back", backscatter_efficiency(sample, x), 2.92534,
                   kSixDigits);
}

void check_50_digits(Rows& rows) {
    Comparison report(rows, "Arithmetic with 50 digits (mpmath), water of m = 1.333");
    constexpr double kAllowed = 1e-9;
    const auto table =
        rows_of_csv(rainbow::data::mie_water_50_digits_csv(), "x,quantity,angle_deg,re,im");
    for (std::size_t begin = 0, end = 0; begin < table.size(); begin = end) {
        const double x = std::stod(table[begin][0]);
        while (end < table.size() && table[end][0] == table[begin][0]) ++end;
        const PartialWaves waves = mie_waves({kWater, 0.0}, x);
        const Efficiencies q = efficiencies_of(waves, x);
        const std::string name = fmt::format("x = {}: ", x);
        report.compare(name + "Q_ext", q.extinction, std::stod(table[begin][3]), kAllowed);
        report.compare(name + "g", q.asymmetry, std::stod(table[begin + 2][3]), kAllowed);
        report.worst_of([&](Comparison& all) {
            for (std::size_t i = begin + 3; i < end; ++i) {
                const auto& row = table[i];
                const Amplitudes s = amplitudes_at(waves, std::stod(row[2]) * unit::deg);
                all.compare(
                    fmt::format("{}{} at {}° (worst of {})", name, row[1], row[2], end - begin - 3),
                    row[1] == "S1" ? s.perpendicular : s.parallel,
                    Complex{std::stod(row[3]), std::stod(row[4])}, kAllowed);
            }
        });
    }
}

void check_conservation(Rows& rows) {
    Comparison report(rows, "Conservation of energy");
    constexpr double kAllowed = 1e-9;
    for (const ComplexIndex index : {ComplexIndex{kWater, 0.0}, {1.5, 1.0}}) {
        for (const double x : {1.0, 30.0, 300.0}) {
            const PartialWaves waves = mie_waves(index, x);
            const Efficiencies q = efficiencies_of(waves, x);
            const std::string name = fmt::format("x = {}, m = {} + {}i: ", x, index.n, index.k);
            report.compare(name + "Q_sca by the sphere of directions",
                           scattering_by_angle(waves, x), q.scattering, kAllowed);
            report.compare(
                name + "Q_ext by the optical theorem",
                4.0 / (x * x) * amplitudes_at(waves, 0.0 * unit::deg).perpendicular.real(),
                q.extinction, kAllowed);
        }
    }
    for (const double x : {1.0, 1000.0, 50000.0}) {
        const Efficiencies q = efficiencies_of(mie_waves({kWater, 0.0}, x), x);
        report.compare(
            fmt::format("x = {}, m = {}: Q_ext of a drop that does not absorb", x, kWater),
            q.extinction, q.scattering, kAllowed);
    }
}

}  // namespace dewbow::self_test
