// SPDX-License-Identifier: Apache-2.0
#pragma once

// Monitors that a spectrum can be shown on, by the chromaticities of their phosphors.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/spectrum/rgb.h"

namespace dewbow {

/// A row of the registry. `primaries.name` is the name that options and scene files use.
struct MonitorRow {
    RgbPrimaries primaries;
    std::string_view source;
};
std::span<const MonitorRow> monitors();
/// Their names, in the same order.
const std::vector<std::string>& monitor_names();
/// Throws InputError with the nearest right word.
const MonitorRow& find_monitor(std::string_view name);

}  // namespace dewbow
