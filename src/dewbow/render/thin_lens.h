// SPDX-License-Identifier: Apache-2.0
#pragma once

// A thin lens before a film: where rays start, and where they are in focus.

#include "dewbow/math/sampling.h"
#include "dewbow/scene/camera.h"

namespace dewbow {

/// A regular polygon in the unit circle with a corner at +y.   @param corners  at least 3.
/// Equal areas of the square stay equal.
DiscPoint sample_polygon(int corners, double u0, double u1);

/// The lens lies in z = 0 of the camera's frame, and is its own stop. The ray through its centre
/// goes straight on at every wavelength; let d be its direction with d_z = −1. Rays from one point
/// of the film meet again at d s, where s depends on wavelength:
///
///   1 / f(λ) = 1 / s(λ) + 1 / b                                        [Gauss 1841]
///   f(λ) = f_d (n_d − 1) / (n(λ) − 1), for a lens of one glass         [the lens maker's formula]
///
/// with the film at the distance b where the d line is in focus. Without b,
///
///   1 / s(λ) = 1 / s_d + (n(λ) − n_d) / (f_d (n_d − 1)).
///
/// This is vergence(λ). It may be 0 or negative: then the rays do not meet, and the formula still
/// holds. The ray from the point p of the lens goes along d − p vergence(λ). All colour is
/// longitudinal: chief rays do not depend on λ, so that pictures of the edge keep their place.
class ThinLensOptics {
public:
    explicit ThinLensOptics(const ThinLens& lens);

    /// Whether wavelengths go different ways.
    bool disperses() const { return bool(glass_); }
    /// A point of the aperture in metres, evenly.
    DiscPoint sample(double u0, double u1) const;
    /// In m⁻¹ at the d line.
    double vergence() const { return vergence_; }
    /// In m⁻¹ for each wavelength.
    void vergences(std::span<const double> lambda_nm, std::span<double> vergence_per_m) const;

private:
    double aperture_radius_;  // m
    int blades_;
    double vergence_;      // 1 / s_d
    DispersionPtr glass_;  // nullptr: no dispersion
    double n_d_ = 1.0;     // in air
    double slope_ = 0.0;   // of vergence by index: 1 / (f_d (n_d − 1))
};

}  // namespace dewbow
