// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/illuminant.h"

#include <array>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/csv_table.h"
#include "dewbow/spectrum/embedded_data.h"

namespace dewbow {
namespace {

struct IlluminantRow {
    std::string_view name;
    std::string_view (*table)();
};
constexpr std::array kIlluminantTables{
    IlluminantRow{"D65", spectrum::data::cie_d65_1nm_csv},
    IlluminantRow{"A", spectrum::data::cie_a_1nm_csv},
    IlluminantRow{"B", spectrum::data::cie_b_5nm_csv},
    IlluminantRow{"C", spectrum::data::cie_c_5nm_csv},
};

/// Values of `lambda_nm` and `value`, scaled so that Y is that of the constant spectrum 1.
SpectrumPtr make_normalised(const std::vector<double>& lambda_nm, std::vector<double> value) {
    const double y = xyz_from_spectrum(*make_tabulated(lambda_nm, value, OutsideTable::hold))[1];
    for (double& v : value) v *= cie_y_integral() / y;
    return make_tabulated(lambda_nm, std::move(value), OutsideTable::hold);
}

struct NamedSpectrum {
    std::string_view name;
    SpectrumPtr spectrum;
};

std::vector<NamedSpectrum> load_illuminants() {
    std::vector<NamedSpectrum> loaded;
    for (const IlluminantRow& row : kIlluminantTables) {
        auto columns = columns_of_csv(row.table());
        loaded.push_back({row.name, make_normalised(columns.at(0), std::move(columns.at(1)))});
    }
    loaded.push_back({"E", make_constant(1.0)});
    return loaded;
}

const std::vector<NamedSpectrum>& illuminants() {
    static const std::vector<NamedSpectrum> kIlluminants = load_illuminants();
    return kIlluminants;
}

// CODATA 2018, exact by the definition of the SI.
constexpr double kPlanck_J_s = 6.62607015e-34;
constexpr double kBoltzmann_J_per_K = 1.380649e-23;
constexpr double kLightSpeed_m_per_s = 299792458.0;

constexpr double kMinTemperature_K = 500.0;
constexpr double kMaxTemperature_K = 1e6;
/// Between the values of a black body's table. Linear interpolation is then wrong by less than 8e-5
/// of the value at 500 K (at 555 nm; 3e-4 at 360 nm, where it is 1e-11 of the peak), by 4e-6 at
/// 2500 K.
constexpr double kBlackbodyStep_nm = 0.25;

}  // namespace

SpectrumPtr find_illuminant(std::string_view name) {
    for (const NamedSpectrum& illuminant : illuminants()) {
        if (illuminant.name == name) return illuminant.spectrum;
    }
    return nullptr;
}

std::vector<std::string> illuminant_names() {
    std::vector<std::string> names;
    for (const NamedSpectrum& illuminant : illuminants()) names.emplace_back(illuminant.name);
    return names;
}

SpectralRadiance planck_radiance(Temperature temperature, Wavelength lambda) {
    constexpr double kMetresPerNanometre = 1e-9;
    const double lambda_m = lambda.to(unit::nm) * kMetresPerNanometre;
    const double photon_energy = kPlanck_J_s * kLightSpeed_m_per_s / lambda_m;
    const double exponent = photon_energy / (kBoltzmann_J_per_K * temperature.to(unit::K));
    const double lambda_4 = lambda_m * lambda_m * lambda_m * lambda_m;
    const double per_metre =
        2.0 * photon_energy * kLightSpeed_m_per_s / (lambda_4 * std::expm1(exponent));
    return per_metre * kMetresPerNanometre * unit::W_per_m2_sr_nm;
}

SpectrumPtr make_blackbody(Temperature temperature) {
    const double temperature_K = temperature.to(unit::K);
    if (!(temperature_K >= kMinTemperature_K && temperature_K <= kMaxTemperature_K)) {
        throw InputError("the temperature of a black body must lie between 500 and 1e6 K");
    }
    std::vector<double> lambda_nm, value;
    const int intervals = int((kLambdaMax_nm - kLambdaMin_nm) / kBlackbodyStep_nm);
    for (int i = 0; i <= intervals; ++i) {
        lambda_nm.push_back(kLambdaMin_nm + double(i) * kBlackbodyStep_nm);
        const auto radiance = planck_radiance(temperature, lambda_nm.back() * unit::nm);
        value.push_back(radiance.to(unit::W_per_m2_sr_nm));
    }
    return make_normalised(lambda_nm, std::move(value));
}

}  // namespace dewbow
