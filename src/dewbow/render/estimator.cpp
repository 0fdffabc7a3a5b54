// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/estimator.h"

#include "dewbow/render/caustics/caustics.h"
#include "dewbow/render/distributed_1989/distributed_1989.h"
#include "dewbow/render/path/path.h"

namespace dewbow {

const std::vector<EstimatorRow>& estimators() {
    static const std::vector<EstimatorRow> rows{
        {"path", "paths from the camera, whose wavelengths part at dispersive surfaces",
         make_path_estimator, path_settings},
        {"caustics", "path, and beside it paths from the lamps, aimed at glass and mirrors",
         make_caustics_estimator, caustics_settings},
        {"distributed_1989", "trees of rays, split into colours where they are first refracted",
         make_distributed_1989_estimator, distributed_1989_settings},
    };
    return rows;
}

}  // namespace dewbow
