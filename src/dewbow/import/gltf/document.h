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

    /// A buffer view, unpacked if it is compressed.
    struct View {
        std::string_view bytes;
        std::uint64_t stride = 0;  ///< 0: elements follow each other
        std::string pointer;       ///< for messages
    };
    /// The view that `index` refers to, loaded when first asked for.
    View view(const Json& index);
    /// The bytes that `uri` names: a data URI, or a file in this one's folder. InputError there.
    std::string load(const Json& uri) const;
    /// The file that `uri`, which is no data URI, names.
    std::filesystem::path path_of(const Json& uri) const;

private:
    std::string_view buffer(const Json& index);
    std::string_view part_of_buffer(const Json& part);
    std::string_view unpacked(const Json& view, const Json& compression, std::size_t which);
    void check_version() const;
    void check_required_extensions() const;

    std::string file_;
    std::filesystem::path folder_;
    Container container_;
    JsonValue tree_;
    Notes notes_;
    std::map<std::size_t, std::string> loaded_;    ///< buffers
    std::map<std::size_t, std::string> unpacked_;  ///< compressed views
    std::uint64_t unpacked_bytes_ = 0;
};

/// The extension object `name` of `owner`, or nothing.
std::optional<Json> find_extension(const Json& owner, std::string_view name);

/// Notes each extension of `owner` that is not in `known` and changes the picture.
/// @param who  'material "gold"', for messages.
void note_extensions(Document& document, const Json& owner, std::span<const std::string_view> known,
                     const std::string& who);

}  // namespace dewbow::gltf
