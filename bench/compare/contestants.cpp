// SPDX-License-Identifier: Apache-2.0
#include "contestant.h"
#include "dewbow_contestants.h"

namespace dewbow::bench {

const std::vector<ContestantRow>& contestants() {
    static const std::vector<ContestantRow> rows = {
        {"path", "dewbow's path tracer", "dewbow", find_path},
    };
    return rows;
}

}  // namespace dewbow::bench
