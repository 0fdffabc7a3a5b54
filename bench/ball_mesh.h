// SPDX-License-Identifier: Apache-2.0
#pragma once

// A ball of as many triangles as a measurement wants.

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "dewbow/scene/scene.h"

namespace dewbow::bench {

/// A closed ball of 2 n (n − 1) triangles and radius 1, give or take bumps of the height `bumps`.
inline std::shared_ptr<const Mesh> ball_mesh(std::uint32_t n, double bumps = 0.0) {
    auto mesh = std::make_shared<Mesh>();
    for (std::uint32_t row = 0; row <= n; ++row)
        for (std::uint32_t column = 0; column < n; ++column) {
            const double theta = std::numbers::pi * row / n;
            const double phi = 2.0 * std::numbers::pi * column / n;
            const double s = row == 0 || row == n ? 0.0 : std::sin(theta);
            const Vec3 d{s * std::cos(phi), std::cos(theta), -s * std::sin(phi)};
            const double bump = std::sin(17.0 * d.x) * std::sin(15.0 * d.y) * std::sin(13.0 * d.z);
            mesh->vertices.push_back({d * (1.0 + bumps * bump)});
        }
    for (std::uint32_t row = 0; row < n; ++row)
        for (std::uint32_t column = 0; column < n; ++column) {
            const std::uint32_t a = row * n + column, b = row * n + (column + 1) % n;
            if (row + 1 < n) mesh->triangles.push_back({a, a + n, b + n});
            if (row > 0) mesh->triangles.push_back({a, b + n, b});
        }
    return mesh;
}

}  // namespace dewbow::bench
