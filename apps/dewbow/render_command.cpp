// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "checkpoint_file.h"
#include "command.h"
#include "console.h"
#include "dewbow/base/check.h"
#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/base/file_lock.h"
#include "dewbow/base/parallel.h"
#include "dewbow/render/exposure.h"
#include "dewbow/render/farm/team.h"
#include "dewbow/render/output.h"
#include "dewbow/render/session.h"
#include "interrupt.h"
#include "picture_report.h"
#include "render_ranks.h"
#include "render_setup.h"

namespace dewbow {

namespace {

std::vector<std::filesystem::path> output_paths(const RenderCommand& command) {
    if (!command.outputs.empty()) return {command.outputs.begin(), command.outputs.end()};
    const std::filesystem::path stem = std::filesystem::path(command.scene_file).stem();
    if (command.slice)
        return {fmt::format("{}.slice-{}-of-{}{}", stem.string(), command.slice->number,
                            command.slice->count, kStateExtension)};
    std::vector<std::filesystem::path> paths;
    for (const std::string& extension : picture_extensions())
        paths.push_back(stem.string() + extension);
    return paths;
}

// ---- one sample --------------------------------------------------------------------------------

/// JSON knows no NaN and no infinity: such a number becomes its name.
nlohmann::ordered_json json_number(double value) {
    if (std::isfinite(value)) return value;
    return fmt::format("{}", value);
}

nlohmann::ordered_json sample_as_json(const PixelSample& sample) {
    if (sample.colour) {
        nlohmann::ordered_json xyz = nlohmann::ordered_json::array();
        for (const double value : sample.colour->v) xyz.push_back(json_number(value));
        return {{"xyz", xyz}};
    }
    const WavelengthPacket& packet = sample.wavelengths;
    nlohmann::ordered_json lanes = nlohmann::ordered_json::array();
    for (int k = 0; k < packet.count; ++k)
        lanes.push_back({{"lambda_nm", json_number(packet.lambda_nm[k])},
                         {"pdf_per_nm", json_number(packet.pdf_per_nm[k])},
                         {"radiance_W_per_m2_sr_nm", json_number(sample.radiance[k])}});
    return {{"lanes", lanes}};
}

std::string sample_as_text(const PixelSample& sample) {
    if (sample.colour)
        return fmt::format("XYZ {:.17g} {:.17g} {:.17g}\n", (*sample.colour)[0],
                           (*sample.colour)[1], (*sample.colour)[2]);
    const WavelengthPacket& packet = sample.wavelengths;
    std::string text = "lambda_nm        radiance_W_per_m2_sr_nm  pdf_per_nm\n";
    for (int k = 0; k < packet.count; ++k)
        text += fmt::format("{:<16.9f} {:<24.17g} {:.9g}\n", packet.lambda_nm[k],
                            sample.radiance[k], packet.pdf_per_nm[k]);
    return text;
}

void print_sample(const RenderCommand& command, const Scene& scene, const PixelSample& sample) {
    if (command.json) {
        nlohmann::ordered_json object{{"pixel", {command.replay->x, command.replay->y}},
                                      {"sample", command.replay->sample},
                                      {"seed", scene.render.seed},
                                      {"depth_m", json_number(sample.depth)}};
        object.update(sample_as_json(sample));
        print_data(object.dump() + "\n");
        return;
    }
    const std::string depth = sample.hit ? fmt::format("{:.9g}", sample.depth) : "-";
    print_data(fmt::format("pixel {},{} sample {} seed {}\ndepth {} m\n", command.replay->x,
                           command.replay->y, command.replay->sample, scene.render.seed, depth) +
               sample_as_text(sample));
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
    estimator_of(command, scene)
        .estimator->render({*options.crop, wish.sample, wish.sample + 1}, film);
    return kDone;
}

// ---- the whole picture -------------------------------------------------------------------------

void warn_of_invalid_samples(const FilmSums& film, const Scene& scene,
                             const SessionResult& result) {
    const InvalidSamples invalid = film.invalid();
    if (invalid.splats > 0)
        print_message(
            fmt::format("warning: {} contributions of light paths were invalid (not finite, "
                        "negative or too large)",
                        invalid.splats));
    if (invalid.count == 0) return;
    const InvalidSample first = invalid.first.front();
    const ReplayContext context{first.x, first.y, first.index, scene.render.seed};
    print_message(
        fmt::format("warning: {} of {} samples were invalid (not finite, negative or too large); "
                    "the first is {}",
                    invalid.count, result.samples, describe(context)));
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

/// Throws InputError if the picture could not be written there in the end.
void check_output(const std::filesystem::path& path) {
    if (path.extension() == kStateExtension)
        check_writable(path);
    else
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

/// The units of one slice: every `count`-th, so that slices cost about the same.
std::function<bool(std::size_t, std::size_t)> units_of(const Slice& slice,
                                                       std::size_t units_per_pass) {
    return [slice, units_per_pass](std::size_t pass, std::size_t number) {
        return (pass * units_per_pass + number) % slice.count == slice.number - 1;
    };
}

/// A slice is no picture: its state is written, for `dewbow merge`.
int write_slice(const RenderCommand& command, const std::vector<std::filesystem::path>& paths,
                const RenderState& state, const SessionResult& result, CheckpointFile& checkpoint) {
    if (result.reason == StopReason::interrupted) {
        if (!checkpoint.keep(state)) throw InputError("interrupted; nothing of the slice is kept");
        if (!command.quiet) print_message(checkpoint.way_on());
        return exit_code(result);
    }
    std::vector<std::string> failures;
    for (const std::filesystem::path& path : paths) {
        try {
            write_file_atomically(path, [&](const ByteSink& sink) { write_state(state, sink); });
        } catch (const InputError& error) {
            failures.push_back(error.what());
        }
    }
    if (!failures.empty()) return keep_after_failure(failures, state, checkpoint);
    checkpoint.remove();
    if (!command.quiet)
        print_message(
            presentable(fmt::format("{}: slice {} of {}, {} of {} units, for dewbow merge",
                                    joined(paths), command.slice->number, command.slice->count,
                                    result.finished_units, result.planned_units)));
    if (command.json) print_json(result, paths, fingerprint());
    return exit_code(result);
}

const TeamReport* rank_report(const Team* team) { return team ? &team->report() : nullptr; }

/// @param ranks,team  the other ranks, or nullptr
int render_picture(const RenderCommand& command, const LoadedScene& loaded,
                   const std::vector<std::filesystem::path>& paths, Ranks* ranks, Team* team) {
    const Scene& scene = loaded.scene;
    if (command.crop) check_crop(*command.crop, scene.film);
    SessionOptions options = session_options(command);
    const EstimatorChoice chosen = estimator_of(command, scene);
    const Estimator& estimator = *chosen.estimator;
    check_memory_of(scene, options, estimator);
    CheckpointFile checkpoint(command.checkpoint, paths.front());
    options.checkpoints = checkpoint.checkpoints();
    options.team = team;
    RenderState state = checkpoint.begin(identity_of(command, loaded, options, chosen));
    if (command.slice) options.selects = units_of(*command.slice, state.plan.units_per_pass());
    const SessionResult result = run_session(estimator, options, state);
    if (ranks && team->all_have_left()) ranks->close();
    warn_of_invalid_samples(state.film, scene, result);
    if (command.slice) return write_slice(command, paths, state, result, checkpoint);
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
    const std::vector<std::string> failures =
        write_pictures(paths, state.film, scene, display,
                       render_facts(scene, state.identity, result, scene_name(command)));
    if (!failures.empty()) return keep_after_failure(failures, state, checkpoint);
    if (!interrupted) checkpoint.remove();

    const std::optional<LightPathReport> light_paths = estimator.light_path_report();
    if (!command.quiet) print_message(summary(result, paths));
    if (!command.quiet && light_paths) print_message(light_paths_text(*light_paths));
    if (kept && !command.quiet) print_message(checkpoint.way_on());
    if (command.json) print_json(result, paths, fingerprint(), light_paths, rank_report(team));
    return exit_code(result);
}

/// @param ranks,team  the other ranks, or nullptr
int render(const RenderCommand& command, Ranks* ranks, Team* team) {
    if (ranks && command.slice)
        throw UsageError(
            "--slice is for machines that do not know each other; ranks share the "
            "whole picture");
    // What would make the render useless at its end is found before it begins.
    const std::vector<std::filesystem::path> paths = output_paths(command);
    for (const std::filesystem::path& path : paths) check_output(path);
    const std::vector<FileLock> locks = lock_outputs(command, paths);
    return render_picture(command, load(command), paths, ranks, team);
}

}  // namespace

int run_render(const RenderCommand& command) {
    set_thread_count(command.threads);
    set_replay_command(replay_command(command));
    if (command.replay) return replay(command, load(command).scene);
    const std::unique_ptr<Ranks> ranks = open_ranks();
    if (!ranks) return render(command, nullptr, nullptr);
    if (ranks->transport().rank() > 0) return work_as_other_rank(command, *ranks);
    return render_as_rank_0(*ranks,
                            [&](Team& team) { return render(command, ranks.get(), &team); });
}

}  // namespace dewbow
