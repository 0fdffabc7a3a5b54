// SPDX-License-Identifier: Apache-2.0
#pragma once

// How high the ground is: what things that stand on it ask.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dewbow/scene/shape.h"

namespace dewbow {

/// The uppermost surface of meshes in the world, by x and z.
class GroundHeight {
public:
    /// Shapes that are no meshes count for nothing.
    explicit GroundHeight(std::span<const Shape* const> shapes);

    /// y of the highest triangle above or below (x, z); nullopt where there is none. In metres.
    std::optional<double> at(double x, double z) const;

private:
    struct Cell {
        std::int64_t x, z;
    };
    void add(const Shape& shape);
    void sort_into_cells();
    Cell cell_of(double x, double z) const;

    std::vector<std::array<Vec3, 3>> triangles_;  ///< in the world
    double low_x_ = 0.0, low_z_ = 0.0, cell_x_ = 1.0, cell_z_ = 1.0;
    std::int64_t side_ = 0;
    std::vector<std::vector<std::uint32_t>> cells_;  ///< triangles that may lie there, [z][x]
};

}  // namespace dewbow
