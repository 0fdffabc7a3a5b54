// SPDX-License-Identifier: Apache-2.0
#pragma once

// Letters between the ranks of a render: programs that share one picture, on one machine or many.

#include <optional>
#include <string>

namespace dewbow {

struct Letter {
    int from = 0;
    std::string bytes;
};

/// Point to point, without waiting. Letters from one rank to another arrive in their order or not
/// at all. Used by one thread at a time.
class Transport {
public:
    virtual ~Transport() = default;
    virtual int rank() const = 0;
    virtual int ranks() const = 0;
    /// A letter to a rank that is gone is lost without a word.
    virtual void send(int to, std::string bytes) = 0;
    virtual std::optional<Letter> receive() = 0;
};

}  // namespace dewbow
