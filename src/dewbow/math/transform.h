// SPDX-License-Identifier: Apache-2.0
#pragma once

// Affine maps between frames, named `to_from_from`: `world_from_camera * camera_from_object`.

#include <array>
#include <optional>

#include "dewbow/base/quantity.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// 3 × 4 affine matrix, rows first: the last column is the translation.
struct Affine {
    std::array<std::array<double, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

    Vec3 apply_linear(Vec3 v) const;
    Vec3 apply(Vec3 p) const;
    /// Determinant of the linear part; negative for a mirror image.
    double determinant() const;
    /// The inverse map; nothing if the linear part is singular (relative to its own scale).
    std::optional<Affine> inverse() const;
    friend Affine operator*(const Affine& a, const Affine& b);
};

Affine translation(Vec3 by);
Affine scaling(Vec3 by);
/// Rotation by `angle` about the unit vector `axis`, right-handed.
Affine rotation(Vec3 axis, Angle angle);
/// Rotation of the unit quaternion (x, y, z, w), glTF's order.
Affine rotation_of_quaternion(double x, double y, double z, double w);
/// World from camera, for a camera at `eye` that looks at `target` (camera looks along −z, y up).
/// `up` must not be parallel to the line of sight.
Affine looking_at(Vec3 eye, Vec3 target, Vec3 up);

/// The map that takes what is given in `From` to `To`. Its inverse is stored with it.
template <class To, class From>
class Transform {
public:
    Transform() = default;
    /// `to_from_from` must be invertible: check `Affine::inverse` at the door.
    explicit Transform(const Affine& to_from_from)
        : forward_(to_from_from), backward_(to_from_from.inverse().value()) {}

    Point<To> operator()(Point<From> p) const { return {forward_.apply(p.v)}; }
    /// Not normalised: the length tells how distances along the direction scale.
    Dir<To> operator()(Dir<From> d) const { return {forward_.apply_linear(d.v)}; }
    /// By the inverse transpose, normalised.
    Normal<To> operator()(Normal<From> n) const {
        const auto& i = backward_.m;
        return {normalised({i[0][0] * n.v.x + i[1][0] * n.v.y + i[2][0] * n.v.z,
                            i[0][1] * n.v.x + i[1][1] * n.v.y + i[2][1] * n.v.z,
                            i[0][2] * n.v.x + i[1][2] * n.v.y + i[2][2] * n.v.z})};
    }
    Transform<From, To> inverse() const { return Transform<From, To>(backward_, forward_); }
    const Affine& affine() const { return forward_; }
    const Affine& inverse_affine() const { return backward_; }

    template <class Inner>
    friend Transform<To, Inner> operator*(const Transform& a, const Transform<From, Inner>& b) {
        return a.after(b);
    }

private:
    template <class, class>
    friend class Transform;
    template <class Inner>
    Transform<To, Inner> after(const Transform<From, Inner>& b) const {
        return Transform<To, Inner>(forward_ * b.forward_, b.backward_ * backward_);
    }
    Transform(const Affine& forward, const Affine& backward)
        : forward_(forward), backward_(backward) {}
    Affine forward_, backward_;
};

}  // namespace dewbow
