// SPDX-License-Identifier: Apache-2.0
#pragma once

// The text of an IESNA LM-63 file: label lines, then numbers between spaces, commas and ends of
// lines. Every failure names line and column.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/import/range.h"

namespace dewbow::ies {

class Text {
public:
    Text(std::string file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {}

    /// The next line without its end and the spaces around it, or nothing at the end.
    std::optional<std::string_view> next_line();

    /// The next number, which is called `what` in messages. Throws InputError if there is none or
    /// `range` does not hold it.
    double number(std::string_view what, const Range& range);
    /// The same for a whole number from `low` to `high`.
    int whole_number(std::string_view what, int low, int high);
    /// The next `count` numbers. A count that cannot stand in what is left of the file throws
    /// before memory is taken.
    std::vector<double> numbers(std::string_view what, std::size_t count, const Range& range);
    /// The same, strictly ascending.
    std::vector<double> ascending_numbers(std::string_view what, std::size_t count,
                                          const Range& range);
    /// Throws if anything but space follows.
    void expect_end();

    /// Of the line or number that was read last.
    SourcePlace place() const;
    /// Throws InputError at place().
    [[noreturn]] void fail(std::string_view sentence, std::string hint = {}) const;

private:
    std::string_view next_word();
    void check_count(std::string_view what, std::size_t count) const;

    std::string file_;
    std::string_view bytes_;
    std::size_t position_ = 0;  ///< of what is read next
    std::size_t begin_ = 0;     ///< of what was read last
};

}  // namespace dewbow::ies
