// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/glass/glass_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/base/named.h"
#include "dewbow/import/glass/agf.h"
#include "dewbow/import/glass/rii_page.h"

namespace dewbow {
namespace {

/// The largest catalogue of a maker has 2 MB.
constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20;

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool is_yaml(const std::string& extension) { return extension == ".yml" || extension == ".yaml"; }

/// Names have one slash.
std::string group_named(std::string stem) {
    std::replace(stem.begin(), stem.end(), '/', '-');
    return lower(stem);
}

std::string bare_name(const Glass& glass) { return glass.name.substr(glass.name.find('/') + 1); }

}  // namespace

GlassReference split_glass_reference(std::string_view reference) {
    const std::size_t hash = reference.find('#');
    if (hash == std::string_view::npos) return {std::string(reference), {}};
    return {std::string(reference.substr(0, hash)), std::string(reference.substr(hash + 1))};
}

bool is_glass_file_reference(std::string_view reference) {
    const std::string extension =
        lower(std::filesystem::path(split_glass_reference(reference).file).extension().string());
    return extension == ".agf" || is_yaml(extension);
}

GlassFile load_glass_file(const std::filesystem::path& path) {
    if (!is_glass_file_reference(path.string()))
        throw InputError(
            fmt::format("{}: expected a glass file, .agf, .yml or .yaml", path.string()));
    const std::string bytes = read_file(path, kMaxBytes);
    const std::string stem = path.stem().string(), file = path.string();
    GlassFile result;
    try {
        result = is_yaml(lower(path.extension().string()))
                     ? glass_import::read_rii_page(bytes, file, "rii/" + stem)
                     : glass_import::read_agf(bytes, file, group_named(stem));
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw InputError(SourcePlace{file, 0, 0, {}}, error.sentence(), {}, error.hint());
    }
    if (!result.glasses.empty()) return result;
    throw InputError(SourcePlace{file, 0, 0, {}}, "no glass in it that can be used", {},
                     result.notes.empty() ? "" : result.notes.front().text);
}

Glass load_glass(const std::filesystem::path& path, const std::string& name, Diagnostics* notes) {
    GlassFile file = load_glass_file(path);
    if (name.empty() && file.glasses.size() > 1)
        throw InputError(
            SourcePlace{path.string(), 0, 0, {}},
            fmt::format("{} glasses in it, and none is named", file.glasses.size()), {},
            fmt::format("write {}#{}", path.filename().string(), bare_name(file.glasses.front())));
    std::vector<std::string> names;
    for (const Glass& glass : file.glasses) names.push_back(glass.name);
    const std::size_t found = name.empty() ? 0 : find_named("glass of this file", name, names);
    Glass glass = std::move(file.glasses[found]);
    // Notes about a glass of a catalogue begin with its name; a page is about one glass.
    for (const Diagnostic& note : file.notes)
        if (notes && (names.size() == 1 || note.text.starts_with(bare_name(glass) + ":")))
            notes->push_back(note);
    return glass;
}

}  // namespace dewbow
