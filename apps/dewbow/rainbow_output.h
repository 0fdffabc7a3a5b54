// SPDX-License-Identifier: Apache-2.0
#pragma once

// What `dewbow rainbow -o FILE` writes, by the file's ending.

#include <string>
#include <vector>

#include "rainbow_tables.h"

namespace dewbow {

const std::vector<std::string>& rainbow_output_endings();
/// ".csv, the curve; …" for help.
std::string rainbow_outputs_described();
/// The bytes of `file`. Throws InputError.
std::string rainbow_output(const std::string& file, RainbowTables& tables);

/// ".svg" of "A.SVG".
std::string ending_of(const std::string& file);

}  // namespace dewbow
