// SPDX-License-Identifier: Apache-2.0
#pragma once

// Vectors, and the three things that vectors are used for. A point, a direction and a normal
// transform differently and belong to a frame; mixing them up does not compile. `Vec3` is the bare
// triple beneath them, for arithmetic inside one function.

#include <cmath>
#include <optional>

namespace dewbow {

struct Vec3 {
    double x = 0.0, y = 0.0, z = 0.0;

    constexpr double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    constexpr Vec3 operator-() const { return {-x, -y, -z}; }
    constexpr Vec3& operator+=(Vec3 b) { return x += b.x, y += b.y, z += b.z, *this; }
    constexpr Vec3& operator-=(Vec3 b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
    constexpr Vec3& operator*=(double s) { return x *= s, y *= s, z *= s, *this; }
    friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return a += b; }
    friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return a -= b; }
    friend constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }
    friend constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }
    friend constexpr Vec3 operator/(Vec3 a, double s) { return a *= 1.0 / s; }
    constexpr bool operator==(const Vec3&) const = default;
};

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 v) { return std::sqrt(dot(v, v)); }
/// `v` must not be the zero vector.
inline Vec3 normalised(Vec3 v) { return v * (1.0 / length(v)); }
inline bool is_finite(Vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
constexpr Vec3 min(Vec3 a, Vec3 b) {
    return {a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, a.z < b.z ? a.z : b.z};
}
constexpr Vec3 max(Vec3 a, Vec3 b) {
    return {a.x > b.x ? a.x : b.x, a.y > b.y ? a.y : b.y, a.z > b.z ? a.z : b.z};
}

// Frames.
struct World {};   ///< metres; y up, right-handed, as in glTF
struct Camera {};  ///< looks along −z, y up, x right, as in glTF
struct Object {};  ///< a shape's own
struct Local {};   ///< at a surface point: z is the shading normal

/// A position in `Frame`.
template <class Frame>
struct Point {
    Vec3 v;
};
/// A direction in `Frame`: unit length unless a function says otherwise.
template <class Frame>
struct Dir {
    Vec3 v;
    constexpr Dir operator-() const { return {-v}; }
};
/// A surface normal in `Frame`, unit length: transforms by the inverse transpose.
template <class Frame>
struct Normal {
    Vec3 v;
    constexpr Normal operator-() const { return {-v}; }
};

template <class Frame>
constexpr Vec3 operator-(Point<Frame> a, Point<Frame> b) {
    return a.v - b.v;
}
/// The point at `distance` from `origin` along `d`.
template <class Frame>
constexpr Point<Frame> along(Point<Frame> origin, Dir<Frame> d, double distance) {
    return {origin.v + d.v * distance};
}
template <class Frame>
constexpr double dot(Dir<Frame> a, Dir<Frame> b) {
    return dot(a.v, b.v);
}
template <class Frame>
constexpr double dot(Dir<Frame> a, Normal<Frame> n) {
    return dot(a.v, n.v);
}

/// Two unit vectors that complete `n` (unit) to a right-handed orthonormal frame (t, b, n).
/// [Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1) 2017]
struct Tangents {
    Vec3 t, b;
};
inline Tangents tangents_of(Vec3 n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    const double c = n.x * n.y * a;
    return {{1.0 + sign * n.x * n.x * a, sign * c, -sign * n.x}, {c, sign + n.y * n.y * a, -n.y}};
}

}  // namespace dewbow
