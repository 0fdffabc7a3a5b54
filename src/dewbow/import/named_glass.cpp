// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/named_glass.h"

#include <algorithm>

#include "dewbow/optics/catalogue.h"

namespace dewbow {
namespace {

void note_once(const std::optional<std::string>& text, const SourcePlace& place,
               Diagnostics& notes) {
    if (!text) return;
    const bool known = std::any_of(notes.begin(), notes.end(),
                                   [&](const Diagnostic& note) { return note.text == *text; });
    if (!known) notes.push_back({place, *text});
}

}  // namespace

DispersionPtr named_glass(std::string_view name, const SourcePlace& place, Diagnostics* notes) {
    // The very function that surrounds bodies by default, so that air in air bends nothing.
    if (name == "air" || name == "fluid/air") return air();
    if (name == "vacuum") return vacuum();
    const Glass glass = find_glass(name);
    if (notes) {
        note_once(range_warning(glass), place, *notes);
        note_once(birefringence_note(glass), place, *notes);
    }
    return make_dispersion(glass.data);
}

}  // namespace dewbow
