// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the program says: data on standard output, everything else on standard error.

#include <string>
#include <string_view>

namespace dewbow {

/// Throws InputError if it cannot be written whole. A reader that has gone away is no error: it has
/// what it wanted.
void print_data(std::string_view text);

/// One line on standard error.
void print_message(std::string_view line);

/// "dewbow: " and what went wrong, on standard error, made presentable().
void print_error(std::string_view what);

/// `text`, of which a file or a command line may have written parts, as it may stand on a terminal:
/// control characters and what is no UTF-8 become '?', very long lines lose their middle, and very
/// many lines their end.
std::string presentable(std::string_view text);

/// `word` as a POSIX shell wants it: quoted where it must be.
std::string shell_quoted(std::string_view word);

}  // namespace dewbow
