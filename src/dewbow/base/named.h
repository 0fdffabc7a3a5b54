// SPDX-License-Identifier: Apache-2.0
#pragma once

// How people name what a catalogue holds: "schott/N-BK7", "n-bk7", "nbk7".

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace dewbow {

/// Index of the entry of `names` (each "group/rest") that `name` means. The group may be left out
/// where the rest is unique, and case, hyphens, spaces and underscores do not matter.
/// @param kind  of thing, for messages: "glass".
/// Throws InputError: unknown with the nearest names, or ambiguous with all of them.
std::size_t find_named(std::string_view kind, std::string_view name,
                       std::span<const std::string> names);

/// The same, or nothing where `name` means none of them or several.
std::optional<std::size_t> match_named(std::string_view name, std::span<const std::string> names);

}  // namespace dewbow
