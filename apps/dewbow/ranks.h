// SPDX-License-Identifier: Apache-2.0
#pragma once

// The ranks that `mpirun -n N dewbow …` started, of which this program is one.

#include <memory>
#include <string>

#include "dewbow/render/farm/transport.h"

namespace dewbow {

/// While it lives MPI is open. Without mpirun, or with one rank, there is none.
class Ranks {
public:
    virtual ~Ranks() = default;
    virtual Transport& transport() = 0;
    /// Every rank calls it when all have said bye; from then on only this object may be destroyed.
    virtual void close() = 0;
    /// Ends the program on all ranks, those that do not answer included. Does not return.
    [[noreturn]] virtual void end_all(int exit_code) = 0;
};

/// What mpirun says of this program in its environment, before MPI is opened: opening takes a good
/// part of a second.
struct Place {
    int rank = 0, ranks = 1;
};
Place place_among_ranks();

/// Opens MPI if mpirun started more than one rank; else nullptr. Throws InputError if this program
/// was built without MPI, because N renders of the same picture are not what anybody wants.
std::unique_ptr<Ranks> open_ranks();

}  // namespace dewbow
