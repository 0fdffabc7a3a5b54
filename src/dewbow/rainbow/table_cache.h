// SPDX-License-Identifier: Apache-2.0
#pragma once

// Tables kept on disk, by what was asked for: a second request for the same takes no time.

#include <filesystem>
#include <string>

#include "dewbow/rainbow/scattering_table.h"

namespace dewbow {

/// $XDG_CACHE_HOME/dewbow, else ~/.cache/dewbow, else nothing (an empty path): no cache.
std::filesystem::path default_cache_directory();

/// 32 hexadecimal digits that depend on all that the table depends on: the request, by the indices
/// at its wavelengths, its drop sizes by their densities, and the version of this program.
std::string cache_key(const TableRequest& request);

struct CachedTable {
    ScatteringTable table;
    bool from_cache = false;
    std::string note;  ///< a file that could not be read or written, and why; empty if all is well
};
/// The table from `directory`, or made and kept there. A file that is broken, or is not one of
/// these (by its checksum and by the key in it), is made anew, with a note. Files are written
/// beside their place and renamed. An empty path: made, and not kept.
/// Throws InputError as make_scattering_table.
CachedTable cached_scattering_table(const TableRequest& request,
                                    const std::filesystem::path& directory);

}  // namespace dewbow
