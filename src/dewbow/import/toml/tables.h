// SPDX-License-Identifier: Apache-2.0
#pragma once

// [[name]]: arrays of tables.

#include <functional>

#include "dewbow/import/toml/toml_value.h"

namespace dewbow::toml_import {

/// Calls `read(table, number)` for each, numbered from 1; InputError if `value` is no array of
/// tables. nullptr has none.
void for_each_table(const TomlDocument& document, const TomlValue* value, std::string_view name,
                    const std::function<void(const TomlValue&, std::size_t)>& read);

}  // namespace dewbow::toml_import
