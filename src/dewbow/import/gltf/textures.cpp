// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/textures.h"

#include <fmt/format.h>

#include <cmath>

#include "dewbow/base/file.h"
#include "dewbow/import/gltf/uri.h"
#include "dewbow/import/nested_error.h"

namespace dewbow::gltf {
namespace {

/// OpenGL's numbers. [glTF 2.0, 5.26 Sampler]
constexpr std::uint64_t kNearest = 9728, kClamp = 33071, kMirror = 33648, kRepeat = 10497;
constexpr std::uint64_t kMostEnum = 0xffff;

TextureWrap wrap_of(const Json& sampler, std::string_view key) {
    const auto mode = sampler.find(key);
    if (!mode) return TextureWrap::repeat;
    switch (mode->whole(kMostEnum)) {
        case kClamp:
            return TextureWrap::clamp;
        case kMirror:
            return TextureWrap::mirror;
        case kRepeat:
            return TextureWrap::repeat;
        default:
            mode->fail("is no way of wrapping",
                       "expected 10497 (repeat), 33648 (mirrored) or 33071 (clamp)");
    }
}

void read_sampler(const Json& sampler, Texture& texture) {
    texture.wrap_u = wrap_of(sampler, "wrapS");
    texture.wrap_v = wrap_of(sampler, "wrapT");
    const auto filter = sampler.find("magFilter");
    texture.interpolates = !(filter && filter->whole(kMostEnum) == kNearest);
}

/// Scaled, turned counter-clockwise as seen in the picture (v grows downwards), moved.
void read_transform(const Json& extension, Texture& texture) {
    const auto pair = [&](std::string_view key, double otherwise) {
        const auto member = extension.find(key);
        return member ? member->numbers(2, kCoordinateRange)
                      : std::vector<double>{otherwise, otherwise};
    };
    const std::vector<double> offset = pair("offset", 0.0), scale = pair("scale", 1.0);
    const double angle = extension.number("rotation", kCoordinateRange, 0.0);
    const double c = std::cos(angle), s = std::sin(angle);
    texture.transform = {
        {{c * scale[0], s * scale[1], offset[0]}, {-s * scale[0], c * scale[1], offset[1]}}};
}

/// The set of coordinates; KHR_texture_transform's own choice wins.
std::uint64_t texcoord_set(const Json& info, const std::optional<Json>& transform) {
    constexpr std::uint64_t kMostSets = 1000;
    auto set = info.find("texCoord");
    if (transform)
        if (const auto own = transform->find("texCoord")) set = own;
    return set ? set->whole(kMostSets) : 0;
}

}  // namespace

TexturePtr Textures::read(const Json& info, TextureCoding coding, std::string_view what,
                          const std::string& who) {
    const Json json = document_.item("textures", info.require("index"));
    auto texture = std::make_shared<Texture>();
    texture->coding = coding;
    const auto transform = find_extension(info, "KHR_texture_transform");
    const std::uint64_t set = texcoord_set(info, transform);
    if (set > 1) {
        document_.notes().add(
            info.place(),
            fmt::format("the {} of {{}} is not used: it is laid on by TEXCOORD_{}", what, set),
            who);
        return nullptr;
    }
    texture->texcoord_set = int(set);
    if (transform) read_transform(*transform, *texture);
    if (const auto sampler = json.find("sampler"))
        read_sampler(document_.item("samplers", *sampler), *texture);
    texture->image = picture(json, what, who);
    return texture->image ? texture : nullptr;
}

std::shared_ptr<const TextureImage> Textures::picture(const Json& texture, std::string_view what,
                                                      const std::string& who) {
    if (const auto source = texture.find("source")) return image(*source, what, who);
    constexpr std::pair<std::string_view, std::string_view> kForeign[] = {
        {"EXT_texture_webp", "a WebP"},
        {"KHR_texture_basisu", "a KTX2"},
        {"MSFT_texture_dds", "a DDS"},
        {"EXT_texture_avif", "an AVIF"}};
    std::string_view format;
    for (const auto& [extension, name] : kForeign)
        if (find_extension(texture, extension)) format = name;
    document_.notes().add(
        texture.place(),
        format.empty()
            ? fmt::format("the {} of {{}} is not used: it has no picture", what)
            : fmt::format("the {} of {{}} is not used: {} picture is not read", what, format),
        who);
    return nullptr;
}

std::shared_ptr<const TextureImage> Textures::image(const Json& reference, std::string_view what,
                                                    const std::string& who) {
    const Json json = document_.item("images", reference);
    const auto uri = json.find("uri");
    const std::string name =
        uri && !is_data_uri(uri->text()) ? uri->text() : json.text("name", json.pointer());
    std::string key = json.pointer(), loaded;
    std::string_view bytes;
    if (uri) {
        if (!is_data_uri(uri->text())) key = document_.path_of(*uri).string();
        if (auto known = pictures_.find(key)) return known;
        bytes = loaded = document_.load(*uri);
    } else {
        const Document::View view = document_.view(json.require("bufferView"));
        key = view.pointer;
        bytes = view.bytes;
    }
    if (const std::string_view format = foreign_picture_format(bytes); !format.empty()) {
        document_.notes().add(
            json.place(),
            fmt::format("the {} of {{}} is not used: {} picture is not read", what, format), who);
        return nullptr;
    }
    try {
        return pictures_.decode(key, bytes, name);
    } catch (const InputError& error) {
        (uri ? *uri : json).fail(sentence_with_place(error), error.hint());
    }
}

}  // namespace dewbow::gltf
