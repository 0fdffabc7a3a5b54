// SPDX-License-Identifier: Apache-2.0
#include "console.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "dewbow/base/error.h"

namespace dewbow {

namespace {

// Room for any path or list of names that a person writes; a name of a megabyte is an attack.
constexpr std::size_t kLongestLine = 1000;
constexpr std::size_t kMostLines = 12;

unsigned byte_at(std::string_view text, std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

bool continues_character(unsigned byte) { return (byte & 0xc0) == 0x80; }

/// Bytes of the character at the beginning of `text`: 0 if it is no UTF-8, or a control character.
/// [Unicode 15, table 3-7]
std::size_t printable_character(std::string_view text) {
    const unsigned first = byte_at(text, 0), second = byte_at(text, 1);
    if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\t' ? 1 : 0;
    const std::size_t size = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (size == 0 || first > 0xf4) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if (!continues_character(byte_at(text, i))) return 0;
    const bool control = first == 0xc2 && second < 0xa0;
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_code_point = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
    return control || overlong || no_code_point ? 0 : size;
}

std::string printable_line(std::string_view line) {
    std::string result;
    while (!line.empty()) {
        const std::size_t size = printable_character(line);
        result += size == 0 ? std::string_view("?") : line.substr(0, size);
        line.remove_prefix(size == 0 ? 1 : size);
    }
    return result;
}

/// The end is kept as well: it says what was expected.
std::string without_middle(const std::string& line) {
    if (line.size() <= kLongestLine) return line;
    std::size_t head = kLongestLine / 2, tail = line.size() - kLongestLine / 2;
    while (continues_character(byte_at(line, head))) --head;
    while (continues_character(byte_at(line, tail))) ++tail;
    return line.substr(0, head) + "..." + line.substr(tail);
}

}  // namespace

void print_data(std::string_view text) {
    errno = 0;
    const bool written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
    if (written || errno == EPIPE) return;
    throw InputError(std::string("standard output cannot be written: ") + std::strerror(errno));
}

void print_message(std::string_view line) {
    const std::string text = std::string(line) + "\n";
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void print_error(std::string_view what) {
    print_message(presentable("dewbow: " + std::string(what)));
}

std::string presentable(std::string_view text) {
    std::string result;
    for (std::size_t lines = 1;; ++lines) {
        const std::size_t end = text.find('\n');
        result += without_middle(printable_line(text.substr(0, end)));
        if (end == std::string_view::npos) return result;
        if (lines == kMostLines) return result + "...";
        result += '\n';
        text.remove_prefix(end + 1);
    }
}

std::string shell_quoted(std::string_view word) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%";
    if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos)
        return std::string(word);
    std::string result = "'";
    for (const char c : word) {
        if (c == '\'')
            result += "'\\''";
        else
            result += c;
    }
    return result + "'";
}

}  // namespace dewbow
