// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/rain_settings.h"

#include <fmt/format.h>

namespace dewbow {

std::string text_of(const RainSettings& settings) {
    return settings.orders == RainSettings::kAllOrders
               ? std::string("rain orders all")
               : fmt::format("rain orders {}", settings.orders);
}

}  // namespace dewbow
