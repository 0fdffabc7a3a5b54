// SPDX-License-Identifier: Apache-2.0
#include "dewbow/spectrum/spectral_model.h"

#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/empirical_model.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/linear_model.h"
#include "dewbow/spectrum/monitors.h"
#include "dewbow/spectrum/primaries_matrix.h"

namespace dewbow {
namespace {

bool outside(double f) { return !(f >= 0.0 && f <= 1.0); }

class LinearModel final : public SpectralModel {
public:
    explicit LinearModel(const SpectralModelSettings& settings)
        : SpectralModel(kPaperRed, kPaperViolet, settings) {}

    MonitorRgb density(double f) const override {
        // 13 samples of mean kPaperWhite / 13 sum to kPaperWhite.
        return {(linear_spectrum_colour(f) * (kPaperSamples / kPaperWhite)).v};
    }
};

class EmpiricalModel final : public SpectralModel {
public:
    explicit EmpiricalModel(const SpectralModelSettings& settings)
        : SpectralModel(kEmpiricalRed, kEmpiricalViolet, settings),
          curves_(empirical_curves(find_monitor(settings.monitor).primaries, settings.negative)) {}

    MonitorRgb density(double f) const override {
        if (outside(f)) return {};
        return curves_.at(wavelength(f)) * nm_per_f(f);
    }

private:
    EmpiricalCurves curves_;
};

class CieModel final : public SpectralModel {
public:
    explicit CieModel(const SpectralModelSettings& settings)
        : SpectralModel(kLambdaMax_nm * unit::nm, kLambdaMin_nm * unit::nm, settings),
          white_(find_illuminant("D65")),
          white_y_(xyz_from_spectrum(*white_)[1]) {}

    MonitorRgb density(double f) const override {
        if (outside(f)) return {};
        const Wavelength lambda = wavelength(f);
        const double white_per_f = (*white_)(lambda)*nm_per_f(f) / white_y_;
        return rgb(Colour<Xyz>{cie_xyz_bar(lambda.to(unit::nm))} * white_per_f);
    }

private:
    SpectrumPtr white_;
    double white_y_;
};

/// XYZ of D65 as all of this program has it, by its table, with Y = 1.
Triple film_white() {
    const Colour<Xyz> xyz = xyz_from_spectrum(*find_illuminant("D65"));
    return (xyz * (1.0 / xyz[1])).v;
}

}  // namespace

const std::vector<std::string>& spectral_colours_names() {
    static const std::vector<std::string> kNames{"linear", "empirical", "cie"};
    return kNames;
}

const std::vector<std::string>& negative_colours_names() {
    static const std::vector<std::string> kNames{"keep", "clamp", "limit"};
    return kNames;
}

SpectralModel::SpectralModel(Wavelength red, Wavelength violet,
                             const SpectralModelSettings& settings)
    : coordinate_{red, violet, settings.spacing},
      xyz_from_monitor_(
          matrix_of_primaries(find_monitor(settings.monitor).primaries, film_white())),
      monitor_from_xyz_(inverse(xyz_from_monitor_)) {}

SpectralModelPtr make_spectral_model(const SpectralModelSettings& settings) {
    switch (settings.colours) {
        case SpectralColours::linear:
            return std::make_shared<LinearModel>(settings);
        case SpectralColours::empirical:
            return std::make_shared<EmpiricalModel>(settings);
        case SpectralColours::cie:
            return std::make_shared<CieModel>(settings);
    }
    return nullptr;
}

}  // namespace dewbow
