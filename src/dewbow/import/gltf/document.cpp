// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/document.h"

#include <fmt/format.h>

#include <algorithm>

#include "dewbow/base/file.h"
#include "dewbow/import/gltf/extensions.h"
#include "dewbow/import/gltf/meshopt.h"
#include "dewbow/import/gltf/slice.h"
#include "dewbow/import/gltf/uri.h"
#include "dewbow/import/nested_error.h"

namespace dewbow::gltf {

Document::Document(const std::filesystem::path& path, std::string_view bytes)
    : file_(path.string()),
      folder_(path.has_parent_path() ? path.parent_path() : "."),
      container_(open_container(file_, bytes)),
      tree_(parse_json(file_, container_.json)) {
    check_version();
    check_required_extensions();
}

void Document::check_version() const {
    const Json asset = root().require("asset");
    const Json version = asset.require("version");
    if (!version.text().starts_with("2.")) {
        version.fail(fmt::format("this is glTF {}; glTF 2.0 is read", version.text()));
    }
    const auto least = asset.find("minVersion");
    if (least && least->text() != "2.0") {
        least->fail(
            fmt::format("a reader of glTF {} is needed; this one reads 2.0", least->text()));
    }
}

void Document::check_required_extensions() const {
    const auto required = root().find("extensionsRequired");
    if (!required) return;
    for (std::size_t i = 0; i < required->size(); ++i) {
        const Json name = (*required)[i];
        if (may_be_required(name.text())) continue;
        name.fail(fmt::format("the file cannot be read without the extension {}", name.text()));
    }
}

std::size_t Document::count(std::string_view list) const {
    const auto array = root().find(list);
    return array ? array->size() : 0;
}

Json Document::item(std::string_view list, const Json& index) const {
    const std::size_t size = count(list);
    if (size == 0) index.fail(fmt::format("there are no {}", list));
    return (*root().find(list))[index.whole(size - 1)];
}

std::string_view Document::buffer(const Json& index) {
    const Json object = item("buffers", index);
    const std::size_t which = index.whole(count("buffers") - 1);
    const std::uint64_t length = object.require("byteLength").whole(kMaxFileBytes);
    const auto uri = object.find("uri");
    std::string_view bytes;
    if (!uri) {
        if (which != 0 || !container_.binary)
            object.fail("has no uri, and there is no .glb chunk for it");
        bytes = *container_.binary;
    } else {
        const auto found = loaded_.find(which);
        bytes = found != loaded_.end() ? found->second
                                       : loaded_.emplace(which, load(*uri)).first->second;
    }
    if (bytes.size() < length) {
        object.fail(fmt::format("byteLength is {}, but there are {} bytes", length, bytes.size()));
    }
    return bytes.substr(0, length);
}

std::string_view Document::part_of_buffer(const Json& part) {
    const std::string_view bytes = buffer(part.require("buffer"));
    const std::uint64_t length = part.require("byteLength").whole(kMaxFileBytes);
    const auto offset = part.find("byteOffset");
    const auto inside = slice(bytes, offset ? offset->whole(kMaxFileBytes) : 0, 1, length, 1);
    if (!inside) {
        part.fail(fmt::format("does not lie inside its buffer of {} bytes", bytes.size()));
    }
    return {inside->first, length};
}

Document::View Document::view(const Json& index) {
    constexpr std::uint64_t kMaxStride = 252;
    const Json object = item("bufferViews", index);
    const std::size_t which = index.whole(count("bufferViews") - 1);
    const auto stride = object.find("byteStride");
    View view{{}, stride ? stride->whole(kMaxStride) : 0, object.pointer()};
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        if (const auto compression = find_extension(object, name)) {
            view.bytes = unpacked(object, *compression, which);
            return view;
        }
    }
    view.bytes = part_of_buffer(object);
    return view;
}

std::string_view Document::unpacked(const Json& view, const Json& compression, std::size_t which) {
    const auto found = unpacked_.find(which);
    if (found != unpacked_.end()) return found->second;
    const std::uint64_t length = view.require("byteLength").whole(kMaxFileBytes);
    unpacked_bytes_ += length;
    if (unpacked_bytes_ > kMaxFileBytes)
        view.fail("the compressed views of the file hold more than 4 GiB");
    return unpacked_
        .emplace(which, unpack_meshopt(compression, part_of_buffer(compression), length))
        .first->second;
}

std::filesystem::path Document::path_of(const Json& uri) const {
    const auto reference = percent_decoded(uri.text());
    if (!reference) uri.fail("has a % that is not followed by two hexadecimal digits");
    try {
        return resolve_inside(folder_, *reference);
    } catch (const InputError& error) {
        uri.fail(sentence_with_place(error), error.hint());
    }
}

std::string Document::load(const Json& uri) const {
    if (is_data_uri(uri.text())) {
        auto bytes = decode_data_uri(uri.text());
        if (!bytes) uri.fail("is a data URI that is not valid base64");
        return std::move(*bytes);
    }
    const std::filesystem::path path = path_of(uri);
    try {
        return read_file(path);
    } catch (const InputError& error) {
        uri.fail(sentence_with_place(error), error.hint());
    }
}

std::optional<Json> find_extension(const Json& owner, std::string_view name) {
    const auto extensions = owner.find("extensions");
    return extensions ? extensions->find(name) : std::nullopt;
}

void note_extensions(Document& document, const Json& owner, std::span<const std::string_view> known,
                     const std::string& who) {
    const auto extensions = owner.find("extensions");
    if (!extensions) return;
    for (const std::string& name : extensions->keys()) {
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const Json extension = extensions->require(name);
        if (!changes_picture(name, extension)) continue;
        document.notes().add(extension.place(),
                             fmt::format("the extension {} of {{}} is not used", name), who);
    }
}

}  // namespace dewbow::gltf
