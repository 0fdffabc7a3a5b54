// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/json/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/import/one_line.h"

namespace dewbow {
namespace {

/// RFC 6901: "~" is written "~0", "/" is written "~1".
std::string escaped(std::string_view key) {
    std::string result;
    for (const char c : key) {
        if (c == '~') {
            result += "~0";
        } else if (c == '/') {
            result += "~1";
        } else {
            result += c;
        }
    }
    return result;
}

struct Describe {
    std::string operator()(std::monostate) const { return "null"; }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(double d) const { return fmt::format("the number {}", d); }
    std::string operator()(const std::string& s) const {
        constexpr std::size_t kShown = 40;
        return s.size() <= kShown ? fmt::format("the string \"{}\"", s) : "a long string";
    }
    std::string operator()(const JsonValue::Array& a) const {
        return fmt::format("an array of {}", a.size());
    }
    std::string operator()(const JsonValue::Object&) const { return "an object"; }
};

}  // namespace

void Json::fail(const std::string& sentence, const std::string& hint) const {
    throw InputError({*file_, 0, 0, one_line(pointer_)}, one_line(sentence), {}, one_line(hint));
}

void Json::fail_type(std::string_view expected) const {
    fail(fmt::format("is {}; expected {}", std::visit(Describe{}, value_->value), expected));
}

std::optional<Json> Json::find(std::string_view key) const {
    const auto* object = std::get_if<JsonValue::Object>(&value_->value);
    if (!object) fail_type("an object");
    const auto found = std::find_if(object->rbegin(), object->rend(),
                                    [&](const JsonMember& member) { return member.key == key; });
    if (found == object->rend()) return std::nullopt;
    Json member(*file_, found->value);
    member.pointer_ = pointer_ + "/" + escaped(key);
    return member;
}

Json Json::require(std::string_view key) const {
    const std::optional<Json> member = find(key);
    if (!member) fail(fmt::format("needs \"{}\"", key));
    return *member;
}

std::vector<std::string> Json::keys() const {
    const auto* object = std::get_if<JsonValue::Object>(&value_->value);
    if (!object) fail_type("an object");
    std::vector<std::string> keys;
    for (const JsonMember& member : *object) keys.push_back(member.key);
    return keys;
}

std::size_t Json::size() const {
    const auto* array = std::get_if<JsonValue::Array>(&value_->value);
    if (!array) fail_type("an array");
    return array->size();
}

Json Json::operator[](std::size_t index) const {
    Json item(*file_, std::get<JsonValue::Array>(value_->value).at(index));
    item.pointer_ = fmt::format("{}/{}", pointer_, index);
    return item;
}

double Json::number(const Range& range) const {
    const auto* number = std::get_if<double>(&value_->value);
    if (!number) fail_type("a number");
    if (!range.contains(*number)) fail(fmt::format("is {}; it must be {}", *number, range.text()));
    return *number;
}

std::uint64_t Json::whole(std::uint64_t most) const {
    const auto* number = std::get_if<double>(&value_->value);
    if (!number) fail_type("a whole number");
    // Beyond 2⁵³ a double does not tell which number was written.
    const double limit = std::min(double(most), 0x1p53);
    if (!(*number >= 0.0 && *number <= limit) || *number != std::floor(*number)) {
        fail(fmt::format("is {}; it must be a whole number between 0 and {}", *number, limit));
    }
    return std::uint64_t(*number);
}

bool Json::boolean() const {
    const auto* boolean = std::get_if<bool>(&value_->value);
    if (!boolean) fail_type("true or false");
    return *boolean;
}

const std::string& Json::text() const {
    const auto* text = std::get_if<std::string>(&value_->value);
    if (!text) fail_type("a string");
    return *text;
}

std::vector<double> Json::numbers(std::size_t count, const Range& range) const {
    const auto* array = std::get_if<JsonValue::Array>(&value_->value);
    if (!array || array->size() != count) fail_type(fmt::format("an array of {} numbers", count));
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back((*this)[i].number(range));
    return numbers;
}

Vec3 Json::vec3(const Range& range) const {
    const std::vector<double> v = numbers(3, range);
    return {v[0], v[1], v[2]};
}

double Json::number(std::string_view key, const Range& range, double otherwise) const {
    const std::optional<Json> member = find(key);
    return member ? member->number(range) : otherwise;
}

Vec3 Json::vec3(std::string_view key, const Range& range, Vec3 otherwise) const {
    const std::optional<Json> member = find(key);
    return member ? member->vec3(range) : otherwise;
}

std::string Json::text(std::string_view key, std::string_view otherwise) const {
    const std::optional<Json> member = find(key);
    return member ? member->text() : std::string(otherwise);
}

}  // namespace dewbow
