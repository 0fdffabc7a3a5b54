// SPDX-License-Identifier: Apache-2.0
#include "dewbow/base/named.h"

#include <fmt/format.h>

#include <vector>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using Names = std::span<const std::string>;

/// Longer lists of all names help nobody.
constexpr std::size_t kLongestList = 40;

/// What of a name counts: letters in lower case, digits, points and the slash.
std::string folded(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c == '-' || c == ' ' || c == '_') continue;
        result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

std::string without_group(const std::string& name) { return name.substr(name.find('/') + 1); }

/// What `name` can mean: the one of that full name, or all with it after the slash.
std::vector<std::size_t> all_named(std::string_view name, Names names) {
    const std::string wanted = folded(name);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (folded(names[i]) == wanted) return {i};
        if (folded(without_group(names[i])) == wanted) found.push_back(i);
    }
    return found;
}

std::string listed(const std::vector<std::size_t>& which, Names names) {
    std::string list;
    for (std::size_t i : which) list += (list.empty() ? "" : ", ") + names[i];
    return list;
}

std::string known(Names names) {
    std::string list;
    for (std::size_t i = 0; i < names.size() && i < kLongestList; ++i) {
        list += (i > 0 ? ", " : "") + names[i];
    }
    return fmt::format("known are {}{}", list, names.size() > kLongestList ? " and more" : "");
}

/// "did you mean schott/F2?": nearest among the full names if a group was given, among the rest if
/// not.
std::string hint_for_name(std::string_view name, Names names) {
    const bool has_group = name.find('/') != std::string_view::npos;
    std::vector<std::string> candidates;
    for (const std::string& full : names) {
        candidates.push_back(has_group ? full : without_group(full));
    }
    std::string nearest = nearest_word(name, candidates);
    if (nearest.empty() && has_group)  // a group that is not here, of a thing that is
        nearest = without_group(std::string(name));
    const auto meant = nearest.empty() ? std::vector<std::size_t>{} : all_named(nearest, names);
    if (!meant.empty()) return fmt::format("did you mean {}?", listed(meant, names));
    return known(names);
}

}  // namespace

std::optional<std::size_t> match_named(std::string_view name, Names names) {
    const auto found = all_named(name, names);
    return found.size() == 1 ? std::optional(found.front()) : std::nullopt;
}

std::size_t find_named(std::string_view kind, std::string_view name, Names names) {
    const auto found = all_named(name, names);
    if (found.size() == 1) return found.front();
    if (found.empty()) {
        throw InputError(fmt::format("unknown {} \"{}\"", kind, name), hint_for_name(name, names));
    }
    throw InputError(fmt::format("{} \"{}\" is ambiguous", kind, name),
                     fmt::format("write one of {}", listed(found, names)));
}

}  // namespace dewbow
