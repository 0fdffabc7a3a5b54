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

ParsedScene load_toml(const std::filesystem::path& path);

/// The same of text in memory; `path` is for messages, and its folder holds what the scene refers
/// to.
ParsedScene parse_scene_toml(const std::filesystem::path& path, std::string text);

}  // namespace dewbow
