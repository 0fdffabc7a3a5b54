// SPDX-License-Identifier: Apache-2.0
#include "picture_report.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "console.h"
#include "dewbow/base/error.h"

namespace dewbow {

namespace {

/// The share of invalid samples above which a picture is not to be trusted.
constexpr double kAllowedInvalidShare = 1e-6;

/// A slice is finished, and yet no picture.
bool is_complete(const SessionResult& result) {
    return result.reason == StopReason::time || result.reason == StopReason::noise ||
           result.finished_units == result.planned_units;
}

nlohmann::ordered_json json_of(const TeamReport& team) {
    return {{"units_of_rank", team.units_of_rank},
            {"lost_ranks", team.lost_ranks},
            {"leases_dealt_again", team.leases_dealt_again},
            {"results", team.results},
            {"result_bytes", team.result_bytes},
            {"coordinating_seconds", team.coordinating_seconds},
            {"rendering_seconds", team.rendering_seconds}};
}

nlohmann::ordered_json json_of(const LightPathReport& report) {
    return {{"traced_to_learn", report.traced},
            {"arrived_at_first", report.arrived_at_first},
            {"arrived_at_last", report.arrived_at_last}};
}

}  // namespace

std::vector<std::string> write_pictures(const std::vector<std::filesystem::path>& paths,
                                        const FilmSums& film, const Scene& scene,
                                        const DisplaySettings& display, const Attributes& facts) {
    std::vector<std::string> failures;
    for (const std::filesystem::path& path : paths) {
        try {
            write_picture(path, film, scene, display, facts);
        } catch (const InputError& error) {
            failures.push_back(error.what());
        } catch (const std::bad_alloc&) {
            failures.push_back(path.string() + ": there is not memory enough to write it");
        }
    }
    return failures;
}

std::string joined(const std::vector<std::filesystem::path>& paths) {
    std::string text;
    for (const std::filesystem::path& path : paths)
        text += (text.empty() ? "" : ", ") + path.string();
    return text;
}

std::string samples_text(double samples_per_pixel) {
    return std::floor(samples_per_pixel) == samples_per_pixel
               ? fmt::format("{:.0f}", samples_per_pixel)
               : fmt::format("{:.2f}", samples_per_pixel);
}

std::string light_paths_text(const LightPathReport& report) {
    return fmt::format(
        "light paths: {:.3g} % bring light to the picture, {:.3g} % before learning from {}",
        100.0 * report.arrived_at_last, 100.0 * report.arrived_at_first, report.traced);
}

void print_json(const SessionResult& result, const std::vector<std::filesystem::path>& paths,
                const std::string& fingerprint, const std::optional<LightPathReport>& light_paths,
                const TeamReport* team) {
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    for (const std::filesystem::path& path : paths) files.push_back(path.string());
    nlohmann::ordered_json object{
        {"files", files},
        {"samples_per_pixel", result.samples_per_pixel},
        {"samples", result.samples},
        {"seconds", result.seconds},
        {"complete", is_complete(result)},
        {"reason", to_string(result.reason)},
        {"invalid_samples", result.invalid_samples},
        {"fingerprint", fingerprint},
        {"film_hash", fmt::format("{:016x}", result.film_hash)},
    };
    if (result.light_paths > 0) object["light_paths"] = result.light_paths;
    if (light_paths) object["light_paths"] = json_of(*light_paths);
    if (team) object["ranks"] = json_of(*team);
    // A file's name need not be UTF-8.
    print_data(object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

int exit_code_by_samples(const SessionResult& result) {
    const double allowed = kAllowedInvalidShare * static_cast<double>(result.samples);
    return static_cast<double>(result.invalid_samples) > allowed ? kTooManyInvalid : kDone;
}

}  // namespace dewbow
