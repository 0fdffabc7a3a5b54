// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/scattering_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;

DispersionPtr constant(double n) {
    return make_dispersion({"constant", {n}, IndexReference::vacuum});
}

std::vector<Angle> even_angles(double step_deg) {
    std::vector<Angle> angles;
    const int count = int(std::lround(180.0 / step_deg));
    for (int k = 0; k <= count; ++k) angles.push_back(kPi * k / count * rad);
    return angles;
}

TableRequest fog(const std::string& model) {
    TableRequest request;
    request.model = model;
    request.sizes = parse_drop_sizes("gamma:mean=5um,width=20%");
    request.optics = {constant(1.333), vacuum(), 0.0};
    request.wavelengths = {500.0 * nm, 600.0 * nm};
    request.angles = even_angles(0.1);
    request.disc.radius = 0.0 * deg;
    return request;
}

/// ∫ (P_⊥ + P_∥)/2 dΩ by the trapezoidal rule in θ.
double integral(const ScatteringTable& table, std::size_t wavelength) {
    double sum = 0.0;
    for (std::size_t a = 1; a < table.angles.size(); ++a) {
        const auto part = [&](std::size_t k) {
            return table.at(k, wavelength).unpolarised() * sin(table.angles[k]);
        };
        sum += 0.5 * (part(a) + part(a - 1)) * (table.angles[a] - table.angles[a - 1]).to(rad);
    }
    return 2.0 * kPi * sum;
}

TEST(ScatteringTable, PhaseFunctionIntegratesTo4Pi) {
    /// Of the trapezoidal rule at x = 60, a fringe of whose diffraction is 30 steps wide.
    constexpr double kTrapezoid = 5e-4;
    const ScatteringTable table = make_scattering_table(fog("mie"));
    for (std::size_t w = 0; w < 2; ++w)
        EXPECT_NEAR(integral(table, w) / (4.0 * kPi), 1.0, kTrapezoid);
}

TEST(ScatteringTable, OneDropIsWhatTheModelSays) {
    TableRequest request = fog("mie");
    request.sizes = single_drop_size(5.0 * um);
    const ScatteringTable table = make_scattering_table(request);
    const auto mie = make_scattering_model("mie");
    const Drop drop{request.optics.size_parameter(5.0 * um, 600.0 * nm), {}};
    EXPECT_DOUBLE_EQ(drop.size_parameter, 2.0 * kPi * 5000.0 / 600.0);
    const Efficiencies q = mie->efficiencies(RelativeIndex{1.333}, drop);
    EXPECT_DOUBLE_EQ(table.efficiencies[1].scattering, q.scattering);
    EXPECT_DOUBLE_EQ(table.efficiencies[1].asymmetry, q.asymmetry);
    std::vector<Intensities> S(request.angles.size());
    mie->intensities(RelativeIndex{1.333}, {&drop, 1}, request.angles, S);
    const double x2 = drop.size_parameter * drop.size_parameter;
    for (std::size_t a = 0; a < S.size(); ++a)
        EXPECT_DOUBLE_EQ(table.at(a, 1).perpendicular,
                         4.0 / (x2 * q.scattering) * S[a].perpendicular);
}

TEST(ScatteringTable, ModelsThatAreNotExactStateNoErrorOfZero) {
    TableRequest request = fog("uniform_airy");
    request.angles = {130.0 * deg, 140.0 * deg};
    EXPECT_TRUE(std::isnan(make_scattering_table(request).stated_error));
    request.model = "mie";
    EXPECT_EQ(make_scattering_table(request).stated_error, 0.0);
}

TEST(ScatteringTable, RefusesWhatIsNoRequest) {
    const auto refused = [](auto change) {
        TableRequest request = fog("mie");
        change(request);
        EXPECT_THROW((void)make_scattering_table(request), InputError);
    };
    refused([](TableRequest& r) { r.sizes = nullptr; });
    refused([](TableRequest& r) { r.optics.drop = nullptr; });
    refused([](TableRequest& r) { r.wavelengths.clear(); });
    refused([](TableRequest& r) { r.wavelengths = {600.0 * nm, 500.0 * nm}; });
    refused([](TableRequest& r) { r.wavelengths = {std::nan("") * nm}; });
    refused([](TableRequest& r) { r.angles.clear(); });
    refused([](TableRequest& r) { r.angles = {10.0 * deg, 10.0 * deg}; });
    refused([](TableRequest& r) { r.angles = {181.0 * deg}; });
    refused([](TableRequest& r) { r.angles = {-1.0 * deg}; });
    refused([](TableRequest& r) { r.tolerance = 0.0; });
    refused([](TableRequest& r) { r.model = "none"; });
    // What a model cannot treat comes out of the parallel loop as what it is.
    refused([](TableRequest& r) { r.sizes = single_drop_size(9.9 * mm); });
}

}  // namespace
}  // namespace dewbow
