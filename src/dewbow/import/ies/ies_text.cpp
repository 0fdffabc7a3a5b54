// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/ies/ies_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/parse_number.h"

namespace dewbow::ies {
namespace {

/// Between numbers. Old programs end a file with Ctrl-Z (0x1a).
constexpr std::string_view kSeparators = " \t\r\n,\x1a";
constexpr std::string_view kSpace = " \t\r";

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }

}  // namespace

std::optional<std::string_view> Text::next_line() {
    if (position_ >= bytes_.size()) return std::nullopt;
    begin_ = position_;
    const std::size_t end = std::min(bytes_.find('\n', position_), bytes_.size());
    position_ = std::min(end + 1, bytes_.size());
    std::string_view line = bytes_.substr(begin_, end - begin_);
    const std::size_t first = std::min(line.find_first_not_of(kSpace), line.size());
    begin_ += first;
    line.remove_prefix(first);
    return line.substr(0, line.find_last_not_of(kSpace) + 1);
}

std::string_view Text::next_word() {
    begin_ = std::min(bytes_.find_first_not_of(kSeparators, position_), bytes_.size());
    position_ = std::min(bytes_.find_first_of(kSeparators, begin_), bytes_.size());
    return bytes_.substr(begin_, position_ - begin_);
}

double Text::number(std::string_view what, const Range& range) {
    const std::string_view word = next_word();
    if (word.empty()) fail(fmt::format("the file ends where {} should stand", what));
    const auto value = parse_number<double>(word);
    if (!value) fail(fmt::format("\"{}\" stands where {} should; it is no number", word, what));
    if (range.contains(*value)) return *value;
    fail(fmt::format("{} is {}; it must be {}", what, *value, range.text()));
}

int Text::whole_number(std::string_view what, int low, int high) {
    const double value = number(what, {double(low), double(high)});
    if (value == std::floor(value)) return int(value);
    fail(fmt::format("{} is {}; it must be a whole number", what, value));
}

void Text::check_count(std::string_view what, std::size_t count) const {
    // A number takes one byte, and one that separates it from the next.
    const std::size_t left = bytes_.size() - position_;
    if (count <= left / 2 + 1) return;
    fail(fmt::format("{} {}s cannot stand in the {} bytes that are left", count, what, left));
}

std::vector<double> Text::numbers(std::string_view what, std::size_t count, const Range& range) {
    check_count(what, count);
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(number(fmt::format("{} {} of {}", what, i + 1, count), range));
    }
    return values;
}

std::vector<double> Text::ascending_numbers(std::string_view what, std::size_t count,
                                            const Range& range) {
    check_count(what, count);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(number(fmt::format("{} {} of {}", what, i + 1, count), range));
        if (i == 0 || values[i] > values[i - 1]) continue;
        fail(fmt::format("{} {} of {} is {} after {}; they must ascend", what, i + 1, count,
                         values[i], values[i - 1]));
    }
    return values;
}

void Text::expect_end() {
    const std::string_view word = next_word();
    if (word.empty()) return;
    fail(fmt::format("\"{}\" follows the last intensity", word),
         "are the numbers of vertical and horizontal angles right?");
}

SourcePlace Text::place() const {
    const std::string_view before = bytes_.substr(0, begin_);
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 where there is none
    return {file_,
            1 + std::size_t(std::count(before.begin(), before.end(), '\n')),
            1 + std::size_t(std::count_if(before.begin() + std::ptrdiff_t(line_begin), before.end(),
                                          begins_character)),
            {}};
}

void Text::fail(std::string_view sentence, std::string hint) const {
    const SourcePlace where = place();
    throw InputError(where, std::string(sentence), std::string(line_of(bytes_, where.line)),
                     std::move(hint));
}

}  // namespace dewbow::ies
