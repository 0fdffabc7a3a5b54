// SPDX-License-Identifier: Apache-2.0
#pragma once

// Diagnostics of one file: what is wrong with a hundred materials is said once.

#include <map>
#include <set>

#include "dewbow/base/error.h"

namespace dewbow::gltf {

class Notes {
public:
    /// @param what  with "{}" where the thing is named: "the normal texture of {} is not used".
    /// @param who   'material "gold"'.
    /// Things with the same `what` share one diagnostic: 'of material "gold" and of 3 others'.
    void add(const SourcePlace& place, const std::string& what, const std::string& who);

    /// In the order in which they were first noted.
    Diagnostics list() const;

private:
    struct Note {
        std::size_t order = 0;
        SourcePlace place;
        std::string first;
        std::set<std::string> others;  ///< by JSON pointer
    };
    std::map<std::string, Note> notes_;
};

}  // namespace dewbow::gltf
