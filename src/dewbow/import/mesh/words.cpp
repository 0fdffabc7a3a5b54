// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/words.h"

namespace dewbow {

std::string_view LineReader::take() {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line = text_.substr(position_, end - position_);
    position_ = end + 1;
    ++taken_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

bool LineReader::next() {
    if (position_ >= text_.size()) return false;
    line_ = take();
    number_ = taken_;
    if (!line_.ends_with('\\')) return true;
    joined_.clear();
    while (line_.ends_with('\\')) {
        joined_.append(line_.substr(0, line_.size() - 1)).push_back(' ');
        line_ = position_ < text_.size() ? take() : std::string_view{};
    }
    line_ = joined_.append(line_);
    return true;
}

void split_words(std::string_view line, std::vector<std::string_view>& words) {
    constexpr std::string_view kSpace = " \t";
    std::size_t begin = line.find_first_not_of(kSpace);
    while (begin != std::string_view::npos) {
        const std::size_t end = std::min(line.find_first_of(kSpace, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(kSpace, end);
    }
}

}  // namespace dewbow
