// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rain: drops in a region of space, which add to whatever else is there. It has no surface, is no
// body and fills only what the surroundings fill: there is none inside glass or water.

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "dewbow/scene/shape.h"
#include "dewbow/sky/chaos.h"
#include "dewbow/sky/rain_region.h"

namespace dewbow {

class DropCloud;
using DropCloudPtr = std::shared_ptr<const DropCloud>;

/// The inside of a closed mesh.
struct MeshRegion {
    std::shared_ptr<const Mesh> mesh;
    Transform<World, Object> world_from_object;
};

struct Rain {
    std::string name;
    std::variant<ConvexRegion, MeshRegion> region;
    DropCloudPtr drops;  ///< what the drops of a metre of it do to light
    /// By what share of that the density changes from place to place; nothing: the same everywhere.
    std::optional<Chaos> chaos;
};

}  // namespace dewbow
