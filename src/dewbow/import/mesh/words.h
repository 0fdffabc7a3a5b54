// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lines and words of plain text formats.

#include <string>
#include <string_view>
#include <vector>

namespace dewbow {

/// Goes through `text` line by line. Lines end with \n or \r\n; a line that ends with a backslash
/// goes on in the next.
class LineReader {
public:
    explicit LineReader(std::string_view text) : text_(text) {}

    /// Goes to the next line; false at the end.
    bool next();
    /// Without its end. Good until next().
    std::string_view line() const { return line_; }
    /// Of the (first) line, from 1.
    std::size_t number() const { return number_; }

private:
    std::string_view take();

    std::string_view text_, line_;
    std::string joined_;
    std::size_t position_ = 0, number_ = 0, taken_ = 0;
};

/// Appends what stands between spaces and tabs.
void split_words(std::string_view line, std::vector<std::string_view>& words);

}  // namespace dewbow
