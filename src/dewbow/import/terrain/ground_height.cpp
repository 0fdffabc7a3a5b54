// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/terrain/ground_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewbow {
namespace {

/// Of triangles to the side of the square of cells: about two triangles a cell of an even grid.
constexpr double kTrianglesPerCell = 2.0;
constexpr std::int64_t kMostCells = 1024;  ///< along a side

/// y of the triangle's plane at (x, z), if that is within the triangle or on its edge.
std::optional<double> height_of(const std::array<Vec3, 3>& t, double x, double z) {
    const auto area = [](double ax, double az, double bx, double bz) { return ax * bz - az * bx; };
    const Vec3 &a = t[0], &b = t[1], &c = t[2];
    const double whole = area(b.x - a.x, b.z - a.z, c.x - a.x, c.z - a.z);
    if (whole == 0.0) return std::nullopt;
    const double of_b = area(x - a.x, z - a.z, c.x - a.x, c.z - a.z) / whole;
    const double of_c = area(b.x - a.x, b.z - a.z, x - a.x, z - a.z) / whole;
    // Roundings of places that lie on an edge, which must not fall between two triangles.
    constexpr double kSlack = -1e-9;
    if (of_b < kSlack || of_c < kSlack || 1.0 - of_b - of_c < kSlack) return std::nullopt;
    return a.y + of_b * (b.y - a.y) + of_c * (c.y - a.y);
}

}  // namespace

GroundHeight::GroundHeight(std::span<const Shape* const> shapes) {
    for (const Shape* shape : shapes) add(*shape);
    if (!triangles_.empty()) sort_into_cells();
}

void GroundHeight::add(const Shape& shape) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&shape.geometry);
    if (!mesh) return;
    for (const auto& corners : (*mesh)->triangles) {
        std::array<Vec3, 3> triangle;
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = shape.world_from_object((*mesh)->vertices[corners[k]]).v;
        triangles_.push_back(triangle);
    }
}

void GroundHeight::sort_into_cells() {
    Vec3 low = triangles_[0][0], high = low;
    for (const auto& triangle : triangles_)
        for (const Vec3 corner : triangle) low = min(low, corner), high = max(high, corner);
    side_ = std::clamp(std::int64_t(std::sqrt(double(triangles_.size()) / kTrianglesPerCell)),
                       std::int64_t{1}, kMostCells);
    low_x_ = low.x, low_z_ = low.z;
    const auto cell = [&](double from, double to) {
        return std::max((to - from) / double(side_), std::numeric_limits<double>::min());
    };
    cell_x_ = cell(low.x, high.x), cell_z_ = cell(low.z, high.z);
    cells_.resize(std::size_t(side_ * side_));
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const auto& [a, b, c] = triangles_[i];
        const Vec3 from = min(min(a, b), c), to = max(max(a, b), c);
        const Cell first = cell_of(from.x, from.z), last = cell_of(to.x, to.z);
        for (std::int64_t z = first.z; z <= last.z; ++z)
            for (std::int64_t x = first.x; x <= last.x; ++x)
                cells_[std::size_t(z * side_ + x)].push_back(std::uint32_t(i));
    }
}

/// The nearest cell, where (x, z) is beyond them all.
GroundHeight::Cell GroundHeight::cell_of(double x, double z) const {
    const auto one = [&](double offset, double cell) {
        return std::int64_t(std::clamp(offset / cell, 0.0, double(side_ - 1)));
    };
    return {one(x - low_x_, cell_x_), one(z - low_z_, cell_z_)};
}

std::optional<double> GroundHeight::at(double x, double z) const {
    if (triangles_.empty()) return std::nullopt;
    const Cell cell = cell_of(x, z);
    std::optional<double> highest;
    for (const std::uint32_t i : cells_[std::size_t(cell.z * side_ + cell.x)])
        if (const auto y = height_of(triangles_[i], x, z))
            highest = std::max(highest.value_or(*y), *y);
    return highest;
}

}  // namespace dewbow
