// SPDX-License-Identifier: Apache-2.0
#include "ranks.h"

#include <cstdlib>
#include <optional>
#include <string_view>

#include "dewbow/base/parse_number.h"

namespace dewbow {

namespace {

std::optional<int> number_in_environment(const char* name) {
    const char* text = std::getenv(name);
    if (!text) return std::nullopt;
    return parse_number<int>(text);
}

}  // namespace

Place place_among_ranks() {
    // Open MPI; what keeps to PMI: MPICH and Slurm's srun.
    constexpr const char* kNames[][2] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                         {"PMI_RANK", "PMI_SIZE"}};
    for (const auto& [rank_name, size_name] : kNames) {
        const auto rank = number_in_environment(rank_name), size = number_in_environment(size_name);
        if (rank && size) return {*rank, *size};
    }
    return {};
}

}  // namespace dewbow
