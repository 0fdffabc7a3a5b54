// SPDX-License-Identifier: Apache-2.0
#pragma once

// A TOML table that is being read. Every key that is asked for is known; what stands in the file
// beyond those is an error, so that a slip of the finger never changes a picture silently.

#include "dewbow/base/quantity.h"
#include "dewbow/import/toml/typed.h"

namespace dewbow::toml_import {

class Table {
public:
    /// @param title  what to call it in messages: "[camera]", "the spectrum of reflectance".
    /// Throws InputError if `value` is no table.
    Table(const TomlDocument& document, const TomlValue& value, std::string title);

    const TomlDocument& document() const { return document_; }
    const std::string& title() const { return title_; }
    TomlPlace place() const { return place_; }

    /// The value of `key`, or nullptr.
    const TomlValue* find(std::string_view key);
    /// The value of `key`, or InputError "… needs `key`".
    const TomlValue& require(std::string_view key);

    std::optional<double> find_number(std::string_view key, const Range& range);
    double number(std::string_view key, const Range& range, double otherwise);
    double require_number(std::string_view key, const Range& range);
    std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high,
                         std::int64_t otherwise);
    bool boolean(std::string_view key, bool otherwise);
    std::string text(std::string_view key, std::string_view otherwise);
    /// Sets `value` to the enumerator whose word stands at `key`, if one does.
    /// @param words  in the order of the enumerators.
    template <class Enum>
    void word(std::string_view key, std::span<const std::string> words, Enum& value) {
        if (const TomlValue* found = find(key))
            value = static_cast<Enum>(read_choice(document_, *found, key, words));
    }

    /// A length > 0 from `stem`_m, `stem`_cm or `stem`_mm.
    std::optional<Length> find_length(std::string_view stem);
    Length require_length(std::string_view stem);
    /// A point in metres from `stem` or `stem`_m (metres), `stem`_cm or `stem`_mm.
    std::optional<Vec3> find_point(std::string_view stem);
    Vec3 require_point(std::string_view stem);

    /// Throws if more than one of `keys` is there.
    void at_most_one_of(std::initializer_list<std::string_view> keys);
    /// Throws InputError at the first key that nobody asked for.
    void finish() const;
    /// InputError at this table: "`title` `sentence`".
    [[noreturn]] void fail_here(const std::string& sentence, const std::string& hint = {}) const;
    /// fail_here, or at a key that nobody asked for and that is near to one of `keys`, which are
    /// missing.
    [[noreturn]] void fail_missing(std::vector<std::string> keys,
                                   const std::string& sentence) const;

private:
    const TomlEntry* find_entry(std::string_view key);
    const TomlEntry* find_suffixed(std::string_view stem,
                                   std::span<const std::string_view> suffixes);

    const TomlDocument& document_;
    const TomlValue::Table& entries_;
    TomlPlace place_;
    std::string title_;
    std::vector<std::string> known_;
};

}  // namespace dewbow::toml_import
