// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures are written, and what was done is told: for all subcommands that end in a picture.

#include <filesystem>
#include <string>
#include <vector>

#include "dewbow/render/farm/team.h"
#include "dewbow/render/output.h"

namespace dewbow {

/// Writes what can be written; returns the messages of what cannot.
std::vector<std::string> write_pictures(const std::vector<std::filesystem::path>& paths,
                                        const FilmSums& film, const Scene& scene,
                                        const DisplaySettings& display, const Attributes& facts);

/// "ring.exr, ring.png"
std::string joined(const std::vector<std::filesystem::path>& paths);

/// "16", "2.50"
std::string samples_text(double samples_per_pixel);

/// "light paths: 64.1 % bring light to the picture, 1.2 % before learning from 61440"
std::string light_paths_text(const LightPathReport& report);

/// @param fingerprint  of the program that rendered.  @param light_paths  if it traced any.  @param
/// team  if it had several ranks
void print_json(const SessionResult& result, const std::vector<std::filesystem::path>& paths,
                const std::string& fingerprint,
                const std::optional<LightPathReport>& light_paths = std::nullopt,
                const TeamReport* team = nullptr);

/// kDone or kTooManyInvalid.
int exit_code_by_samples(const SessionResult& result);

}  // namespace dewbow
