// SPDX-License-Identifier: Apache-2.0
#include "contestant.h"
#include "dewbow_contestants.h"
#include "languages/languages.h"

namespace dewbow::bench {

const std::vector<ContestantRow>& contestants() {
    static const std::vector<ContestantRow> rows = {
        {"path", "dewbow's path tracer", "dewbow", find_path},
        {"pov-ray", "POV-Ray, which splits a ray into bands of three numbers", "povray", find_pov_ray},
        {"blender-rgb", "Blender's Cycles with a glass for each primary", "blender", find_blender},
        {"pbrt-path", "pbrt-v4's path tracer", "pbrt", find_pbrt},
        {"mitsuba-colourless", "Mitsuba 3, whose glass has one index", "mitsuba", find_mitsuba},
    };
    return rows;
}

}  // namespace dewbow::bench
