// SPDX-License-Identifier: Apache-2.0
#pragma once

// Glasses of other people's files: Zemax glass catalogues (.agf) and pages of the refractiveindex
// .info database (.yml).

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/optics/glass.h"

namespace dewbow {

struct GlassFile {
    std::vector<Glass> glasses;  ///< those that can be used
    Diagnostics notes;           ///< each trap that was found, and each glass that cannot be used
};

/// The glasses of a file, by its extension. Throws InputError where it is none, is larger than
/// 64 MiB, or holds no glass that can be used.
GlassFile load_glass_file(const std::filesystem::path& path);

/// Whether `reference` is "FILE.agf", "FILE.yml" or "FILE.yaml", with "#NAME" or without.
bool is_glass_file_reference(std::string_view reference);
/// The file and the name of such a reference; the name may be empty.
struct GlassReference {
    std::string file, name;
};
GlassReference split_glass_reference(std::string_view reference);

/// The glass of that name in the file, or its only one if `name` is empty. Throws InputError as
/// load_glass_file, and where the name is unknown or missing. `notes`, if it is not null, gets what
/// was noted about this glass.
Glass load_glass(const std::filesystem::path& path, const std::string& name,
                 Diagnostics* notes = nullptr);

}  // namespace dewbow
