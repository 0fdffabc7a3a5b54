// SPDX-License-Identifier: Apache-2.0
#include "merge_command.h"

#include <fmt/format.h>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/file_lock.h"
#include "dewbow/render/exposure.h"
#include "dewbow/render/picture_settings.h"
#include "dewbow/render/state.h"
#include "picture_report.h"

namespace dewbow {

namespace {

namespace fs = std::filesystem;

bool is_state(const fs::path& path) { return path.extension() == kStateExtension; }

std::string units_of(const RenderState& state) {
    return fmt::format("{} of {} units", state.plan.finished_units(), state.plan.units());
}

/// All that the states hold. Throws InputError if one is of another render, or holds a part of what
/// another one holds.
RenderState sum_of(const MergeCommand& command) {
    RenderState sum = load_state(command.states.front());
    std::string names = command.states.front();
    for (std::size_t i = 1; i < command.states.size(); ++i) {
        const std::string& name = command.states[i];
        const RenderState state = load_state(name);
        if (add_state(sum, names, state, name) == Added::already_there)
            print_message(presentable(
                fmt::format("warning: {}: all it holds ({}) was there already; it is left out",
                            name, units_of(state))));
        names = "the states before it";
    }
    return sum;
}

void check_whole(const RenderState& sum) {
    const std::size_t missing = sum.plan.units() - sum.plan.finished_units();
    if (missing == 0) return;
    throw InputError(fmt::format("{} of {} units are missing: the picture is not complete", missing,
                                 sum.plan.units()),
                     "add the states that hold them, or write a part with --allow-missing");
}

/// As much of the scene as pictures depend on.
Scene scene_of(const RenderIdentity& identity, const PictureSettings& settings) {
    Scene scene = make_empty_scene();
    scene.film.width = identity.film.width;
    scene.film.height = identity.film.height;
    scene.film.spectral_bins = identity.film.spectral_bins;
    scene.film.white_luminance = settings.white_luminance;
    scene.film.exposure = settings.exposure;
    scene.film.exposure_stops = settings.exposure_stops;
    scene.render.seed = identity.seed;
    scene.render.packet = settings.packet;
    return scene;
}

SessionResult result_of(const RenderState& sum) {
    SessionResult result;
    const bool whole = sum.plan.finished_units() == sum.plan.units();
    result.reason = whole ? StopReason::complete : StopReason::interrupted;
    result.crop = sum.film.crop();
    result.samples = sum.plan.finished_samples();
    result.samples_per_pixel =
        static_cast<double>(result.samples) / static_cast<double>(result.crop.area());
    result.finished_units = sum.plan.finished_units();
    result.planned_units = sum.plan.units();
    result.invalid_samples = sum.film.invalid_samples();
    result.light_paths = sum.film.light_paths();
    result.film_hash = sum.film.fingerprint();
    result.seconds = sum.seconds;
    return result;
}

/// The facts are those of the machines that rendered, not of the one that merges.
Attributes facts_of(const RenderState& sum, const Scene& scene, const SessionResult& result,
                    const std::string& scene_file) {
    Attributes facts = render_facts(scene, sum.identity, result, scene_file);
    for (Attribute& fact : facts)
        if (fact.name == "dewbow:fingerprint") fact.value = sum.identity.fingerprint;
    return facts;
}

/// Writes what can be written; returns the messages of what cannot.
std::vector<std::string> write_all(const std::vector<fs::path>& pictures,
                                   const std::vector<fs::path>& states, const RenderState& sum,
                                   const SessionResult& result) {
    const PictureSettings settings = picture_settings_from_text(sum.identity.picture);
    const Scene scene = scene_of(sum.identity, settings);
    DisplaySettings display;
    display.gamut = settings.gamut;
    if (!pictures.empty()) display.exposure_stops = exposure_of(sum.film, scene.film);
    std::vector<std::string> failures = write_pictures(
        pictures, sum.film, scene, display, facts_of(sum, scene, result, settings.scene_file));
    for (const fs::path& path : states) {
        try {
            write_file_atomically(path, [&](const ByteSink& sink) { write_state(sum, sink); });
        } catch (const InputError& error) {
            failures.push_back(error.what());
        }
    }
    return failures;
}

}  // namespace

int run(const MergeCommand& command) {
    const std::vector<fs::path> outputs(command.outputs.begin(), command.outputs.end());
    std::vector<fs::path> pictures, states;
    for (const fs::path& path : outputs) {
        is_state(path) ? check_writable(path) : check_picture_path(path);
        (is_state(path) ? states : pictures).push_back(path);
    }
    const std::vector<FileLock> locks = lock_files(outputs);

    const RenderState sum = sum_of(command);
    if (!pictures.empty() && !command.allow_missing) check_whole(sum);
    if (sum.plan.finished_units() == 0) throw InputError("the states hold no unit at all");
    const SessionResult result = result_of(sum);
    const std::vector<std::string> failures = write_all(pictures, states, sum, result);
    for (const std::string& failure : failures) print_error(failure);
    if (!failures.empty()) return kFailed;

    if (!command.quiet)
        print_message(fmt::format("{}: {} samples a pixel from {} states, {}", joined(outputs),
                                  samples_text(result.samples_per_pixel), command.states.size(),
                                  units_of(sum)));
    if (command.json) print_json(result, outputs, sum.identity.fingerprint);
    return exit_code_by_samples(result);
}

}  // namespace dewbow
