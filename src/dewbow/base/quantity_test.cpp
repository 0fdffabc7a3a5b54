// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/quantity.h"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace dewbow {
namespace {

using namespace unit;

template <class A, class B>
concept Addable = requires(A a, B b) {
    a + b;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
    a < b;
};
template <class A, class B>
concept ConvertibleUnit = requires(A a, B b) {
    a.to(b);
};
template <class A>
concept HasSine = requires(A a) {
    sin(a);
};

// Products and quotients carry their dimension.
static_assert(std::is_same_v<decltype(m * m), Area>);
static_assert(std::is_same_v<decltype(1.0 / m), InverseLength>);
static_assert(std::is_same_v<decltype(rad * rad), SolidAngle>);
static_assert(std::is_same_v<decltype(W / (m * m)), Irradiance>);
static_assert(std::is_same_v<decltype(W / (m * m) / nm), SpectralIrradiance>);
static_assert(std::is_same_v<decltype(W / (m * m) / sr), Radiance>);
static_assert(std::is_same_v<decltype(W / (m * m * sr * nm)), SpectralRadiance>);
static_assert(std::is_same_v<decltype(SpectralRadiance() * sr * nm), Irradiance>);

// What cancels is a number; a wavelength does not cancel a length.
static_assert(std::is_same_v<decltype(m / m), double>);
static_assert(std::is_same_v<decltype(m * (1.0 / m)), double>);
static_assert(!std::is_same_v<decltype(nm / m), double>);
static_assert(!std::is_same_v<decltype(nm / um), double>);

// What must not compile.
static_assert(Addable<Length, Length>);
static_assert(!Addable<Length, Area>);
static_assert(!Addable<Length, Wavelength>);
static_assert(!Addable<Length, double>);
static_assert(!Addable<double, Angle>);
static_assert(!Comparable<Length, Wavelength>);
static_assert(!Comparable<Angle, double>);
static_assert(!ConvertibleUnit<Length, Wavelength>);
static_assert(!ConvertibleUnit<Angle, SolidAngle>);
static_assert(!std::is_convertible_v<double, Length>);
static_assert(!std::is_constructible_v<Length, double>);
static_assert(!std::is_convertible_v<Length, double>);
static_assert(!std::is_assignable_v<Length&, double>);
static_assert(!std::is_assignable_v<Length&, Wavelength>);
static_assert(HasSine<Angle> && !HasSine<Length> && !HasSine<SolidAngle>);

// A quantity costs what its number costs.
static_assert(sizeof(Length) == sizeof(double) && alignof(Length) == alignof(double));
static_assert(sizeof(SpectralRadiance) == sizeof(double));
static_assert(std::is_trivially_copyable_v<Length> && std::is_standard_layout_v<Length>);

// Constant expressions.
static_assert((3.0 * m + 20.0 * cm).base_value() == 3.2);
static_assert((550.0 * nm).to(nm) == 550.0);
static_assert((550.0 * nm).base_value() == 550.0, "wavelengths are held in nanometres");
static_assert(Length() == 0.0 * m);
static_assert(1.0 * mm < 1.0 * cm && -(1.0 * m) < Length());
static_assert(abs(-2.0 * m) == 2.0 * m && abs(2.0 * m) == 2.0 * m);

TEST(Quantity, ConvertsUnits) {
    EXPECT_DOUBLE_EQ((2.5 * m).to(mm), 2500.0);
    EXPECT_DOUBLE_EQ((1.0 * mm).to(um), 1000.0);
    EXPECT_DOUBLE_EQ((180.0 * deg).to(rad), std::numbers::pi);
    EXPECT_DOUBLE_EQ((1.0 * rad).to(deg), 57.295779513082323);
    EXPECT_DOUBLE_EQ((2.0 * m / (50.0 * cm)), 4.0);
}

TEST(Quantity, Accumulates) {
    Length sum;
    sum += 2.0 * m;
    sum -= 50.0 * cm;
    sum *= 4.0;
    sum /= 3.0;
    EXPECT_DOUBLE_EQ(sum.to(m), 2.0);
    EXPECT_DOUBLE_EQ((0.5 * sum + sum / 2.0 - sum * 0.25).to(m), 1.5);
}

TEST(Quantity, TrigonometryTakesAngles) {
    EXPECT_DOUBLE_EQ(sin(30.0 * deg), 0.5);
    EXPECT_DOUBLE_EQ(cos(60.0 * deg), 0.5);
    EXPECT_DOUBLE_EQ(tan(45.0 * deg), 1.0);
}

TEST(Quantity, NotANumberComparesWithNothing) {
    const Length nan = Length::from_base(std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(nan < m);
    EXPECT_FALSE(nan > m);
    EXPECT_FALSE(nan == nan);
}

}  // namespace
}  // namespace dewbow
