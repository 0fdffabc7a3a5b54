// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/caustics_settings.h"

#include <fmt/format.h>

namespace dewbow {

std::string text_of(const CausticsSettings& settings) {
    return fmt::format("light paths {}, aimed {}", settings.light_paths, settings.aimed);
}

}  // namespace dewbow
