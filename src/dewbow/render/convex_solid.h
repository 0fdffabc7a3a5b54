// SPDX-License-Identifier: Apache-2.0
#pragma once

// A closed convex mesh with flat facets, such as a cut stone, seen from inside: where a ray that
// starts on its surface leaves it. The lanes of a packet nearly always leave by the same facet, so
// one lane searches all facets and the others first try the one that it found.

#include <optional>
#include <span>
#include <vector>

#include "dewbow/render/ray.h"

namespace dewbow {

/// Plane of a facet, n · x = d, n outward and unit.
struct FacetPlane {
    Vec3 normal;
    double distance = 0.0;
};

class ConvexSolid {
public:
    /// The solid of these triangles, or nothing if it is not convex, not closed or has more than
    /// kMostFacets facets.  @param planes  of the triangles, outward.  @param contact  rays leave
    /// this much too early, so that they do so before they meet what the solid stands on.
    static std::optional<ConvexSolid> from_triangles(
        const std::vector<Vec3>& vertices,
        const std::vector<std::array<std::uint32_t, 3>>& triangles,
        const std::vector<FacetPlane>& planes, double contact);

    /// Searching more facets one by one costs more than a tree.
    static constexpr int kMostFacets = 256;

    /// Where the lanes in `mask` leave the solid; each starts on its surface and goes inward. Sets
    /// t, primitive (a triangle of the facet) and normal.
    void leave(const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;

    const std::vector<FacetPlane>& facets() const { return facets_; }
    /// All triangles of the facet that `triangle` is one of.
    std::vector<int> facet_triangles(int triangle) const;

private:
    /// The facet by which one ray leaves.
    int search(Vec3 origin, Vec3 direction) const;
    LaneMask try_facet(int facet, const RayLanes& rays, LaneMask mask, std::span<Hit> hits) const;
    void set_hit(int facet, const RayLanes& rays, int lane, Hit& hit) const;

    double contact_ = 0.0;
    std::vector<FacetPlane> facets_;
    std::vector<int> triangle_of_facet_, facet_of_triangle_;
    std::vector<std::vector<FacetPlane>> neighbours_;  // planes of the facets that share an edge
    // The planes again, for the search: structure of arrays in float, padded to whole blocks.
    std::vector<float> nx_, ny_, nz_, d_;
};

}  // namespace dewbow
