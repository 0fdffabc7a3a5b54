// SPDX-License-Identifier: Apache-2.0
#pragma once

// One glTF file that is being read.

#include <filesystem>
#include <map>

#include "dewbow/import/gltf/container.h"
#include "dewbow/import/gltf/notes.h"
#include "dewbow/import/json/json.h"

namespace dewbow::gltf {

class Document {
public:
    /// `bytes` must outlive this. Checks version and required extensions. Throws InputError.
    Document(const std::filesystem::path& path, std::string_view bytes);
    Document(const Document&) = delete;

    Json root() const { return Json(file_, tree_); }
    Notes& notes() { return notes_; }

    /// Item `index` of the array `list` at the root. InputError at `index` if there is none.
    Json item(std::string_view list, const Json& index) const;
    /// How many there are; 0 if the array is missing.
    std::size_t count(std::string_view list) const;

    /// The bytes of buffer `index`, loaded when first asked for.
    std::string_view buffer(const Json& index);

private:
    std::string load_buffer(const Json& uri) const;
    void check_version() const;
    void check_required_extensions() const;

    std::string file_;
    std::filesystem::path folder_;
    Container container_;
    JsonValue tree_;
    Notes notes_;
    std::map<std::size_t, std::string> loaded_;
};

/// The extension object `name` of `owner`, or nothing.
std::optional<Json> find_extension(const Json& owner, std::string_view name);

/// Notes each extension of `owner` that is not in `known` and changes the picture.
/// @param who  'material "gold"', for messages.
void note_extensions(Document& document, const Json& owner, std::span<const std::string_view> known,
                     const std::string& who);

}  // namespace dewbow::gltf
