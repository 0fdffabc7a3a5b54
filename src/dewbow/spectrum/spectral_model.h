// SPDX-License-Identifier: Apache-2.0
#pragma once

// How white light is taken apart into coloured samples: the paper's two models of the spectrum
// [Musgrave 1989, 4.2] and that of the CIE, behind one interface.

#include <memory>
#include <string>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/spectrum/colour.h"
#include "dewbow/spectrum/matrix3.h"
#include "dewbow/spectrum/spectral_coordinate.h"

namespace dewbow {

/// The numbers that are sent to a monitor, linear; (1, 1, 1) is white. Which colours they are, the
/// model says.
using MonitorRgb = Colour<Monitor>;

enum class SpectralColours {
    linear,     ///< piecewise linear by eye (Fig. 4.1): no colour science
    empirical,  ///< x̄ȳz̄ under illuminant B in steps of 10 nm, on a monitor (Fig. 4.2)
    cie,        ///< x̄ȳz̄ under D65, 1 nm, never clamped: what all else in this program computes
};
/// What the empirical model does about negative channels. The other two take no notice: linear has
/// none, and cie keeps them.
enum class NegativeColours {
    keep,   ///< as they come
    clamp,  ///< to zero, as the paper does
    limit,  ///< towards white at constant Y until the least channel is 0, as the paper wishes
};
/// The words for these, each in the order of its enumerators.
const std::vector<std::string>& spectral_colours_names();
const std::vector<std::string>& negative_colours_names();

struct SpectralModelSettings {
    SpectralColours colours = SpectralColours::linear;
    SpectralSpacing spacing = SpectralSpacing::frequency;
    NegativeColours negative = NegativeColours::clamp;
    std::string monitor = "rogers";  ///< a row of monitors()
};

/// The paper's spectral coordinate f runs from 0, red, to 1, violet, linearly in frequency or in
/// wavelength over the model's range: 800–380 nm (linear), 770–380 nm (empirical), 830–360 nm
/// (cie).
class SpectralModel {
public:
    virtual ~SpectralModel() = default;

    /// Of white light, per unit of f; 0 outside [0, 1]. Each channel integrates to 1 over [0, 1].
    /// [Musgrave 1989, eqs. 10–12: R, G, B(λ)]
    virtual MonitorRgb density(double f) const = 0;

    Wavelength wavelength(double f) const { return coordinate_.wavelength(f); }
    /// f at `lambda`; below 0 or above 1 outside the range.
    double coordinate(Wavelength lambda) const { return coordinate_.at(lambda); }
    /// |dλ/df| in nm: density(f) / nm_per_f(f) is the density per nm.
    double nm_per_f(double f) const { return coordinate_.nm_per_f(f); }

    /// What `rgb` is to the film: (1, 1, 1) is its white, the XYZ of illuminant D65 with Y = 1. The
    /// primaries are the monitor's, its own white is not used.
    Colour<Xyz> xyz(MonitorRgb rgb) const { return {xyz_from_monitor_ * rgb.v}; }
    MonitorRgb rgb(Colour<Xyz> xyz) const { return {monitor_from_xyz_ * xyz.v}; }

protected:
    SpectralModel(Wavelength red, Wavelength violet, const SpectralModelSettings& settings);

private:
    SpectralCoordinate coordinate_;
    Matrix3 xyz_from_monitor_, monitor_from_xyz_;
};
using SpectralModelPtr = std::shared_ptr<const SpectralModel>;

/// Throws InputError for an unknown monitor.
SpectralModelPtr make_spectral_model(const SpectralModelSettings& settings);

}  // namespace dewbow
