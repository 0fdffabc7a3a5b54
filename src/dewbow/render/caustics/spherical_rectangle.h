// SPDX-License-Identifier: Apache-2.0
#pragma once

// A rectangle as a point sees it, sampled alike in all directions that it fills.
// [Ureña, Fajardo & King, "An Area-Preserving Parametrization for Spherical Rectangles", 2013]

#include <array>
#include <complex>

namespace dewbow::caustics {

/// The rectangle [x0, x1] × [y0, y1] in the plane z = `distance`, seen from the origin.
class SphericalRectangle {
public:
    SphericalRectangle() = default;
    /// @param distance  > 0.
    SphericalRectangle(double x0, double x1, double y0, double y1, double distance);

    /// sr.   Error: about 1e-15 sr.
    double solid_angle() const { return solid_angle_; }
    struct Point {
        double x, y;
    };
    /// Uniform numbers give directions alike.
    Point sample(std::array<double, 2> u) const;
    /// The inverse; for points of the rectangle.
    std::array<double, 2> place_of(Point p) const;

private:
    using Turn = std::complex<double>;  ///< an angle as a point of the unit circle
    Turn strip(double x) const;

    double x0_ = 0.0, x1_ = 0.0, y0_ = 0.0, y1_ = 0.0, z_ = 1.0;
    Turn left_;  ///< strip(x0)
    double solid_angle_ = 0.0;
};

}  // namespace dewbow::caustics
