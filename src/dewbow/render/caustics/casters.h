// SPDX-License-Identifier: Apache-2.0
#pragma once

// What light is aimed at: the shapes that bend or mirror it (smooth and rough glass, mirrors,
// smooth metals and panes; not bodies that shadow rays go through), in groups that lamps see as few
// and tight silhouettes.

#include <vector>

#include "dewbow/render/caustics/caster_bounds.h"
#include "dewbow/scene/scene.h"

namespace dewbow::caustics {

/// Whether light that meets the material may go on without having been scattered as by a rough
/// surface; of a mix, whether any part of it does.
bool is_caster(const Scene& scene, const Material& material);

class Casters {
public:
    /// @param see_through  one a shape: see_through_shapes.
    Casters(const Scene& scene, const std::vector<bool>& see_through);

    const std::vector<CasterBounds>& groups() const { return groups_; }

private:
    std::vector<CasterBounds> groups_;
};

}  // namespace dewbow::caustics
