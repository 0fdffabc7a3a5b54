// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where rays meet the scene. Embree finds the triangle; the distance is then computed again in
// double precision from the triangle's plane. Analytic shapes live in the same tree.

#include <memory>
#include <string>
#include <vector>

#include "dewbow/render/opacity.h"
#include "dewbow/render/ray.h"
#include "dewbow/render/surface_inputs.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

struct AcceleratorTree;

/// Directions on a surface.
struct PictureAxes {
    Vec3 right, up;
};

class Accelerator {
public:
    /// @param see_through  one a shape: whether shadow rays ignore it (a boundary that bends
    /// nothing).  @param opacity  which hits are there in part, or nullptr: all are whole. Hits are
    /// taken with the probability of their opacity, by rays and shadow rays alike.
    /// `scene` and `opacity` must outlive this.
    Accelerator(const Scene& scene, std::vector<bool> see_through,
                const Opacity* opacity = nullptr);
    ~Accelerator();
    Accelerator(const Accelerator&) = delete;
    Accelerator& operator=(const Accelerator&) = delete;

    /// Nearest hit of one ray.
    Hit intersect(const Ray& ray) const;
    /// Nearest hits of the lanes in `mask`; the others are left as they are.
    void intersect(const RayLanes& rays, LaneMask mask, HitLanes& hits) const;
    /// Whether anything stands in the way before `distance` (but for rounding: a light's own
    /// surface there does not hide it).
    bool occluded(const Ray& ray, double distance) const;

    /// What textures are looked up by at `point`, the place of `hit`. Computed in double precision
    /// from the point, also where the hit names another triangle of the same flat facet.
    SurfaceCoordinates coordinates(const Hit& hit, Vec3 point) const;
    /// Where right and up lie of a picture that is looked up by that set of texture coordinates,
    /// for normal maps: the mesh's own tangents, or the derivatives of its coordinates. In the
    /// world, not unit, not orthogonal; zero where there are none.
    PictureAxes picture_axes(const Hit& hit, Vec3 point, int texcoord_set) const;

    /// Unit normal for shading at `hit`: interpolated where a mesh brings normals, else hit.normal.
    /// On the outward side of the true surface.
    Vec3 shading_normal(const Hit& hit) const;
    /// Whether the shading normal of that shape is its true normal everywhere.
    bool flat(int shape) const;

private:
    std::unique_ptr<AcceleratorTree> tree_;
};

/// "Embree 3.13.5 avx2": what the bits of hits depend on.
std::string accelerator_fingerprint();

}  // namespace dewbow
