// SPDX-License-Identifier: Apache-2.0
#pragma once

// EXT_meshopt_compression: buffer views packed by meshoptimizer.

#include <string>

#include "dewbow/import/json/json.h"

namespace dewbow::gltf {

/// What `packed` holds, `length` bytes. Where it is not that, InputError at `compression`, the
/// extension object that describes it.
std::string unpack_meshopt(const Json& compression, std::string_view packed, std::uint64_t length);

}  // namespace dewbow::gltf
