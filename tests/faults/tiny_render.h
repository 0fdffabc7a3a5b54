// SPDX-License-Identifier: Apache-2.0
#pragma once

// Renders of a fraction of a second, and the one question that all faults of output are asked: was
// anything lost, half written or silently wrong?

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "run_program.h"

namespace dewbow::faults {

using Words = std::vector<std::string>;
Words operator+(Words a, const Words& b);

/// The name of a scene of one grey ball, and its text.
inline constexpr const char* kTinyScene = "tiny.toml";
extern const char* const kTinySceneText;

/// A folder in which kTinyScene lies.
struct RenderFolder : Folder {
    RenderFolder() { put(kTinyScene, kTinySceneText); }
};

/// The words of a render of a few milliseconds, but for where it writes to.
Words tiny_render(const Words& more = {});

/// What is in a file; empty if it is not there.
std::string bytes_of(const std::filesystem::path& file);

/// The values of all pixels of a PNG or EXR of ours, as a hash in text; what is wrong with it if it
/// cannot be read; "none" if it is not there.
std::string pixels_of(const std::filesystem::path& picture);
/// The same of bytes; `name` tells the format by its ending.
std::string pixels_of_bytes(const std::string& bytes, const std::string& name);

/// The pixels that tiny_render(more) must have in a file with the ending of `name`: what it renders
/// where nothing is wrong.
std::string true_pixels(const std::string& name, const Words& more = {});

/// What was lost, a line for each; empty if all is well. Each output holds its old bytes or the
/// whole new picture, and after an exit code of 0 the new one; no other file came, went or changed,
/// but for a state that is kept after a failure.
/// @param outputs  names in the folder, with the pixels that they should have.
std::string losses(const std::map<std::string, std::string>& before, const Folder& folder,
                   const Outcome& outcome, const std::map<std::string, std::string>& outputs);

}  // namespace dewbow::faults
