// SPDX-License-Identifier: Apache-2.0
// What stands for ranks_mpi.cpp in a program that was built without MPI.

#include "dewbow/base/error.h"
#include "ranks.h"

namespace dewbow {

std::unique_ptr<Ranks> open_ranks() {
    const Place place = place_among_ranks();
    if (place.ranks < 2) return nullptr;
    throw InputError("mpirun started " + std::to_string(place.ranks) +
                     " ranks, and this program was built without MPI: each would render the same "
                     "picture into the same file; build it with -DDEWBOW_MPI=ON, or use --slice");
}

}  // namespace dewbow
