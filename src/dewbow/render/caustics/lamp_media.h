// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/render/bounds_index.h"
#include "dewbow/render/prepared_scene.h"

namespace dewbow::caustics {

/// What lamps stand in: mostly the surroundings, which is seen at once.
class LampMedia {
public:
    /// `prepared` must outlive this.
    explicit LampMedia(const PreparedScene& prepared);
    /// What the first way of `ray` leads through.
    MediaStack along(const Ray& ray) const;

private:
    const PreparedScene& prepared_;
    BoundsIndex bodies_;
};

}  // namespace dewbow::caustics
