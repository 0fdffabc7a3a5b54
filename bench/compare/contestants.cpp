// SPDX-License-Identifier: Apache-2.0
#include "contestant.h"
#include "dewbow_contestants.h"
#include "languages/languages.h"

namespace dewbow::bench {
namespace {

constexpr const char* kAimless = "render.caustics.aimed=false";
constexpr const char* kOneWavelength = "render.packet=1";
constexpr const char* kMoreLight = "render.caustics.light_paths=8";

}  // namespace

const std::vector<ContestantRow>& contestants() {
    static const std::vector<ContestantRow> rows = {
        {"path", "dewbow's path tracer", "dewbow", find_path},
        {"caustics", "dewbow's camera and light paths together", "dewbow",
         [](const Programs& programs) { return find_caustics(programs, "caustics", {}); }},
        {"caustics-light-8", "the same with 8 light paths for each camera path", "dewbow",
         [](const Programs& programs) {
             return find_caustics(programs, "caustics-light-8", {kMoreLight});
         }},
        {"caustics-aimless", "the same, light paths going evenly to what is specular", "dewbow",
         [](const Programs& programs) {
             return find_caustics(programs, "caustics-aimless", {kAimless});
         }},
        {"caustics-packet-1", "the same, one wavelength a path", "dewbow",
         [](const Programs& programs) {
             return find_caustics(programs, "caustics-packet-1", {kOneWavelength});
         }},
        {"caustics-plain", "the same, neither aimed nor in packets", "dewbow",
         [](const Programs& programs) {
             return find_caustics(programs, "caustics-plain", {kAimless, kOneWavelength});
         }},
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
        {"pov-ray-photons", "POV-Ray with photon maps; samples are photons for each pixel",
         "povray", find_pov_ray_photons},
        {"blender-rgb", "Blender's Cycles with a glass for each primary", "blender", find_blender},
        {"pbrt-path", "pbrt-v4's path tracer", "pbrt", find_pbrt},
        {"pbrt-lightpath", "pbrt-v4's light tracer", "pbrt", find_pbrt_lightpath},
        {"pbrt-bdpt", "pbrt-v4's bidirectional path tracer", "pbrt", find_pbrt_bdpt},
        {"pbrt-sppm", "pbrt-v4's photon mapping", "pbrt", find_pbrt_sppm},
        {"pbrt-mlt", "pbrt-v4's Metropolis light transport", "pbrt", find_pbrt_mlt},
        {"mitsuba-colourless", "Mitsuba 3, whose glass has one index", "mitsuba", find_mitsuba},
    };
    return rows;
}

}  // namespace dewbow::bench
