// SPDX-License-Identifier: Apache-2.0
#pragma once

// scene.toml: the format that people type. docs/scene-format.md is its manual. Every table and key
// is known or an error with line, column, excerpt and the nearest word; every number has a range;
// units stand in keys.
//
//     [camera]           view.h        [materials.NAME]   materials.h      [[lights]]    lights.h
//     [film]             view.h        [[shapes]]         shapes.h         [[imports]]   imports.h
//     [render]           view.h        [surroundings]     glass.h          [[instances]]
//     instances.h

#include <filesystem>

#include "dewbow/import/parsed_scene.h"

namespace dewbow {

/// @param settings  values that are otherwise than in the file (settings.h).
ParsedScene load_toml(const std::filesystem::path& path,
                      const std::vector<std::string>& settings = {});

/// The same of text in memory; `path` is for messages, and its folder holds what the scene refers
/// to.
ParsedScene parse_scene_toml(const std::filesystem::path& path, std::string text,
                             const std::vector<std::string>& settings = {});

/// `guest`, which is what the file `path` holds, as if a scene file imported it that says nothing
/// but `settings`.
ParsedScene with_settings(const std::filesystem::path& path, const ParsedScene& guest,
                          const std::vector<std::string>& settings);

}  // namespace dewbow
