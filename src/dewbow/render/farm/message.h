// SPDX-License-Identifier: Apache-2.0
#pragma once

// What ranks say to each other. Rank 0 coordinates; the others ask it for units and send their
// sums.
//
//     worker            rank 0
//     hello        →             who it is, and that it wants a lease
//     request      →             it wants another one, to have work while a result travels
//                  ←    lease    units to render
//     result       →             their sums; it wants another lease
//                  ←    alive    now and then, so that workers know that rank 0 is there
//                  ←    finish   no more work; what is under way may be dropped
//     bye          →             nothing more will come
//                  ←    leave    and whether all have said bye: if so, MPI may be closed

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "dewbow/render/film.h"

namespace dewbow {

/// Passes [first_pass, end_pass) of one tile, whose sums are sent as those of one tile; or of one
/// light unit, whose splats are sent one by one.
struct UnitRun {
    std::uint64_t number = 0;  ///< of the unit in its passes
    std::uint64_t first_pass = 0, end_pass = 0;
    std::uint64_t units() const { return end_pass - first_pass; }
    bool operator==(const UnitRun&) const = default;
};

/// Units that a rank has been asked to render.
struct Lease {
    std::uint64_t number = 0;
    std::vector<UnitRun> runs;
    bool operator==(const Lease&) const = default;
};

namespace message {

struct Hello {
    std::string identity;  ///< identity_bytes of the render
    int threads = 1;
};
struct Request {};
struct Work {
    Lease lease;
};
/// A run that is finished, or its begin if the render ended.
struct Piece {
    UnitRun run;
    /// FilmSums::append_pixels of the tile, or SplatList::append_bytes.
    std::string sums;
    InvalidSamples invalid;
};
struct Result {
    std::uint64_t lease = 0;  ///< its number
    std::vector<Piece> pieces;
    double seconds = 0.0;  ///< that rendering took
};
struct Alive {};
struct Finish {};
struct Bye {
    std::string reason;  ///< why the rank does not take part; empty: it did
};
struct Leave {
    bool all_present = true;
};

}  // namespace message

using Message = std::variant<message::Hello, message::Request, message::Work, message::Result,
                             message::Alive, message::Finish, message::Bye, message::Leave>;

/// Ends with a checksum: of a rank that is killed while a letter travels, a part may arrive.
std::string bytes_of(const Message& message);

/// Throws InputError if `bytes` are no message; memory is taken only for what they hold.
Message message_from_bytes(std::string_view bytes);

}  // namespace dewbow
