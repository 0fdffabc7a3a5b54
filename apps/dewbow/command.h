// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the command line asks for, as plain values.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "checkpoint_file.h"
#include "dewbow/base/progress.h"
#include "dewbow/import/import.h"
#include "dewbow/render/estimator_choice.h"
#include "dewbow/render/film.h"
#include "dewbow/spectrum/display.h"
#include "dewbow/spectrum/wavelengths.h"
#include "glass_command.h"
#include "merge_command.h"
#include "rainbow_command.h"
#include "spectrum_command.h"

namespace dewbow {

struct PictureSize {
    int width = 0, height = 0;
};

/// `--pixel X,Y --sample K`: one sample is computed again and shown.
struct Replay {
    int x = 0, y = 0;
    std::int64_t sample = 0;
};

/// `--slice K/N`: unit number (pass · tiles + tile) belongs to slice (number mod N) + 1.
struct Slice {
    std::size_t number = 1, count = 1;
};

/// That of a command which names none.
inline constexpr const char* kDefaultEstimator = "auto";

/// `dewbow render`. What is not set is as the scene says.
struct RenderCommand {
    std::string scene_file;
    LoadOptions load;
    std::vector<std::string> outputs;  ///< empty: the scene's stem with .exr and .png
    std::optional<PictureSize> size;
    std::optional<int> samples_per_pixel;
    std::optional<std::chrono::duration<double>> time_limit;
    std::optional<double> noise_target;
    std::optional<PixelRect> crop;
    std::optional<Slice> slice;
    int threads = 0;  ///< 0 = all
    std::optional<std::uint64_t> seed;
    std::optional<int> packet;
    std::optional<double> exposure_stops;
    bool automatic_exposure = false;
    GamutMapping gamut = DisplaySettings{}.gamut;
    std::optional<int> spectral_bins;
    std::optional<int> max_depth;
    std::optional<WavelengthSampling> wavelengths;
    std::string estimator = kDefaultEstimator;
    std::optional<Replay> replay;
    CheckpointWish checkpoint;
    ProgressStyle progress = ProgressStyle::automatic;
    bool quiet = false;
    bool json = false;
};

/// `dewbow scene check`.
struct SceneCheckCommand {
    std::string scene_file;
    LoadOptions load;
    bool json = false;
};

/// Help or version: to be printed, and that is all.
struct ShowText {
    std::string text;
};

using Command = std::variant<ShowText, RenderCommand, SceneCheckCommand, GlassCommand,
                             RainbowCommand, SpectrumCommand, MergeCommand>;

/// Throws UsageError.
Command parse_command_line(int argc, const char* const* argv);

// Each subcommand returns the program's exit code.
int run_render(const RenderCommand& command);
int run_scene_check(const SceneCheckCommand& command);

// Exit codes; interrupted programs return 128 + the signal's number.
inline constexpr int kDone = 0;
inline constexpr int kFailed = 1;
inline constexpr int kUsedWrongly = 2;
inline constexpr int kTooManyInvalid = 3;

}  // namespace dewbow
