// SPDX-License-Identifier: Apache-2.0
#pragma once

// The part of YAML that pages of the refractiveindex.info database are written in: maps and lists
// by indentation, scalars on one line, and blocks of text. No anchors, tags, flow collections or
// directives: a value is what stands there.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dewbow::glass_import {

struct YamlNode {
    enum class Kind { scalar, map, list };
    Kind kind = Kind::scalar;
    std::string text;                                       ///< of a scalar
    std::vector<std::pair<std::string, YamlNode>> entries;  ///< of a map, in the file's order
    std::vector<YamlNode> items;                            ///< of a list
    std::size_t line = 0;

    /// The value of a map's key, or null.
    const YamlNode* find(std::string_view key) const;
};

/// Throws InputError with the place: no map, a line that is neither key nor item, tabs as
/// indentation, deeper than 16 levels.
YamlNode parse_yaml(std::string_view text, const std::string& file);

}  // namespace dewbow::glass_import
