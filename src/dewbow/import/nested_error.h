// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dewbow/base/error.h"

namespace dewbow {

/// The sentence of `error` with the place that it names, for an error about a file within a file.
inline std::string sentence_with_place(const InputError& error) {
    const std::string place = to_string(error.place());
    return place.empty() ? error.sentence() : place + ": " + error.sentence();
}

}  // namespace dewbow
