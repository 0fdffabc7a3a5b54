// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/rain_settings.h"

#include <array>

namespace dewbow::toml_import {

namespace {

const std::array<std::string, 1> kOrderWords = {"all"};

}  // namespace

void read_rain_settings(const TomlDocument& document, const TomlValue* value,
                        RainSettings& settings) {
    if (!value) return;
    Table table(document, *value, "[render.rain]");
    const TomlValue* orders = table.find("orders");
    if (orders && orders->text()) {
        read_choice(document, *orders, "orders", kOrderWords);
        settings.orders = RainSettings::kAllOrders;
    } else if (orders) {
        settings.orders = int(read_integer(document, *orders, "orders", 1, kMostRainOrders));
    }
    table.finish();
}

}  // namespace dewbow::toml_import
