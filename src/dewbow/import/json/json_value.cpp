// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/json/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

/// Builds the tree from the parser's events; the parser keeps no stack of its own.
class TreeBuilder {
public:
    TreeBuilder(const std::string& file, std::string_view text) : file_(file), text_(text) {}

    JsonValue take() { return std::move(root_); }

    bool null() { return add({}); }
    bool boolean(bool value) { return add({value}); }
    bool number_integer(std::int64_t value) { return add({double(value)}); }
    bool number_unsigned(std::uint64_t value) { return add({double(value)}); }
    bool number_float(double value, const std::string&) { return add({value}); }
    bool string(std::string& value) { return add({std::move(value)}); }
    bool binary(nlohmann::json::binary_t&) { return false; }
    bool key(std::string& key) {
        key_ = std::move(key);
        return true;
    }
    bool start_object(std::size_t) { return open({JsonValue::Object{}}); }
    bool start_array(std::size_t) { return open({JsonValue::Array{}}); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }

    [[noreturn]] bool parse_error(std::size_t position, const std::string&,
                                  const nlohmann::detail::exception& error) {
        const std::size_t before = std::min(position > 0 ? position - 1 : 0, text_.size());
        const std::string_view read = text_.substr(0, before);
        const std::size_t line = std::size_t(std::count(read.begin(), read.end(), '\n')) + 1;
        const std::size_t column = before - (read.rfind('\n') + 1) + 1;  // npos + 1 is 0
        // A document on one line is no excerpt.
        constexpr std::size_t kLongestExcerpt = 200;
        std::string excerpt(line_of(text_, line).substr(0, kLongestExcerpt + 1));
        if (excerpt.size() > kLongestExcerpt) excerpt.clear();
        throw InputError({file_, line, column, {}}, "not JSON: " + reason_of(error.what()),
                         excerpt);
    }

private:
    /// "[json.exception.parse_error.101] parse error at line 1, column 2: …" without what is said
    /// elsewhere.
    static std::string reason_of(std::string_view what) {
        for (const std::string_view end_of_prefix : {"] ", ": "}) {
            const bool prefix = end_of_prefix == "] " || what.starts_with("parse error at");
            const std::size_t end = what.find(end_of_prefix);
            if (prefix && end != std::string_view::npos) what.remove_prefix(end + 2);
        }
        return std::string(what);
    }

    void count() {
        if (++values_ > kMaxJsonValues) {
            throw InputError({file_, 0, 0, {}},
                             fmt::format("holds more than {} JSON values", kMaxJsonValues), {}, {});
        }
    }

    JsonValue& insert(JsonValue value) {
        count();
        if (stack_.empty()) return root_ = std::move(value);
        if (auto* array = std::get_if<JsonValue::Array>(&stack_.back()->value)) {
            return array->emplace_back(std::move(value));
        }
        auto& object = std::get<JsonValue::Object>(stack_.back()->value);
        return object.emplace_back(JsonMember{std::move(key_), std::move(value)}).value;
    }
    bool add(JsonValue value) {
        insert(std::move(value));
        return true;
    }
    bool open(JsonValue value) {
        if (stack_.size() >= kMaxJsonDepth) {
            throw InputError({file_, 0, 0, {}},
                             fmt::format("JSON is nested more than {} deep", kMaxJsonDepth), {},
                             {});
        }
        // The container that a pointer leads to grows only once this one is closed.
        stack_.push_back(&insert(std::move(value)));
        return true;
    }
    bool close() {
        stack_.pop_back();
        return true;
    }

    const std::string& file_;
    std::string_view text_;
    JsonValue root_;
    std::vector<JsonValue*> stack_;
    std::string key_;
    std::size_t values_ = 0;
};

}  // namespace

JsonValue parse_json(const std::string& file, std::string_view text) {
    TreeBuilder builder(file, text);
    nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
    return builder.take();
}

}  // namespace dewbow
