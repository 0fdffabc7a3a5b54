// SPDX-License-Identifier: Apache-2.0
#pragma once

// What there is to say about a rainbow in a few numbers.

#include <string>
#include <vector>

#include "rainbow_tables.h"

namespace dewbow {

std::string summary_text(RainbowTables& tables);
/// One JSON object, with the names of the files that were written.
std::string summary_json(RainbowTables& tables, const std::vector<std::string>& files);

}  // namespace dewbow
