// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "report.h"

namespace dewbow::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PictureErrors& errors) {
    Json json;
    for (const ErrorKind& kind : error_kinds()) json[kind.name] = errors.*kind.value;
    return json;
}

Json json_of(const Run& run) {
    Json json = {{"record", "run"},
                 {"scene", run.scene},
                 {"contestant", run.contestant},
                 {"spectral_samples", run.knobs.spectral_samples},
                 {"samples_per_pixel", run.knobs.samples_per_pixel},
                 {"repeat", run.repeat},
                 {"seed", run.knobs.seed},
                 {"cpu_s", run.usage.cpu_s},
                 {"wall_s", run.usage.wall_s},
                 {"peak_memory_MiB", run.usage.peak_memory_MiB},
                 {"load_average", run.load},
                 {"card", run.card.v}};
    for (const MaskErrors& errors : run.errors) {
        json["errors"][errors.mask]["truth"] = json_of(errors.truth);
        if (errors.limit) json["errors"][errors.mask]["own_limit"] = json_of(*errors.limit);
    }
    return json;
}

Json json_of(const SceneFacts& scene) {
    Json json = {{"record", "scene"},
                 {"scene", scene.name},
                 {"width", scene.truth.width},
                 {"height", scene.truth.height},
                 {"truth_own_errors", json_of(scene.truth_own)},
                 {"mask_share", scene.mask_share},
                 {"left_out", scene.left_out}};
    for (const auto& [contestant, errors] : scene.limit_error)
        json["limit_against_truth"][contestant] = json_of(errors);
    return json;
}

Json json_of(const Result& result) {
    return {{"record", "start-up"},
            {"scene", result.scene},
            {"contestant", result.contestant},
            {"cpu_s", result.start_up_cpu_s}};
}

}  // namespace

std::string json_lines_of(const Measurements& all, const Plan& plan, const Circumstances& where) {
    const Json head = {{"record", "circumstances"},
                       {"processor", where.machine.processor},
                       {"hardware_threads", where.machine.threads},
                       {"memory_GiB", where.machine.memory_GiB},
                       {"system", where.machine.system},
                       {"time", where.machine.time},
                       {"command", where.command},
                       {"load_before", where.load_before},
                       {"load_after", where.load_after},
                       {"threads", plan.threads},
                       {"repeats", plan.repeats},
                       {"versions", all.versions},
                       {"absent", where.absent}};
    std::string text = head.dump() + '\n';
    for (const SceneFacts& scene : all.scenes) text += json_of(scene).dump() + '\n';
    std::string last;
    for (const Result& result : all.results) {
        if (result.scene + result.contestant != last) text += json_of(result).dump() + '\n';
        last = result.scene + result.contestant;
    }
    for (const Run& run : all.runs) text += json_of(run).dump() + '\n';
    return text;
}

}  // namespace dewbow::bench
