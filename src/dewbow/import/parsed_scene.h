// SPDX-License-Identifier: Apache-2.0
#pragma once

// What one importer made of one file, before it is completed.

#include <unordered_map>

#include "dewbow/base/error.h"
#include "dewbow/scene/scene.h"

namespace dewbow {

struct ParsedScene {
    Scene scene;
    Diagnostics diagnostics;
    bool camera_stated = false;  ///< the file says which of its cameras takes the picture
    /// What glows with less, in cd m⁻², is a label or a screen, and no light to see by.
    double least_lamp_luminance = 0.0;
};

/// Adds a camera to those that `scene` offers. Where its name is taken or empty it gets a number:
/// "camera", "camera 2", "camera 3".
void offer_camera(Scene& scene, CameraView camera);

/// True if something in the scene gives off light that its surfaces can show: a light, or a surface
/// of more than `least_luminance` cd m⁻².
bool brings_light(const Scene& scene, double least_luminance = 0.0);

/// Does away with mirror images, so that front faces are counter-clockwise in every frame.
class Mirrors {
public:
    /// The same surface in the world, placed by a transform of positive determinant: a mirrored
    /// mesh is mirrored itself, once for all shapes that share it, and its triangles are turned
    /// round. Analytic shapes are symmetric in x.
    Shape upright(Shape shape);

private:
    std::unordered_map<std::shared_ptr<const Mesh>, std::shared_ptr<const Mesh>> copies_;
};

}  // namespace dewbow
