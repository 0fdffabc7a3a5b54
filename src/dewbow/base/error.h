// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the program says when something given to it is wrong. Bad input at a door (file, flag, name)
// throws InputError, which is caught once in main; what an importer understands only in part is
// listed as Diagnostics.

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace dewbow {

/// Where in the user's material something stands. Lines and columns (characters, not
/// bytes) count from 1; 0 = not known.
/// `within` names a place inside the file that lines cannot (a JSON pointer, a key), or is empty.
struct SourcePlace {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
    std::string within;
};

/// "scene.toml:12:7" or "ring.glb: /materials/3/ior"; parts that are not known are left out.
std::string to_string(const SourcePlace& place);

/// Wrong input. what() is the whole message as it is to be printed:
///
///     scene.toml:12:9: unknown glass "schott/BK7"
///       12 | glass = "schott/BK7"
///          |         ^
///       hint: did you mean "schott/N-BK7"?
class InputError : public std::runtime_error {
public:
    /// @param what     one clear sentence: what was found, what was expected.
    /// @param excerpt  the line of the file at `place`, or empty.
    /// @param hint     a way out ("did you mean …?"), or empty.
    InputError(SourcePlace place, std::string what, std::string excerpt = {},
               std::string hint = {});
    explicit InputError(std::string what, std::string hint = {});

    const SourcePlace& place() const { return place_; }
    /// The sentence alone, without place, excerpt and hint.
    const std::string& sentence() const { return sentence_; }
    const std::string& hint() const { return hint_; }

private:
    SourcePlace place_;
    std::string sentence_;
    std::string hint_;
};

/// The command line was used wrongly: exit code 2 instead of 1.
class UsageError : public InputError {
public:
    using InputError::InputError;
};

/// Something that an importer could not honour, or honoured only approximately.
struct Diagnostic {
    SourcePlace place;
    std::string text;
};
using Diagnostics = std::vector<Diagnostic>;

/// The candidate nearest to `word` by edit distance (case counts less than a letter), or empty when
/// none is near enough to be meant (distance above a third of the longer word's length, at least 2,
/// or nothing of the word left). The first of equals.
std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// `did you mean "x"?`, or `expected one of a, b, c` when nothing is near and the list is short, or
/// empty.
std::string hint_for(std::string_view word, std::span<const std::string> candidates);

/// Line `line` (from 1) of `text`, without its end; empty if there is none.
std::string_view line_of(std::string_view text, std::size_t line);

}  // namespace dewbow
