// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "dewbow/base/parse_number.h"
#include "dewbow/import/toml/typed.h"

namespace dewbow::toml_import {
namespace {

/// Keys of a scene file that hold [[arrays of tables]].
constexpr std::array<std::string_view, 5> kArrays = {"shapes", "lights", "imports", "instances",
                                                     "rain"};

/// The first '=' that stands outside quotes.
std::size_t find_equals(std::string_view text) {
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quote) {
            if (text[i] == quote) quote = 0;
        } else if (text[i] == '"' || text[i] == '\'') {
            quote = text[i];
        } else if (text[i] == '=') {
            return i;
        }
    }
    return std::string_view::npos;
}

/// Gives `value` and all in it the place `place`.
void stamp(TomlValue& value, TomlPlace place) {
    value.place = place;
    if (auto* array = std::get_if<TomlValue::Array>(&value.value))
        for (TomlValue& item : *array) stamp(item, place);
    if (auto* table = std::get_if<TomlValue::Table>(&value.value)) {
        for (TomlEntry& entry : *table) {
            entry.key_place = place;
            stamp(entry.value, place);
        }
    }
}

TomlEntry* find_entry(TomlValue::Table& table, std::string_view key) {
    const auto found = std::find_if(table.begin(), table.end(),
                                    [&](const TomlEntry& entry) { return entry.key == key; });
    return found == table.end() ? nullptr : &*found;
}

/// The `name` of an entry of an array, or nullptr.
const std::string* name_of(const TomlValue& item) {
    if (!item.table()) return nullptr;
    for (const TomlEntry& entry : *item.table())
        if (entry.key == "name") return entry.value.text();
    return nullptr;
}

class Setting {
public:
    /// @param number  of the setting, from 1.
    Setting(TomlDocument& document, std::size_t number)
        : document_(document), text_(document.settings[number - 1]) {
        place_.setting = number;
    }

    void apply() {
        const std::size_t equals = find_equals(text_);
        if (equals == std::string::npos || equals == 0) refuse("expected PATH=VALUE");
        keys_ = parse_keys(text_.substr(0, equals));
        TomlValue value = parse_value(text_.substr(equals + 1));
        stamp(value, place_);
        TomlValue* at = &document_.root;
        for (depth_ = 0; depth_ + 1 < keys_.size(); ++depth_) at = &child(*at);
        child(*at) = std::move(value);
    }

private:
    [[noreturn]] void refuse(const std::string& sentence, const std::string& hint = {}) const {
        fail(document_, place_, sentence, hint);
    }

    /// TOML's own reader knows what a dotted key is.
    std::vector<std::string> parse_keys(const std::string& text) const {
        std::vector<std::string> keys;
        try {
            const TomlDocument parsed = parse_toml("--set", text + "=0");
            for (const TomlValue* at = &parsed.root; at->table();
                 at = &at->table()->front().value) {
                if (at->table()->size() != 1) refuse("the path is not one key");
                keys.push_back(at->table()->front().key);
            }
        } catch (const UsageError&) {
            throw;
        } catch (const InputError&) {
            refuse(fmt::format("\"{}\" is no path", text), "a path is written like film.width");
        }
        return keys;
    }

    TomlValue parse_value(const std::string& text) const {
        try {
            TomlDocument parsed = parse_toml("--set", "value=" + text);
            auto& root = std::get<TomlValue::Table>(parsed.root.value);
            if (root.size() == 1) return std::move(root.front().value);
        } catch (const InputError&) {  // told below, in the command line's words
        }
        refuse(fmt::format("\"{}\" is no value of TOML", text),
               fmt::format("strings stand in quotes: --set '{}=\"{}\"'",
                           text_.substr(0, find_equals(text_)), text));
    }

    std::string path() const {
        std::string text;
        for (std::size_t i = 0; i < depth_; ++i) text += (i == 0 ? "" : ".") + keys_[i];
        return text;
    }

    /// The value under `parent` by the key at depth_, made if it is not there.
    TomlValue& child(TomlValue& parent) {
        if (auto* table = std::get_if<TomlValue::Table>(&parent.value)) return child(*table);
        if (auto* array = std::get_if<TomlValue::Array>(&parent.value)) return child(*array);
        refuse(fmt::format("{} is {}: there is nothing in it", path(), describe(parent)));
    }

    TomlValue& child(TomlValue::Table& table) {
        const std::string& key = keys_[depth_];
        if (TomlEntry* entry = find_entry(table, key)) return entry->value;
        table.push_back({key, place_, {TomlValue::Table{}, place_}});
        const bool is_array = depth_ == 0 && keys_.size() > 1 &&
                              std::find(kArrays.begin(), kArrays.end(), key) != kArrays.end();
        if (is_array) table.back().value.value = TomlValue::Array{};
        return table.back().value;
    }

    TomlValue& child(TomlValue::Array& array) {
        const std::string& key = keys_[depth_];
        std::vector<std::string> names;
        for (TomlValue& item : array) {
            const std::string* name = name_of(item);
            if (!name) continue;
            if (*name == key) return item;
            names.push_back(*name);
        }
        const auto number = parse_number<std::size_t>(key);
        if (number && *number >= 1 && *number <= array.size()) return array[*number - 1];
        if (number && *number == array.size() + 1) {
            array.push_back({TomlValue::Table{}, place_});
            return array.back();
        }
        const std::string nearest = nearest_word(key, names);
        refuse(fmt::format("{} has {} entries, none of which is \"{}\"", path(), array.size(), key),
               nearest.empty() ? "they are counted from 1, or found by their name"
                               : fmt::format("did you mean \"{}\"?", nearest));
    }

    TomlDocument& document_;
    const std::string& text_;
    TomlPlace place_;
    std::vector<std::string> keys_;
    std::size_t depth_ = 0;
};

}  // namespace

void apply_settings(TomlDocument& document, const std::vector<std::string>& settings) {
    document.settings = settings;
    for (std::size_t i = 1; i <= settings.size(); ++i) Setting(document, i).apply();
}

}  // namespace dewbow::toml_import
