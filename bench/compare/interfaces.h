// SPDX-License-Identifier: Apache-2.0
#pragma once

// Boundaries between clear bodies, for renderers that know nothing of priorities.

#include "things.h"

namespace dewbow::bench {

/// Triangles of one body, or a sphere, with one medium on each side.
struct Interface {
    int inside = -1, outside = -1;  ///< bodies whose index counts there; -1: the surroundings
    PlainBody surface;              ///< without index; normals point to `outside`
};

/// Where bodies overlap, what lies within a body of higher priority is left out. A triangle is of
/// one kind as a whole, that of its middle: edges have to lie where another body's surface begins.
std::vector<Interface> interfaces_of(const PlainScene& scene);

/// Index of what lies inside of an interface over that of what lies outside.
double relative_index(const PlainScene& scene, const Interface& interface, Wavelength lambda);

}  // namespace dewbow::bench
