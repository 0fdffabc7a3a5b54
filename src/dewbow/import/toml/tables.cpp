// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/tables.h"

#include <fmt/format.h>

#include "dewbow/import/toml/typed.h"

namespace dewbow::toml_import {

void for_each_table(const TomlDocument& document, const TomlValue* value, std::string_view name,
                    const std::function<void(const TomlValue&, std::size_t)>& read) {
    if (!value) return;
    const TomlValue::Array* array = value->array();
    if (!array) {
        fail(document, value->place,
             fmt::format("{} is {}; expected tables", name, describe(*value)),
             fmt::format("write [[{}]] above each", name));
    }
    for (std::size_t i = 0; i < array->size(); ++i) read((*array)[i], i + 1);
}

}  // namespace dewbow::toml_import
