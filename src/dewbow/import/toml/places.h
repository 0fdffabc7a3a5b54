// SPDX-License-Identifier: Apache-2.0
#pragma once

// Many places of one thing, in few words: `positions` = [[x, y, z], …] (or positions_cm, _mm), or
// `file`, a table with one place a line:
//
//     x, y, z[, rotate_y_deg[, scale]]       in metres; also between spaces, tabs or semicolons
//
// Empty lines and those that begin with # are passed over, and so is a first line without a number.

#include <filesystem>

#include "dewbow/import/toml/table.h"
#include "dewbow/math/transform.h"

namespace dewbow::toml_import {

struct Place {
    Vec3 position;
    float rotate_y_deg = 0.0f, scale = 1.0f;

    /// Scaled, turned, moved.
    Affine affine() const;
};

/// The places that the table states; one, at the origin, where it states none. Files lie in
/// `folder`.
std::vector<Place> read_places(Table& table, const std::filesystem::path& folder);

/// @param file  name for messages.
/// Throws InputError with line and excerpt.
std::vector<Place> parse_places(const std::string& file, std::string_view text);

}  // namespace dewbow::toml_import
