// SPDX-License-Identifier: Apache-2.0
#pragma once

// How much of a scene's surfaces is there, by the coverage of their materials.

#include "dewbow/render/opacity.h"
#include "dewbow/render/surface_inputs.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

class SceneOpacity final : public Opacity {
public:
    /// `scene` outlives this.
    explicit SceneOpacity(const Scene& scene);
    bool tests(int shape) const override { return tests_[std::size_t(shape)]; }
    double at(int shape, int primitive, double u, double v) const override;

private:
    const Scene& scene_;
    std::vector<bool> tests_;  ///< one a shape
};

/// Alpha of a surface at one place: 0 to 1, and one of the two where there is a cutoff.
double alpha_at(const Coverage& coverage, const SurfaceCoordinates& at);

}  // namespace dewbow
