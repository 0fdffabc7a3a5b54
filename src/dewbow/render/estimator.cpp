// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/estimator.h"

#if __has_include("dewbow/render/path/path.h")
#include "dewbow/render/path/path.h"
#define DEWBOW_HAS_PATH
#endif

namespace dewbow {

const std::vector<EstimatorRow>& estimators() {
    static const std::vector<EstimatorRow> rows{
#ifdef DEWBOW_HAS_PATH
        {"path", "paths from the camera, whose wavelengths part at dispersive surfaces",
         make_path_estimator},
#endif
    };
    return rows;
}

}  // namespace dewbow
