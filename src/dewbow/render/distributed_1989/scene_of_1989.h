// SPDX-License-Identifier: Apache-2.0
#pragma once

// A scene as a program of 1989 was told it: indices that are straight lines, and colours of three
// numbers. So everything that renders it stays as it is.

#include "dewbow/render/distributed_1989/bands.h"
#include "dewbow/scene/scene.h"

namespace dewbow::distributed_1989 {

/// The wavelengths that stand for red, green and blue where a ray carries three numbers: near those
/// of the primaries' strongest colours. What stays a spectrum, absorption and the indices of
/// metals, is looked up there.
inline constexpr std::array<double, 3> kChannel_nm{610.0, 550.0, 465.0};

/// The spectrum that holds `rgb`, no channel negative, at kChannel_nm: constant up to 490 nm, to
/// 580 nm, and beyond.
SpectrumPtr make_channels(MonitorRgb rgb);

/// Channels of a radiance, as bright as it is; negative ones, which no monitor shows, are 0.
SpectrumPtr channels_of_light(const Spectrum& light, const SpectralModel& model);
/// Channels of a reflectance under D65, each within 0 to 1.
SpectrumPtr channels_of_reflectance(const Spectrum& reflectance, const SpectralModel& model);

/// What textures are mixtures of where rays carry channels.
RgbBasis light_basis_in_channels(const SpectralModel& model);
RgbBasis reflectance_basis_in_channels(const SpectralModel& model);

/// With the indices and colours that its settings of distributed_1989 ask for, and without haze
/// and aerial perspective:
/// the method has no light from points in space.
Scene scene_of_1989(const Scene& scene, const SpectralModel& model);

}  // namespace dewbow::distributed_1989
