// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/mixed_table.h"

#include <gtest/gtest.h>

#include "dewbow/optics/dispersion.h"

namespace dewbow {
namespace {

constexpr double kRounding = 1e-12;

TableRequest request_of(Length radius) {
    TableRequest request;
    request.model = "mie";
    request.sizes = single_drop_size(radius);
    request.optics = {make_dispersion({"constant", {1.333}, IndexReference::vacuum}), vacuum()};
    request.wavelengths = {500.0 * unit::nm, 600.0 * unit::nm};
    for (int i = 0; i <= 18; ++i) request.angles.push_back(10.0 * i * unit::deg);
    request.disc.radius = Angle{};
    return request;
}

/// What one drop scatters towards an angle, per sr: cross section × Q_sca × P / 4π.
double sent(const ScatteringTable& t, std::size_t angle, std::size_t wavelength) {
    return t.mean_cross_section.base_value() * t.efficiencies[wavelength].scattering *
           t.at(angle, wavelength).perpendicular;
}

/// Four drops of 2 µm and one of 4 µm have the same cross section: what they send together is what
/// five drops of the mixture send.
TEST(MixedTable, SendsWhatItsDropsSendTogether) {
    const ScatteringTable tables[] = {make_scattering_table(request_of(2.0 * unit::um)),
                                      make_scattering_table(request_of(4.0 * unit::um))};
    const ScatteringTable mixed = mixed_evenly(tables);
    for (std::size_t i = 0; i < mixed.angles.size(); ++i)
        for (std::size_t j = 0; j < 2; ++j) {
            const double together = 4.0 * sent(tables[0], i, j) + sent(tables[1], i, j);
            EXPECT_NEAR(5.0 * sent(mixed, i, j), together, kRounding * together);
        }
    const auto& q = mixed.efficiencies[1];
    EXPECT_NEAR(q.extinction,
                0.5 * (tables[0].efficiencies[1].extinction + tables[1].efficiencies[1].extinction),
                kRounding);
    EXPECT_GT(q.asymmetry,
              std::min(tables[0].efficiencies[1].asymmetry, tables[1].efficiencies[1].asymmetry));
}

TEST(MixedTable, OfOneIsThatOne) {
    const ScatteringTable table = make_scattering_table(request_of(2.0 * unit::um));
    const ScatteringTable mixed = mixed_evenly({&table, 1});
    for (std::size_t k = 0; k < table.phase.size(); ++k)
        EXPECT_NEAR(mixed.phase[k].parallel, table.phase[k].parallel,
                    kRounding * table.phase[k].parallel);
}

}  // namespace
}  // namespace dewbow
