// SPDX-License-Identifier: Apache-2.0
#pragma once

// Physical quantities as types: a number goes in or out of a public door of the physics half only
// together with its unit. `3.0 * m` makes a Length, `lambda.to(nm)` reads one back.
//
// A quantity is one double, in SI base units (wavelengths: nanometres, because vacuum wavelength is
// a dimension of its own here: a spectral density per nanometre must not cancel against a length).

#include <cmath>
#include <compare>
#include <numbers>
#include <type_traits>

namespace dewbow {

/// Exponents of the dimensions: length, mass, time, temperature, plane angle, vacuum wavelength.
template <int L, int M, int T, int K, int A, int W>
struct Dimension {
    template <class Other>
    using Times = typename Other::template Plus<L, M, T, K, A, W>;
    template <int L2, int M2, int T2, int K2, int A2, int W2>
    using Plus = Dimension<L + L2, M + M2, T + T2, K + K2, A + A2, W + W2>;
    using Inverse = Dimension<-L, -M, -T, -K, -A, -W>;
};
using Dimensionless = Dimension<0, 0, 0, 0, 0, 0>;

/// A physical quantity of dimension `D`.
template <class D>
class Quantity {
public:
    constexpr Quantity() = default;

    /// The quantity whose value in SI base units (nm for wavelengths) is `value`.
    static constexpr Quantity from_base(double value) { return Quantity(value); }
    /// Value in SI base units (nm for wavelengths).
    constexpr double base_value() const { return value_; }
    /// Value in `unit`, for instance `angle.to(deg)`.
    constexpr double to(Quantity unit) const { return value_ / unit.value_; }

    constexpr Quantity operator-() const { return Quantity(-value_); }
    constexpr Quantity& operator+=(Quantity b) { return value_ += b.value_, *this; }
    constexpr Quantity& operator-=(Quantity b) { return value_ -= b.value_, *this; }
    constexpr Quantity& operator*=(double s) { return value_ *= s, *this; }
    constexpr Quantity& operator/=(double s) { return value_ /= s, *this; }

    friend constexpr Quantity operator+(Quantity a, Quantity b) { return a += b; }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return a -= b; }
    friend constexpr Quantity operator*(Quantity a, double s) { return a *= s; }
    friend constexpr Quantity operator*(double s, Quantity a) { return a *= s; }
    friend constexpr Quantity operator/(Quantity a, double s) { return a /= s; }
    friend constexpr Quantity operator/(double s,
                                        Quantity a) requires(std::is_same_v<D, Dimensionless>) {
        return Quantity(s / a.value_);
    }
    constexpr auto operator<=>(const Quantity&) const = default;

private:
    explicit constexpr Quantity(double value) : value_(value) {}
    double value_ = 0.0;
};

/// A product without dimension is a plain number again.
template <class D>
struct QuantityResult {
    static constexpr Quantity<D> make(double v) { return Quantity<D>::from_base(v); }
};
template <>
struct QuantityResult<Dimensionless> {
    static constexpr double make(double v) { return v; }
};

template <class D1, class D2>
constexpr auto operator*(Quantity<D1> a, Quantity<D2> b) {
    return QuantityResult<typename D1::template Times<D2>>::make(a.base_value() * b.base_value());
}
template <class D1, class D2>
constexpr auto operator/(Quantity<D1> a, Quantity<D2> b) {
    return QuantityResult<typename D1::template Times<typename D2::Inverse>>::make(a.base_value() /
                                                                                   b.base_value());
}
template <class D>
requires(!std::is_same_v<D, Dimensionless>) constexpr auto operator/(double s, Quantity<D> a) {
    return Quantity<typename D::Inverse>::from_base(s / a.base_value());
}
template <class D>
constexpr Quantity<D> abs(Quantity<D> a) {
    return a.base_value() < 0.0 ? -a : a;
}

//                                      L  M  T  K  A  W
using Length = Quantity<Dimension<1, 0, 0, 0, 0, 0>>;
using Area = Quantity<Dimension<2, 0, 0, 0, 0, 0>>;
using InverseLength = Quantity<Dimension<-1, 0, 0, 0, 0, 0>>;
using Duration = Quantity<Dimension<0, 0, 1, 0, 0, 0>>;
using Temperature = Quantity<Dimension<0, 0, 0, 1, 0, 0>>;
using Angle = Quantity<Dimension<0, 0, 0, 0, 1, 0>>;
using SolidAngle = Quantity<Dimension<0, 0, 0, 0, 2, 0>>;
/// Vacuum wavelength, held in nanometres.
using Wavelength = Quantity<Dimension<0, 0, 0, 0, 0, 1>>;
using Power = Quantity<Dimension<2, 1, -3, 0, 0, 0>>;
using Irradiance = Quantity<Dimension<0, 1, -3, 0, 0, 0>>;
using Radiance = Quantity<Dimension<0, 1, -3, 0, -2, 0>>;
/// W m⁻² nm⁻¹
using SpectralIrradiance = Quantity<Dimension<0, 1, -3, 0, 0, -1>>;
/// W m⁻² sr⁻¹ nm⁻¹
using SpectralRadiance = Quantity<Dimension<0, 1, -3, 0, -2, -1>>;

namespace unit {

inline constexpr Length m = Length::from_base(1.0);
inline constexpr Length cm = 1e-2 * m;
inline constexpr Length mm = 1e-3 * m;
inline constexpr Length um = 1e-6 * m;
inline constexpr Duration s = Duration::from_base(1.0);
inline constexpr Temperature K = Temperature::from_base(1.0);
inline constexpr Angle rad = Angle::from_base(1.0);
inline constexpr Angle deg = (std::numbers::pi / 180.0) * rad;
inline constexpr SolidAngle sr = rad * rad;
inline constexpr Wavelength nm = Wavelength::from_base(1.0);
inline constexpr Power W = Power::from_base(1.0);
inline constexpr SpectralRadiance W_per_m2_sr_nm = W / (m * m * sr * nm);

}  // namespace unit

inline double sin(Angle a) { return std::sin(a.to(unit::rad)); }
inline double cos(Angle a) { return std::cos(a.to(unit::rad)); }
inline double tan(Angle a) { return std::tan(a.to(unit::rad)); }

}  // namespace dewbow
