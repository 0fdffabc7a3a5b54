// SPDX-License-Identifier: Apache-2.0
#pragma once

// What all rays of a render by distributed_1989 share.

#include "dewbow/render/distributed_1989/scene_of_1989.h"
#include "dewbow/render/prepared_scene.h"

namespace dewbow::distributed_1989 {

/// The index of a ray without wavelength: at sodium's D line, as in eq. 2.
inline constexpr double kNominal_nm = 589.3;

/// Immutable.
class Method {
public:
    /// Throws InputError where the method cannot do what the scene asks for.
    explicit Method(const Scene& scene);

    const PreparedScene& prepared() const { return prepared_; }
    const Distributed1989Settings& settings() const { return told_.render.distributed_1989; }
    const PreparedSpectralSampling& sampling() const { return sampling_; }
    bool carries_rgb() const { return settings().transport == RgbOrSpectral::rgb; }

    /// Of a ray without wavelength: of the film's white their colours sum to (1, 1, 1).
    Bands make_white_bands() const;
    /// Of a sample: wavelength and colours are set for each.
    Bands make_sample_bands() const;
    void set_sample(const SpectralSample& sample, Bands& sample_bands) const;

    double index_nm(const SpectralSample& sample) const { return nm(sample.f_index); }
    double colour_nm(const SpectralSample& sample) const { return nm(sample.f_colour); }
    /// What a sample keeps of `beta`, which is that of a ray without wavelength.
    BandValues for_sample(const BandValues& beta, const SpectralSample& sample) const;
    /// The colour that the film's white has after `beta`.
    MonitorRgb white_through(const BandValues& beta) const;
    /// Whether colours part at a boundary so far that a ray is split there.
    bool disperses(const Boundary& boundary) const;
    /// In the film's unit.
    Colour<Xyz> xyz(MonitorRgb rgb) const { return sampling_.model().xyz(rgb) * white_radiance_; }

private:
    double nm(double f) const { return sampling_.model().wavelength(f).to(unit::nm); }
    void make_channels();
    void make_spectral_bands();

    PreparedSpectralSampling sampling_;
    Scene told_;
    PreparedScene prepared_;
    double white_radiance_;  ///< Y of the film's white; that of the constant spectrum 1 is 1
    SpectrumPtr white_;      ///< the film's white: D65
    RgbBasis light_basis_, reflectance_basis_;
    // Of a ray without wavelength, for each band.
    std::vector<double> band_nm_;
    std::vector<MonitorRgb> band_colour_;  ///< of the radiance 1
    std::vector<MonitorRgb> band_white_;   ///< of the film's white
    /// One a medium: at both ends of the visible range and in the middle.
    std::vector<std::array<double, 3>> index_;
};

}  // namespace dewbow::distributed_1989
