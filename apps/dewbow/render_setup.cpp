// SPDX-License-Identifier: Apache-2.0
#include "render_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "console.h"
#include "dewbow/base/checksum.h"
#include "dewbow/base/error.h"
#include "dewbow/base/hash.h"
#include "dewbow/base/read_record.h"
#include "dewbow/import/import.h"
#include "dewbow/render/picture_settings.h"
#include "interrupt.h"
#include "memory.h"

namespace dewbow {

namespace {

/// The options of `load`, as they are typed.
std::string load_options_text(const LoadOptions& load) {
    std::string text;
    if (!load.camera.empty()) text += " --camera " + shell_quoted(load.camera);
    if (load.frame)
        text += fmt::format(" --frame {} --fps {}", *load.frame, load.frames_per_second);
    for (const GlassOverride& glass : load.glasses)
        text += " --glass " + shell_quoted(glass.material + "=" + glass.glass);
    if (!load.environment.empty()) text += " --env " + shell_quoted(load.environment);
    for (const std::string& setting : load.settings) text += " --set " + shell_quoted(setting);
    return text;
}

/// Makes the scene what the options say.
void apply_options(const RenderCommand& command, Scene& scene) {
    const auto set = [](auto& value, const auto& wish) {
        if (wish) value = *wish;
    };
    if (command.exposure_stops || command.automatic_exposure)
        scene.film.exposure =
            command.automatic_exposure ? ExposureMode::automatic : ExposureMode::fixed;
    set(scene.film.exposure_stops, command.exposure_stops);
    set(scene.film.spectral_bins, command.spectral_bins);
    set(scene.render.samples_per_pixel, command.samples_per_pixel);
    set(scene.render.seed, command.seed);
    set(scene.render.packet, command.packet);
    set(scene.render.max_depth, command.max_depth);
    set(scene.render.wavelengths, command.wavelengths);
}

void print_diagnostics(const Diagnostics& diagnostics) {
    std::set<std::string> printed;
    for (const Diagnostic& diagnostic : diagnostics) {
        const std::string place = to_string(diagnostic.place);
        std::string line = "warning: " + (place.empty() ? "" : place + ": ") + diagnostic.text;
        std::replace(line.begin(), line.end(), '\n', ' ');  // one line, whatever a name holds
        if (printed.insert(line).second) print_message(presentable(line));
    }
}

std::uint64_t scene_hash(const LoadOptions& load, std::uint64_t contents) {
    LoadOptions options = load;
    if (!options.environment.empty()) options.environment = "given";
    Checksum checksum;
    checksum.add(load_options_text(options));
    return hash_combine(contents, checksum.value());
}

}  // namespace

std::string replay_command(const RenderCommand& command) {
    std::string text = "dewbow render " + shell_quoted(command.scene_file);
    text += load_options_text(command.load);
    if (command.size)
        text += fmt::format(" --size {}x{}", command.size->width, command.size->height);
    if (command.packet) text += fmt::format(" --packet {}", *command.packet);
    if (command.max_depth) text += fmt::format(" --max-depth {}", *command.max_depth);
    if (command.wavelengths)
        text += *command.wavelengths == WavelengthSampling::visual ? " --wavelengths visual"
                                                                   : " --wavelengths uniform";
    if (command.estimator != kDefaultEstimator) text += " --estimator " + command.estimator;
    return text;
}

LoadedScene load(const RenderCommand& command, bool silent) {
    const ReadRecord record;
    LoadOptions options = command.load;
    if (command.size) options.width = command.size->width, options.height = command.size->height;
    ImportedScene imported = load_scene(command.scene_file, options);
    if (!silent) print_diagnostics(imported.diagnostics);
    apply_options(command, imported.scene);
    validate_view(imported.scene);
    return {std::move(imported.scene), scene_hash(options, record.hash())};
}

EstimatorChoice estimator_of(const RenderCommand& command, const Scene& scene, bool silent) {
    for (const EstimatorRow& row : estimators()) {
        if (row.name != command.estimator) continue;
        EstimatorChoice chosen{row, row.make(scene), {}};
        if (const std::string lost = chosen.estimator->leaves_out(); !lost.empty() && !silent)
            print_message(fmt::format("warning: {} leaves out {}", row.name, lost));
        return chosen;
    }
    EstimatorChoice choice = choose_estimator(scene);
    if (!command.quiet && !silent)
        print_message(fmt::format("estimator {}: {}", choice.row.name, choice.reason));
    return choice;
}

void check_memory_of(const Scene& scene, const SessionOptions& options,
                     const Estimator& estimator) {
    const PixelRect whole{0, 0, scene.film.width, scene.film.height};
    check_memory(options.crop.value_or(whole), scene.film.spectral_bins,
                 estimator.light_paths() > 0.0);
}

std::string scene_name(const RenderCommand& command) {
    return std::filesystem::path(command.scene_file).filename().string();
}

SessionOptions session_options(const RenderCommand& command) {
    SessionOptions options;
    options.crop = command.crop;
    options.time_limit = command.time_limit;
    options.noise_target = command.noise_target;
    options.progress = command.progress;
    options.title = "render " + scene_name(command);
    options.stop = &stop_requested();
    return options;
}

void check_crop(const PixelRect& crop, const Film& film) {
    if (crop.x1 <= film.width && crop.y1 <= film.height) return;
    throw UsageError(
        fmt::format("--crop is {},{},{}x{}; it must lie in the picture of {}x{} pixels", crop.x0,
                    crop.y0, crop.width(), crop.height(), film.width, film.height));
}

RenderIdentity identity_of(const RenderCommand& command, const LoadedScene& loaded,
                           const SessionOptions& options, const EstimatorChoice& chosen) {
    RenderIdentity identity = render_identity(loaded.scene, options, chosen.row, loaded.hash,
                                              chosen.estimator->light_paths());
    const Film& film = loaded.scene.film;
    identity.picture = text_of(PictureSettings{scene_name(command), loaded.scene.render.packet,
                                               film.white_luminance, film.exposure,
                                               film.exposure_stops, command.gamut});
    return identity;
}

}  // namespace dewbow
