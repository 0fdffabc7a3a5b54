// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/notes.h"

#include <fmt/format.h>

namespace dewbow::gltf {

void Notes::add(const SourcePlace& place, const std::string& what, const std::string& who) {
    const auto [found, is_new] = notes_.try_emplace(what, Note{notes_.size(), place, who, {}});
    if (!is_new && place.within != found->second.place.within)
        found->second.others.insert(place.within);
}

Diagnostics Notes::list() const {
    Diagnostics diagnostics(notes_.size());
    for (const auto& [what, note] : notes_) {
        std::string who = note.first;
        if (note.others.size() == 1) who += " and of another";
        if (note.others.size() > 1) who += fmt::format(" and of {} others", note.others.size());
        std::string text = what;
        const std::size_t hole = text.find("{}");
        if (hole != std::string::npos) text.replace(hole, 2, who);
        diagnostics[note.order] = {note.place, text};
    }
    return diagnostics;
}

}  // namespace dewbow::gltf
