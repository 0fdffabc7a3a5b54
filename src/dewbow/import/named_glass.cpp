// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/named_glass.h"

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/glass/glass_file.h"
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

DispersionPtr noted_index(const Glass& glass, const SourcePlace& place, Diagnostics* notes) {
    if (notes) {
        note_once(range_warning(glass), place, *notes);
        note_once(birefringence_note(glass), place, *notes);
    }
    return make_dispersion(glass.data);
}

}  // namespace

DispersionPtr glass_of_file(std::string_view reference, const SourcePlace& place,
                            Diagnostics* notes) {
    const GlassReference parts = split_glass_reference(reference);
    const std::filesystem::path folder = std::filesystem::path(place.file).parent_path();
    const Glass glass =
        load_glass(resolve_inside(folder.empty() ? "." : folder, parts.file), parts.name, notes);
    return noted_index(glass, place, notes);
}

DispersionPtr named_glass(std::string_view name, const SourcePlace& place, Diagnostics* notes) {
    // The very function that surrounds bodies by default, so that air in air bends nothing.
    if (name == "air" || name == "fluid/air") return air();
    if (name == "vacuum") return vacuum();
    return noted_index(find_glass(name), place, notes);
}

}  // namespace dewbow
