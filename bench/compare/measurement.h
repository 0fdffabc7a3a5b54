// SPDX-License-Identifier: Apache-2.0
#pragma once

// Who runs against whom, and what came out.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "child_process.h"
#include "contestant.h"
#include "picture_errors.h"
#include "scene_references.h"

namespace dewbow::bench {

struct Plan {
    std::vector<int> samples_per_pixel = {1, 4, 16, 64, 256, 1024};  ///< of who does not split
    std::vector<int> spectral_samples = {7, 13, 31, 100};            ///< of who splits,
    std::vector<int> split_samples_per_pixel = {1, 4, 9};            ///< each with each of these
    int repeats = 3;
    int threads = 1;
    double most_cpu_s = 60.0;  ///< a run that would take longer, by those before it, is left out
    bool with_limits = true;   ///< render limits, and compare with them
    ReferenceSettings references;
};

/// Errors over one mask.
struct MaskErrors {
    std::string mask;
    PictureErrors truth;
    std::optional<PictureErrors> limit;  ///< against the contestant's own limit
};

/// One picture that was made.
struct Run {
    std::string scene, contestant;
    Knobs knobs;
    int repeat = 0;
    ChildUsage usage;
    double load = 0.0;  ///< load average of the machine when it began
    std::vector<MaskErrors> errors{};
    Colour<LinearSrgb> card{};  ///< mean where the white card is seen, or the mean of the caustic
                                ///< over that of the truth: (1, 1, 1) if brightness is right
};

/// All repeats of one contestant with one setting; medians.
struct Result {
    std::string scene, contestant;
    Knobs knobs;
    double cpu_s = 0.0, wall_s = 0.0, memory_MiB = 0.0;
    double start_up_cpu_s = 0.0;  ///< of the same contestant and scene
    std::vector<MaskErrors> errors{};
    Colour<LinearSrgb> card{};
    Picture picture{};  ///< of the first repeat

    /// CPU time without start-up; at least a thousandth of a second, so that it has a logarithm.
    double work_cpu_s() const;
    const MaskErrors& over(const std::string& mask) const;
};

struct SceneFacts {
    std::string name;
    Picture truth;
    PictureErrors truth_own;                   ///< error of the truth itself, whole picture
    std::map<std::string, double> mask_share;  ///< share of the pixels
    std::map<std::string, PictureErrors>
        limit_error;                    ///< by limit_name: the limit against the truth
    std::vector<std::string> left_out;  ///< runs that would have taken too long or failed, in words

    /// Whether it has a mask "caustic".
    bool has_caustics() const { return mask_share.count("caustic") != 0; }
};

struct Measurements {
    std::vector<SceneFacts> scenes;
    std::vector<Run> runs;
    std::vector<Result> results;
    std::map<std::string, std::string> versions;  ///< by contestant
};

using ContestantPtr = std::unique_ptr<Contestant>;

/// Runs all contestants on all scenes. They take turns, from few samples to many, and every other
/// repeat in reverse, so that what else the machine does falls on all. `say` is told what is going
/// on.
Measurements measure(const std::vector<BenchScene>& scenes,
                     const std::vector<ContestantPtr>& contestants, const Plan& plan,
                     const std::function<void(const std::string&)>& say);

/// "path, 64 spp" or "povray, N 31, 4 spp".
std::string label_of(const std::string& contestant, const Knobs& knobs);

/// A scene of the benchmark with a film of that size. Throws InputError.
BenchScene load_bench_scene(const std::filesystem::path& file, int width, int height);

}  // namespace dewbow::bench
