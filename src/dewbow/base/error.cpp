// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/error.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace dewbow {

namespace {

// An excerpt is cut to about one line of a terminal: a minified JSON file is one line of megabytes.
constexpr std::size_t kExcerptCharacters = 100;
// Shown before the marked column when the excerpt is cut.
constexpr std::size_t kExcerptLead = 40;

// Edit costs in quarters of a letter, so that case can count less than a letter.
constexpr int kLetterCost = 4;
constexpr int kCaseCost = 1;
// Nobody mistypes a word this long; also bounds the quadratic cost of a hostile file.
constexpr std::size_t kLongestGuessedWord = 256;
// Longer lists of what was expected help nobody.
constexpr std::size_t kLongestListedChoice = 12;

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Control characters would let a scene file write escape sequences to the terminal.
std::string printable(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        const auto code = static_cast<unsigned char>(c);
        if ((code < 0x20 && c != '\n' && c != '\t') || code == 0x7f) c = '?';
    }
    return result;
}

/// Where each character (UTF-8 code point) of `text` begins, and the end.
std::vector<std::size_t> character_starts(std::string_view text) {
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (!continues_character(text[i])) starts.push_back(i);
    starts.push_back(text.size());
    return starts;
}

struct Excerpt {
    std::string line;
    std::string marker;  ///< what stands below the line: spaces and a caret, or empty
};

Excerpt excerpt_around(std::string_view text, std::size_t column) {
    const std::vector<std::size_t> starts = character_starts(text);
    const std::size_t count = starts.size() - 1;
    const bool marks = column >= 1 && column <= count + 1;
    const bool cut = count > kExcerptCharacters;
    const std::size_t first = cut && marks && column > kExcerptLead
                                  ? std::min(column - kExcerptLead, count - kExcerptCharacters)
                                  : 0;
    const std::size_t last = cut ? std::min(count, first + kExcerptCharacters) : count;

    Excerpt result;
    if (first > 0) result.line += "...";
    result.line += text.substr(starts[first], starts[last] - starts[first]);
    if (last < count) result.line += "...";
    if (marks) {
        if (first > 0) result.marker += "   ";
        // Tabs are repeated, so that the caret stands below its column whatever their width.
        for (std::size_t i = first; i + 1 < column; ++i)
            result.marker += text[starts[i]] == '\t' ? '\t' : ' ';
        result.marker += '^';
    }
    return result;
}

std::string compose(const SourcePlace& place, const std::string& sentence,
                    const std::string& excerpt, const std::string& hint) {
    std::string message = to_string(place);
    if (!message.empty()) message += ": ";
    message += sentence;
    if (!excerpt.empty()) {
        const std::string number = place.line > 0 ? std::to_string(place.line) : std::string();
        const Excerpt shown = excerpt_around(excerpt, place.column);
        message += "\n  " + number + " | " + shown.line;
        if (!shown.marker.empty())
            message += "\n  " + std::string(number.size(), ' ') + " | " + shown.marker;
    }
    if (!hint.empty()) message += "\n  hint: " + hint;
    return printable(message);
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int replacement_cost(char a, char b) {
    if (a == b) return 0;
    return lower(a) == lower(b) ? kCaseCost : kLetterCost;
}

/// Cost of the cheapest edit from `a` to `b` by inserting, deleting and replacing letters and by
/// exchanging neighbours, no letter being edited twice (optimal string alignment).
/// [Damerau 1964; Levenshtein 1966]
int edit_cost(std::string_view a, std::string_view b) {
    const std::size_t width = b.size() + 1;
    // Costs from the first i letters of `a`, for i, i - 1 and i - 2.
    std::vector<int> current(width), previous(width), before(width);
    for (std::size_t j = 0; j < width; ++j) current[j] = static_cast<int>(j) * kLetterCost;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(before, previous);
        std::swap(previous, current);
        current[0] = static_cast<int>(i) * kLetterCost;
        for (std::size_t j = 1; j < width; ++j) {
            int cost = previous[j - 1] + replacement_cost(a[i - 1], b[j - 1]);
            cost = std::min({cost, previous[j] + kLetterCost, current[j - 1] + kLetterCost});
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                lower(a[i - 2]) == lower(b[j - 1]))
                cost = std::min(cost, before[j - 2] + kLetterCost);
            current[j] = cost;
        }
    }
    return current.back();
}

/// The largest cost at which one word of this length is still meant as the other.
int largest_cost(std::size_t longer) {
    const int length = static_cast<int>(longer);
    const int near = std::max(2 * kLetterCost, length * kLetterCost / 3);
    // Something must be left of the word: "ab" is no misspelling of "cd".
    return std::min(near, (length - 1) * kLetterCost);
}

}  // namespace

std::string to_string(const SourcePlace& place) {
    std::string text = place.file;
    if (place.line > 0) {
        text += text.empty() ? "line " : ":";
        text += std::to_string(place.line);
    }
    if (place.line > 0 && place.column > 0) {
        text += ':';
        text += std::to_string(place.column);
    }
    if (!text.empty() && !place.within.empty()) text += ": ";
    text += place.within;
    return text;
}

InputError::InputError(SourcePlace place, std::string what, std::string excerpt, std::string hint)
    : std::runtime_error(compose(place, what, excerpt, hint)),
      place_(std::move(place)),
      sentence_(std::move(what)),
      hint_(std::move(hint)) {}

InputError::InputError(std::string what, std::string hint)
    : InputError(SourcePlace{}, std::move(what), {}, std::move(hint)) {}

std::string nearest_word(std::string_view word, std::span<const std::string> candidates) {
    const std::string* nearest = nullptr;
    int nearest_cost = std::numeric_limits<int>::max();
    for (const std::string& candidate : candidates) {
        const std::size_t longer = std::max(word.size(), candidate.size());
        if (longer > kLongestGuessedWord) continue;
        const int cost = edit_cost(word, candidate);
        if (cost <= largest_cost(longer) && cost < nearest_cost) {
            nearest = &candidate;
            nearest_cost = cost;
        }
    }
    return nearest ? *nearest : std::string();
}

std::string hint_for(std::string_view word, std::span<const std::string> candidates) {
    const std::string nearest = nearest_word(word, candidates);
    if (!nearest.empty()) return "did you mean \"" + nearest + "\"?";
    if (candidates.empty() || candidates.size() > kLongestListedChoice) return {};
    return std::accumulate(candidates.begin() + 1, candidates.end(),
                           "expected one of " + candidates.front(),
                           [](std::string list, const std::string& choice) {
                               return std::move(list) + ", " + choice;
                           });
}

std::string_view line_of(std::string_view text, std::size_t line) {
    if (line == 0) return {};
    for (; line > 1; --line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    std::string_view result = text.substr(0, text.find('\n'));
    if (result.ends_with('\r')) result.remove_suffix(1);
    return result;
}

}  // namespace dewbow
