// SPDX-License-Identifier: Apache-2.0
#pragma once

// A source with extent: what its disc does to a bow.
//
// A function of the scattering angle is spread over the sphere, so the exact filter is a
// convolution on the sphere: SunSmoother. Convolving along the angle alone (projection_kernel) is
// right where the function is straight across the disc: near 0° and 180° it is not.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Radius of the sun as seen at its mean distance, 959.63″.     [Auwers 1891; IAU]
inline constexpr Angle kSunRadius = 0.26656 * unit::deg;

/// A round source, brighter in the middle by the linear law I(μ) = 1 − u (1 − μ), with
/// μ² = 1 − sin²(ρ/2) / sin²(R/2) at the angle ρ from the centre. (For a sphere far away it is sin
/// ρ over sin R: 3e-6 apart for the sun.)
struct SunDisc {
    Angle radius = kSunRadius;    ///< R, 0 to 10°; 0: a point
    double limb_darkening = 0.0;  ///< u, 0 to 1; the sun about 0.6 in the visible
};

/// Share of the disc's light per steradian at an angle from its centre: integrates to 1 over the
/// sphere. A peak at 0° that is much narrower than the disc and holds a share w of all light comes
/// out as w times this; 0 for a point.
double disc_profile(const SunDisc& disc, Angle from_centre);

/// What the disc leaves of P_l(cos θ): B_l = (P_{l−1}(cos R) − P_{l+1}(cos R)) / ((2l+1)(1 − cos
/// R)) for u = 0; 1 for a point. Within 1e-8 of that closed form, which cancels, to l = 3000.
double legendre_factor(const SunDisc& disc, int l);

/// Shares of the disc's light in bins of the coordinate across it, the middle bin around its
/// centre: an odd number, symmetric, sum 1; {1} for a point. On a plane: exact for features that
/// are straight.
/// @param bin  width of a bin, above 0.
std::vector<double> projection_kernel(const SunDisc& disc, Angle bin);

/// The kernel as published: a semicircle of 0.25° at the middles of buckets of 0.1°.
///                                                                        [Musgrave 1989, 4.3.2]
std::array<double, 5> published_sun_kernel();

/// The spherical filter for functions given at certain angles, computed once and applied to many.
///
/// Functions are taken as linear between the angles, and as constant beyond the first and the last
/// (if these are not 0° and 180°). The integral over the disc runs along circles of equal
/// scattering angle t around the direction of view: a circle lies within the disc over azimuths −α
/// to α with sin²(α/2) = (sin²(R/2) − sin²((t−θ)/2)) / (sin t sin θ); intensities are weighted by ∫
/// dα, and Q = (I_⊥ − I_∥)/2 by ∫ cos 2α dα, since α also is the angle by which the scattering
/// plane turns. So 0° and 180° need no exception, and Q is filtered as a quantity of spin 2.
///
/// Error: the weights 1e-7; interpolation h² f″/12. A constant stays what it is to 1e-14. The
/// integral over the sphere stays what it is to 1e-8 for even angles, and to what the trapezoidal
/// rule makes of them where their spacing changes.
class SunSmoother {
public:
    /// @param angles  0 to 180°, ascending, at least one.
    /// Throws InputError: a radius or a limb darkening outside their range, angles not in order.
    SunSmoother(std::span<const Angle> angles, const SunDisc& disc);
    /// Results at some of the angles only, those numbered `wanted`.
    SunSmoother(std::span<const Angle> angles, const SunDisc& disc,
                std::span<const std::size_t> wanted);

    /// [angle][column], row-major, any number of columns (wavelengths); `out` as large as `in`, or
    /// with as many rows as there are angles wanted, and another.
    void apply(std::span<const Intensities> in, std::span<Intensities> out) const;
    /// The same for quantities that do not depend on a plane.
    void apply(std::span<const double> in, std::span<double> out) const;

private:
    struct Row {
        std::size_t first_angle = 0, first_weight = 0, count = 0;
    };
    /// Of a neighbour's I and Q.
    struct Weight {
        double i = 0.0, q = 0.0;
    };
    void add_row(std::span<const double> grid, double theta, const SunDisc& disc);

    std::size_t angles_;
    std::vector<Row> rows_;
    std::vector<Weight> weights_;
};

}  // namespace dewbow
