// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures of all that is around, as light.

#include <filesystem>
#include <memory>

#include "dewbow/base/error.h"
#include "dewbow/scene/light.h"

namespace dewbow {

/// Reads an equirectangular .exr (channels R, G, B or Y, linear sRGB) or .hdr (Radiance RGBE).
/// Negative values and those that are not finite count as 0 and are noted. Throws InputError.
std::shared_ptr<ImageEnvironment> load_environment(const std::filesystem::path& path,
                                                   Diagnostics& diagnostics);

}  // namespace dewbow
