// SPDX-License-Identifier: Apache-2.0
#include "dewbow/math/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewbow {

namespace {

// The determinant is six products of three entries; its rounding error is a few epsilon times the
// product of the lengths of the rows (or columns). Below that, nothing is known of it but that it
// is small.
constexpr double kSingular = 64.0 * std::numeric_limits<double>::epsilon();

Vec3 row(const Affine& a, int i) { return {a.m[i][0], a.m[i][1], a.m[i][2]}; }
Vec3 column(const Affine& a, int j) { return {a.m[0][j], a.m[1][j], a.m[2][j]}; }

Affine from_rows(Vec3 a, Vec3 b, Vec3 c) {
    return {{{{a.x, a.y, a.z, 0.0}, {b.x, b.y, b.z, 0.0}, {c.x, c.y, c.z, 0.0}}}};
}

double largest_entry(const Affine& a) {
    double largest = 0.0;
    for (const auto& r : a.m)
        for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(r[j]));
    return largest;
}

/// The linear part, times `factor`.
Affine linear_part(const Affine& a, double factor) {
    return from_rows(row(a, 0) * factor, row(a, 1) * factor, row(a, 2) * factor);
}

bool is_singular(const Affine& a) {
    const double rows = length(row(a, 0)) * length(row(a, 1)) * length(row(a, 2));
    const double columns = length(column(a, 0)) * length(column(a, 1)) * length(column(a, 2));
    return !(std::abs(a.determinant()) > kSingular * std::min(rows, columns));
}

void set_translation(Affine& a, Vec3 t) {
    a.m[0][3] = t.x;
    a.m[1][3] = t.y;
    a.m[2][3] = t.z;
}

Vec3 translation_of(const Affine& a) { return {a.m[0][3], a.m[1][3], a.m[2][3]}; }

}  // namespace

Vec3 Affine::apply_linear(Vec3 v) const {
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z,
            m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

Vec3 Affine::apply(Vec3 p) const { return apply_linear(p) + translation_of(*this); }

double Affine::determinant() const {
    return dot(row(*this, 0), cross(row(*this, 1), row(*this, 2)));
}

std::optional<Affine> Affine::inverse() const {
    // Scaled to entries of about 1, so that neither tiny nor huge units underflow or overflow.
    const double scale = largest_entry(*this);
    if (!(scale > 0.0) || !std::isfinite(scale)) return std::nullopt;
    const Affine unit = linear_part(*this, 1.0 / scale);
    if (is_singular(unit)) return std::nullopt;

    // The columns of the inverse are the cross products of the rows over the determinant.
    const double factor = 1.0 / (unit.determinant() * scale);
    const Vec3 a = cross(row(unit, 1), row(unit, 2)) * factor;
    const Vec3 b = cross(row(unit, 2), row(unit, 0)) * factor;
    const Vec3 c = cross(row(unit, 0), row(unit, 1)) * factor;
    Affine result = from_rows({a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z});
    set_translation(result, -result.apply_linear(translation_of(*this)));
    if (!std::isfinite(largest_entry(result)) || !is_finite(translation_of(result)))
        return std::nullopt;
    return result;
}

Affine operator*(const Affine& a, const Affine& b) {
    const Vec3 x = a.apply_linear(column(b, 0));
    const Vec3 y = a.apply_linear(column(b, 1));
    const Vec3 z = a.apply_linear(column(b, 2));
    Affine result = from_rows({x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z});
    set_translation(result, a.apply(translation_of(b)));
    return result;
}

Affine translation(Vec3 by) {
    Affine result;
    set_translation(result, by);
    return result;
}

Affine scaling(Vec3 by) { return from_rows({by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}); }

Affine rotation(Vec3 axis, Angle angle) {
    // v' = v cos + (a x v) sin + a (a . v)(1 - cos)    [Rodrigues 1840], with 1 - cos = 2
    // sin²(angle/2), which loses nothing for small angles.
    const Vec3 a = axis;
    const double s = sin(angle), half = sin(0.5 * angle), u = 2.0 * half * half, c = 1.0 - u;
    return from_rows({c + a.x * a.x * u, a.x * a.y * u - a.z * s, a.x * a.z * u + a.y * s},
                     {a.y * a.x * u + a.z * s, c + a.y * a.y * u, a.y * a.z * u - a.x * s},
                     {a.z * a.x * u - a.y * s, a.z * a.y * u + a.x * s, c + a.z * a.z * u});
}

Affine rotation_of_quaternion(double x, double y, double z, double w) {
    // Divided by the norm: files round their quaternions, and a rotation must not scale.
    const double s = 2.0 / (x * x + y * y + z * z + w * w);
    return from_rows({1.0 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)},
                     {s * (x * y + z * w), 1.0 - s * (x * x + z * z), s * (y * z - x * w)},
                     {s * (x * z - y * w), s * (y * z + x * w), 1.0 - s * (x * x + y * y)});
}

Affine looking_at(Vec3 eye, Vec3 target, Vec3 up) {
    const Vec3 z = normalised(eye - target);
    const Vec3 x = normalised(cross(up, z));
    const Vec3 y = cross(z, x);
    Affine result = from_rows({x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z});
    set_translation(result, eye);
    return result;
}

}  // namespace dewbow
