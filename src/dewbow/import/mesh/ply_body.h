// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of a PLY file, one by one, whether they are text or bytes.

#include <memory>

#include "dewbow/base/error.h"
#include "dewbow/import/mesh/ply_header.h"

namespace dewbow::ply {

class Body {
public:
    virtual ~Body() = default;
    /// The next number. Throws InputError where the file ends or holds none.
    virtual double number(Scalar type) = 0;
    /// Where reading stands.
    virtual SourcePlace place() const = 0;
    /// Bytes that are left.
    virtual std::uint64_t left() const = 0;
    /// Bytes that a number of that type takes at least.
    virtual std::size_t least_bytes(Scalar type) const = 0;
};

std::unique_ptr<Body> make_body(const std::string& file, std::string_view bytes,
                                const Header& header);

}  // namespace dewbow::ply
