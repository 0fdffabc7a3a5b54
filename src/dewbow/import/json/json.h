// SPDX-License-Identifier: Apache-2.0
#pragma once

// A place in a JSON document that knows where it is: what is read from it is checked, and errors
// carry its JSON pointer.

#include <cstdint>
#include <optional>

#include "dewbow/base/error.h"
#include "dewbow/import/json/json_value.h"
#include "dewbow/import/range.h"
#include "dewbow/math/vector.h"

namespace dewbow {

class Json {
public:
    /// The document itself. `file` and `value` must outlive this and all that is found in it.
    Json(const std::string& file, const JsonValue& value) : file_(&file), value_(&value) {}

    /// "/materials/3/name", or empty for the document.
    const std::string& pointer() const { return pointer_; }
    SourcePlace place() const { return {*file_, 0, 0, pointer_}; }
    [[noreturn]] void fail(const std::string& sentence, const std::string& hint = {}) const;

    /// The member of an object (the last of that key), or nothing. InputError if this is no object.
    std::optional<Json> find(std::string_view key) const;
    Json require(std::string_view key) const;
    std::vector<std::string> keys() const;
    bool is_text() const { return std::holds_alternative<std::string>(value_->value); }
    bool is_object() const { return std::holds_alternative<JsonValue::Object>(value_->value); }

    /// Length of an array. InputError if this is none.
    std::size_t size() const;
    Json operator[](std::size_t index) const;

    double number(const Range& range) const;
    /// A whole number from 0 to `most`.
    std::uint64_t whole(std::uint64_t most) const;
    bool boolean() const;
    const std::string& text() const;
    /// `count` numbers.
    std::vector<double> numbers(std::size_t count, const Range& range) const;
    Vec3 vec3(const Range& range) const;

    // Of members that may be missing.
    double number(std::string_view key, const Range& range, double otherwise) const;
    Vec3 vec3(std::string_view key, const Range& range, Vec3 otherwise) const;
    std::string text(std::string_view key, std::string_view otherwise) const;

private:
    [[noreturn]] void fail_type(std::string_view expected) const;

    const std::string* file_;
    const JsonValue* value_;
    std::string pointer_;
};

}  // namespace dewbow
