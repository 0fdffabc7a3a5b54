// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/scene_opacity.h"

#include <algorithm>

namespace dewbow {
namespace {

const std::optional<Coverage>& coverage_of(const Scene& scene, int shape) {
    const int material = scene.shapes[std::size_t(shape)].material;
    return scene.materials[std::size_t(material)].coverage;
}

/// Whether the coverage is 1 wherever it is looked up.
bool is_whole(const Coverage& coverage) {
    return !coverage.alpha.texture && !coverage.vertex_alpha &&
           alpha_at(coverage, SurfaceCoordinates{}) == 1.0;
}

}  // namespace

double alpha_at(const Coverage& coverage, const SurfaceCoordinates& at) {
    double alpha = number_at(coverage.alpha, at);
    if (coverage.vertex_alpha) alpha *= at.alpha;
    if (coverage.cutoff) return alpha >= *coverage.cutoff ? 1.0 : 0.0;
    return std::clamp(alpha, 0.0, 1.0);
}

SceneOpacity::SceneOpacity(const Scene& scene) : scene_(scene) {
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const std::optional<Coverage>& coverage = coverage_of(scene, int(i));
        tests_.push_back(coverage && !is_whole(*coverage));
    }
}

double SceneOpacity::at(int shape, int primitive, double u, double v) const {
    const Geometry& geometry = scene_.shapes[std::size_t(shape)].geometry;
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&geometry);
    return alpha_at(*coverage_of(scene_, shape),
                    mesh ? coordinates_on(**mesh, primitive, u, v) : coordinates_on_chart(u, v));
}

}  // namespace dewbow
