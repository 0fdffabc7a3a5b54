// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "checkpoint_file.h"
#include "command.h"
#include "console.h"
#include "dewbow/base/check.h"
#include "dewbow/base/checksum.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file_lock.h"
#include "dewbow/base/hash.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/read_record.h"
#include "dewbow/import/import.h"
#include "dewbow/render/exposure.h"
#include "dewbow/render/output.h"
#include "dewbow/render/picture_settings.h"
#include "dewbow/render/session.h"
#include "interrupt.h"
#include "memory.h"
#include "picture_report.h"

namespace dewbow {

namespace {

std::vector<std::filesystem::path> output_paths(const RenderCommand& command) {
    if (!command.outputs.empty()) return {command.outputs.begin(), command.outputs.end()};
    const std::filesystem::path stem = std::filesystem::path(command.scene_file).stem();
    std::vector<std::filesystem::path> paths;
    for (const std::string& extension : picture_extensions())
        paths.push_back(stem.string() + extension);
    return paths;
}

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

/// The command that replays a sample, but for --pixel, --sample and --seed: all that a sample
/// depends on.
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
    if (!command.estimator.empty()) text += " --estimator " + command.estimator;
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

/// A scene, and a hash of the files and options that it was made from: of the files their contents
/// and not their names.
struct LoadedScene {
    Scene scene;
    std::uint64_t hash = 0;
};

std::uint64_t scene_hash(const LoadOptions& load, std::uint64_t contents) {
    LoadOptions options = load;
    if (!options.environment.empty()) options.environment = "given";
    Checksum checksum;
    checksum.add(load_options_text(options));
    return hash_combine(contents, checksum.value());
}

LoadedScene load(const RenderCommand& command) {
    const ReadRecord record;
    LoadOptions options = command.load;
    if (command.size) options.width = command.size->width, options.height = command.size->height;
    ImportedScene imported = load_scene(command.scene_file, options);
    print_diagnostics(imported.diagnostics);
    apply_options(command, imported.scene);
    validate_view(imported.scene);
    return {std::move(imported.scene), scene_hash(options, record.hash())};
}

const EstimatorRow& estimator_of(const RenderCommand& command) {
    for (const EstimatorRow& row : estimators())
        if (command.estimator.empty() || row.name == command.estimator) return row;
    throw InputError("this program was built without estimators");
}

void check_memory_of(const Scene& scene, const SessionOptions& options) {
    const PixelRect whole{0, 0, scene.film.width, scene.film.height};
    check_memory(options.crop.value_or(whole), scene.film.spectral_bins);
}

// ---- one sample --------------------------------------------------------------------------------

/// JSON knows no NaN and no infinity: such a number becomes its name.
nlohmann::ordered_json json_number(double value) {
    if (std::isfinite(value)) return value;
    return fmt::format("{}", value);
}

void print_sample(const RenderCommand& command, const Scene& scene, const PixelSample& sample) {
    const WavelengthPacket& packet = sample.wavelengths;
    if (command.json) {
        nlohmann::ordered_json lanes = nlohmann::ordered_json::array();
        for (int k = 0; k < packet.count; ++k)
            lanes.push_back({{"lambda_nm", json_number(packet.lambda_nm[k])},
                             {"pdf_per_nm", json_number(packet.pdf_per_nm[k])},
                             {"radiance_W_per_m2_sr_nm", json_number(sample.radiance[k])}});
        const nlohmann::ordered_json object{{"pixel", {command.replay->x, command.replay->y}},
                                            {"sample", command.replay->sample},
                                            {"seed", scene.render.seed},
                                            {"depth_m", json_number(sample.depth)},
                                            {"lanes", lanes}};
        print_data(object.dump() + "\n");
        return;
    }
    std::string text = fmt::format("pixel {},{} sample {} seed {}\n", command.replay->x,
                                   command.replay->y, command.replay->sample, scene.render.seed);
    text += fmt::format("depth {} m\n", sample.hit ? fmt::format("{:.9g}", sample.depth) : "-");
    text += "lambda_nm        radiance_W_per_m2_sr_nm  pdf_per_nm\n";
    for (int k = 0; k < packet.count; ++k)
        text += fmt::format("{:<16.9f} {:<24.17g} {:.9g}\n", packet.lambda_nm[k],
                            sample.radiance[k], packet.pdf_per_nm[k]);
    print_data(text);
}

int replay(const RenderCommand& command, const Scene& scene) {
    const Replay& wish = *command.replay;
    if (wish.x >= scene.film.width || wish.y >= scene.film.height)
        throw UsageError(fmt::format("--pixel is {},{}; it must lie in the picture of {}x{} pixels",
                                     wish.x, wish.y, scene.film.width, scene.film.height));
    SessionOptions options;
    options.crop = PixelRect{wish.x, wish.y, wish.x + 1, wish.y + 1};
    FilmSums film = make_film(scene, options);
    film.observe([&](int, int, const PixelSample& sample, std::int64_t) {
        print_sample(command, scene, sample);
    });
    const auto estimator = estimator_of(command).make(scene);
    estimator->render({*options.crop, wish.sample, wish.sample + 1}, film);
    return kDone;
}

// ---- the whole picture -------------------------------------------------------------------------

void warn_of_invalid_samples(const FilmSums& film, const Scene& scene,
                             const SessionResult& result) {
    if (result.invalid_samples == 0) return;
    const InvalidSample first = film.first_invalid().front();
    const ReplayContext context{first.x, first.y, first.index, scene.render.seed};
    print_message(
        fmt::format("warning: {} of {} samples were invalid (not finite, negative or too large); "
                    "the first is {}",
                    result.invalid_samples, result.samples, describe(context)));
}

std::string summary(const SessionResult& result, const std::vector<std::filesystem::path>& paths) {
    const std::string reason = result.reason == StopReason::complete ? ""
                               : result.reason == StopReason::interrupted
                                   ? " (interrupted)"
                                   : " (stopped by --" + to_string(result.reason) + ")";
    return fmt::format("{}: {} samples a pixel in {}{}", joined(paths),
                       samples_text(result.samples_per_pixel),
                       format_duration(std::chrono::duration<double>(result.seconds)), reason);
}

int exit_code(const SessionResult& result) {
    if (result.reason == StopReason::interrupted) return interrupt_exit_code();
    return exit_code_by_samples(result);
}

SessionOptions session_options(const RenderCommand& command) {
    SessionOptions options;
    options.crop = command.crop;
    options.time_limit = command.time_limit;
    options.noise_target = command.noise_target;
    options.progress = command.progress;
    options.title = "render " + std::filesystem::path(command.scene_file).filename().string();
    options.stop = &stop_requested();
    return options;
}

/// For those who make pictures of the state without the scene.
PictureSettings picture_settings(const RenderCommand& command, const Scene& scene) {
    return {std::filesystem::path(command.scene_file).filename().string(),
            scene.render.packet,
            scene.film.white_luminance,
            scene.film.exposure,
            scene.film.exposure_stops,
            command.gamut};
}

void check_crop(const PixelRect& crop, const Film& film) {
    if (crop.x1 <= film.width && crop.y1 <= film.height) return;
    throw UsageError(
        fmt::format("--crop is {},{},{}x{}; it must lie in the picture of {}x{} pixels", crop.x0,
                    crop.y0, crop.width(), crop.height(), film.width, film.height));
}

/// Throws InputError if the picture could not be written there in the end.
void check_output(const std::filesystem::path& path) {
    check_picture_path(path);
    std::error_code error;  // what is not there yet is none; a name that is too long is one
    static_cast<void>(std::filesystem::status(path, error));
    if (error && error != std::errc::no_such_file_or_directory)
        throw InputError(SourcePlace{path.string(), 0, 0, {}}, "cannot write: " + error.message());
}

std::vector<FileLock> lock_outputs(const RenderCommand& command,
                                   std::vector<std::filesystem::path> paths) {
    if (!command.checkpoint.file.empty()) paths.emplace_back(command.checkpoint.file);
    std::vector<FileLock> locks = lock_files(paths);
    for (const FileLock& lock : locks)
        if (!lock.remark().empty() && !command.quiet) print_message(presentable(lock.remark()));
    return locks;
}

/// The pictures are not all written: what was rendered must not be lost.
int keep_after_failure(const std::vector<std::string>& failures, const RenderState& state,
                       CheckpointFile& checkpoint) {
    for (const std::string& failure : failures) print_error(failure);
    if (checkpoint.keep(state)) print_message(checkpoint.way_on());
    return kFailed;
}

void tell_of_exposure(const RenderCommand& command, const Film& film, double stops) {
    if (film.exposure == ExposureMode::fixed || stops == 0.0 || command.quiet) return;
    print_message(
        fmt::format("exposure {:+.2f} stops, chosen by the picture; --exposure 0 "
                    "shows it as its numbers say",
                    stops));
}

int render_picture(const RenderCommand& command, const LoadedScene& loaded,
                   const std::vector<std::filesystem::path>& paths) {
    const Scene& scene = loaded.scene;
    if (command.crop) check_crop(*command.crop, scene.film);
    SessionOptions options = session_options(command);
    check_memory_of(scene, options);
    const EstimatorRow& method = estimator_of(command);
    CheckpointFile checkpoint(command.checkpoint, paths.front());
    options.checkpoints = checkpoint.checkpoints();
    RenderIdentity identity = render_identity(scene, options, method.name, loaded.hash);
    identity.picture = text_of(picture_settings(command, scene));
    RenderState state = checkpoint.begin(std::move(identity));
    const SessionResult result = run_session(*method.make(scene), options, state);
    warn_of_invalid_samples(state.film, scene, result);
    if (result.finished_units == 0) {
        print_message("interrupted before anything was rendered; no picture is written");
        return exit_code(result);
    }
    const bool interrupted = result.reason == StopReason::interrupted;
    const bool kept = interrupted && checkpoint.keep(state);

    DisplaySettings display;
    display.exposure_stops = exposure_of(state.film, scene.film);
    tell_of_exposure(command, scene.film, display.exposure_stops);
    display.gamut = command.gamut;
    const std::string scene_name = std::filesystem::path(command.scene_file).filename().string();
    const std::vector<std::string> failures =
        write_pictures(paths, state.film, scene, display, render_facts(scene, result, scene_name));
    if (!failures.empty()) return keep_after_failure(failures, state, checkpoint);
    if (!interrupted) checkpoint.remove();

    if (!command.quiet) print_message(summary(result, paths));
    if (kept && !command.quiet) print_message(checkpoint.way_on());
    if (command.json) print_json(result, paths, fingerprint());
    return exit_code(result);
}

}  // namespace

int run_render(const RenderCommand& command) {
    set_thread_count(command.threads);
    set_replay_command(replay_command(command));
    if (command.replay) return replay(command, load(command).scene);

    // What would make the render useless at its end is found before it begins.
    const std::vector<std::filesystem::path> paths = output_paths(command);
    for (const std::filesystem::path& path : paths) check_output(path);
    const std::vector<FileLock> locks = lock_outputs(command, paths);
    return render_picture(command, load(command), paths);
}

}  // namespace dewbow
