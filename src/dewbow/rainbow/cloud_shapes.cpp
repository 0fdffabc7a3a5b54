// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/cloud_shapes.h"

#include "dewbow/base/parallel.h"

namespace dewbow {

std::vector<ShapedDrops> shape_drops(std::span<const WeightedRadius> radii,
                                     const std::optional<FallingShape>& falling,
                                     RelativeIndex least, RelativeIndex greatest) {
    std::vector<ShapedDrops> drops;
    std::vector<Spheroid> shapes;
    for (std::size_t r = 0; r < radii.size(); ++r) {
        if (!falling || raindrop_axis_ratio(radii[r].radius) == 1.0) {
            drops.push_back({.radius = r});
            shapes.push_back({});
            continue;
        }
        for (const WeightedShape& each : raindrop_shapes(radii[r].radius, falling->spread)) {
            drops.push_back({.radius = r, .share = each.share});
            shapes.push_back(each.shape);
        }
    }
    parallel_for(drops.size(), [&](std::size_t d) {
        if (shapes[d].axis_ratio == 1.0) return;
        drops[d].at_least = bow_shifts(least, shapes[d], falling->place);
        drops[d].at_greatest = bow_shifts(greatest, shapes[d], falling->place);
    });
    return drops;
}

}  // namespace dewbow
