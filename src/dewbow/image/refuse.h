// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "dewbow/base/error.h"

namespace dewbow {

/// Throws the InputError that every decoder throws: the file by its name, and a sentence.
[[noreturn]] inline void refuse_file(const std::string& name, const std::string& sentence) {
    throw InputError(SourcePlace{name, 0, 0, {}}, sentence);
}

}  // namespace dewbow
