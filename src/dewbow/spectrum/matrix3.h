// SPDX-License-Identifier: Apache-2.0
#pragma once

// 3 × 3 matrices for colours: few and small enough for the compiler to work them out.

#include <array>
#include <cstddef>

namespace dewbow {

using Triple = std::array<double, 3>;

struct Matrix3 {
    std::array<Triple, 3> rows{};

    constexpr const Triple& operator[](std::size_t row) const { return rows[row]; }
    constexpr Triple& operator[](std::size_t row) { return rows[row]; }
};

constexpr double dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

constexpr Triple operator*(const Matrix3& m, const Triple& v) {
    return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

constexpr Matrix3 transposed(const Matrix3& m) {
    Matrix3 result;
    for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t c = 0; c < 3; ++c) result[r][c] = m[c][r];
    }
    return result;
}

constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    const Matrix3 b_columns = transposed(b);
    Matrix3 result;
    for (std::size_t r = 0; r < 3; ++r) result[r] = b_columns * a[r];
    return result;
}

constexpr Matrix3 matrix_of_columns(const Triple& a, const Triple& b, const Triple& c) {
    return transposed({{a, b, c}});
}

constexpr Matrix3 diagonal(const Triple& d) {
    return {{Triple{d[0], 0.0, 0.0}, Triple{0.0, d[1], 0.0}, Triple{0.0, 0.0, d[2]}}};
}

constexpr Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr double determinant(const Matrix3& m) { return dot(m[0], cross(m[1], m[2])); }

/// `m` must have a determinant other than zero.
constexpr Matrix3 inverse(const Matrix3& m) {
    const double scale = 1.0 / determinant(m);
    Matrix3 result = matrix_of_columns(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    for (Triple& row : result.rows) {
        for (double& value : row) value *= scale;
    }
    return result;
}

}  // namespace dewbow
