// SPDX-License-Identifier: Apache-2.0
#include "contestant.h"
#include "dewbow_contestants.h"
#include "languages/languages.h"

namespace dewbow::bench {

const std::vector<ContestantRow>& contestants() {
    static const std::vector<ContestantRow> rows = {
        {"path", "dewbow's path tracer", "dewbow", find_path},
        {"1989-fixed", "the method of 1989 as published, samples fixed", "dewbow",
         find_published_1989<SamplesLie::fixed>},
        {"1989-jittered", "the method of 1989 as published, samples jittered", "dewbow",
         find_published_1989<SamplesLie::jittered>},
        {"1989-correlated", "the method of 1989 as published, samples correlated", "dewbow",
         find_published_1989<SamplesLie::correlated>},
        {"1989-corrected-fixed",
         "the method of 1989 with the true colours and index, samples fixed", "dewbow",
         find_corrected_1989<SamplesLie::fixed>},
        {"1989-corrected-jittered",
         "the method of 1989 with the true colours and index, samples jittered", "dewbow",
         find_corrected_1989<SamplesLie::jittered>},
        {"1989-corrected-correlated",
         "the method of 1989 with the true colours and index, samples correlated", "dewbow",
         find_corrected_1989<SamplesLie::correlated>},
        {"pov-ray", "POV-Ray, which splits a ray into bands of three numbers", "povray",
         find_pov_ray},
        {"blender-rgb", "Blender's Cycles with a glass for each primary", "blender", find_blender},
        {"pbrt-path", "pbrt-v4's path tracer", "pbrt", find_pbrt},
        {"mitsuba-colourless", "Mitsuba 3, whose glass has one index", "mitsuba", find_mitsuba},
    };
    return rows;
}

}  // namespace dewbow::bench
