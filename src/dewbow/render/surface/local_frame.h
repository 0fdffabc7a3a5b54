// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/math/sampling.h"
#include "dewbow/math/vector.h"

namespace dewbow {

/// Orthonormal frame at a surface point.
struct LocalFrame {
    Vec3 t, b, n;
    explicit LocalFrame(Vec3 normal) : n(normal) {
        const Tangents tangents = tangents_of(normal);
        t = tangents.t, b = tangents.b;
    }
    Vec3 to_local(Vec3 v) const { return {dot(v, t), dot(v, b), dot(v, n)}; }
    Vec3 to_world(Vec3 v) const { return t * v.x + b * v.y + n * v.z; }
};

}  // namespace dewbow
