// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace dewbow::bench {

/// Multiply-adds of doubles per second of one thread, with the instructions of the variant of
/// sum_block that has this name: 16 independent chains in registers, the best of several tries.
double multiply_adds_per_second(std::string_view variant);

}  // namespace dewbow::bench
