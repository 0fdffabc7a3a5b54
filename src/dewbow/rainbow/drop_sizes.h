// SPDX-License-Identifier: Apache-2.0
#pragma once

// How many drops there are of each size.

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "dewbow/base/quantity.h"

namespace dewbow {

/// A distribution of drop radii, by number. Objects are immutable.
class DropSizes {
public:
    virtual ~DropSizes() = default;
    /// Number of drops per metre of radius, over the number of all: integrates to 1.
    virtual double density(Length radius) const = 0;
    /// Mean over all drops of (radius / metre)^power, power 0 to 6.
    virtual double mean_power(double power) const = 0;
    /// Radii outside which less than 1e-6 of the cross section lies.
    virtual Length smallest() const = 0;
    virtual Length largest() const = 0;
    /// One size, and no other.
    virtual bool is_single() const { return false; }
    /// Drops in a cubic metre, where the law of the sizes says; else nothing.
    virtual std::optional<double> number_per_m3() const { return std::nullopt; }
    /// As parse_drop_sizes reads it.
    virtual std::string describe() const = 0;
};
using DropSizesPtr = std::shared_ptr<const DropSizes>;

/// A class of drops: `share` of the number of all drops has about this radius.
struct WeightedRadius {
    Length radius;
    double share = 0.0;
};

Length mean_radius(const DropSizes& sizes);
/// ⟨r³⟩ / ⟨r²⟩, the mean radius weighted by cross section.           [Hansen & Travis 1974,
/// eq. 2.53]
Length effective_radius(const DropSizes& sizes);
/// π⟨r²⟩, of a drop on average.
Area mean_cross_section(const DropSizes& sizes);
/// Standard deviation of the radii over their mean, by number.
double relative_width(const DropSizes& sizes);

/// Radii that can be asked for: from what is smaller than any wavelength to what no raindrop is.
inline constexpr Length kLeastDropRadius = 1e-9 * unit::m, kMostDropRadius = 1e-2 * unit::m;
/// Radius of the largest raindrops: collisions and the air's drag break up nearly all that are
/// larger than 5 mm across (8.8 mm were seen once).          [Hobbs & Rangno, Geophys. Res. Lett.
/// 31 (2004)]
inline constexpr Length kLargestRaindrop = 2.5 * unit::mm;

// All of the following throw InputError: a radius outside the range above, a width that is not
// positive or too large. Widths are standard deviations over the mean, by number.

DropSizesPtr single_drop_size(Length radius);
/// Width up to 0.2, where a normal distribution has no drops of negative radius (3e-7 of them).
DropSizesPtr normal_drop_sizes(Length mean, double width);
/// Width up to 2.
DropSizesPtr lognormal_drop_sizes(Length mean, double width);
/// n ∝ r^{1/w² − 1} e^{−r / (w² mean)}; width up to 1, which is an exponential.
DropSizesPtr gamma_drop_sizes(Length mean, double width);
/// n ∝ r^{(1 − 3v)/v} e^{−r / (v r_eff)}: effective radius and effective variance, 0 to 1/3.
///                                                            [Hansen & Travis 1974, eq. 2.56]
DropSizesPtr effective_gamma_drop_sizes(Length effective_radius, double effective_variance);
/// n ∝ r^α e^{−b r^γ} with b = α / (γ r_c^γ), which is largest at r_c; α 0.1 to 20, γ 0.1 to 5.
///                                                                        [Deirmendjian 1969, p.
///                                                                        78]
DropSizesPtr deirmendjian_drop_sizes(double alpha, double gamma, Length mode);
/// Raindrops of diameter D: 8000 m⁻³ mm⁻¹ e^{−ΛD} up to D = 5 mm, Λ = 4.1 R^{−0.21} / mm with R in
/// mm/h.
///                                                  [Marshall & Palmer, J. Meteor. 5, 165 (1948)]
/// @param mm_per_hour  rain rate, 0.01 to 300.
DropSizesPtr marshall_palmer_drop_sizes(double mm_per_hour);
/// Raindrops of diameter D: n ∝ D^μ e^{−ΛD} up to D = 5 mm. With N0 = 6e4 e^{3.2 μ} m⁻³ cm^{−1−μ}
/// and drops that fall at 17.67 (D/cm)^{0.67} m/s, the rain rate is R = 33.31 N0 Γ(4.67+μ) /
/// Λ^{4.67+μ} mm/h (Λ per cm), which gives Λ.           [Ulbrich, J. Climate Appl. Meteor. 22, 1764
/// (1983)] Published values of N0 at μ = 0 go from 6e4 to 8e4, which makes 6 % in Λ.
/// @param mm_per_hour  rain rate, 0.01 to 300.   @param shape  μ, 0 to 6.
DropSizesPtr ulbrich_drop_sizes(double mm_per_hour, double shape);

/// Sizes as people write them; radii with their unit (nm, um, µm, mm, cm, m), widths as 10% or 0.1:
///
///     0.5mm                                         one size
///     normal:mean=0.5mm,width=10%                   also lognormal, gamma
///     gamma:effective-radius=10um,effective-variance=0.1
///     deirmendjian:cloud-c1                         also haze-m, haze-l
///     deirmendjian:alpha=6,gamma=1,mode=4um
///     fog:strong-advection                          also moderate-advection, strong-spray,
///                                                   moderate-spray  [Rasshofer et al. 2011]
///     rain:marshall-palmer,rate=5mm/h
///     rain:ulbrich,rate=5mm/h,shape=2
///
/// Throws InputError: what is wrong, and the nearest right word.
DropSizesPtr parse_drop_sizes(std::string_view text);

}  // namespace dewbow
