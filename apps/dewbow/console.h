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

/// `word` as a POSIX shell wants it: quoted where it must be.
std::string shell_quoted(std::string_view word);

}  // namespace dewbow
