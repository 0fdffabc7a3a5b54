// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/texture_picture.h"

#include <fmt/format.h>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/jpeg.h"
#include "dewbow/image/png.h"

namespace dewbow {
namespace {

/// Formats that scene files name and that are not read, by what their files hold at `offset`.
struct ForeignFormat {
    std::string_view name;
    std::size_t offset;
    std::string_view mark;
};
constexpr ForeignFormat kForeign[] = {
    {"a WebP", 8, "WEBP"},
    {"a KTX2", 0, "\xabKTX 20"},
    {"a Basis Universal", 0, "sB"},
    {"a DDS", 0, "DDS "},
    {"an AVIF", 4, "ftypavif"},
    {"a GIF", 0, "GIF8"},
    {"a TIFF", 0, std::string_view("II*\0", 4)},
    {"a TIFF", 0, std::string_view("MM\0*", 4)},
    {"an OpenEXR", 0, "\x76\x2f\x31\x01"},
    {"a Radiance", 0, "#?"},
    {"a BMP", 0, "BM"},
};

[[noreturn]] void refuse(std::string_view bytes, const std::string& name) {
    const SourcePlace place{name, 0, 0, {}};
    if (const std::string_view format = foreign_picture_format(bytes); !format.empty())
        throw InputError(place, fmt::format("this is {} picture; textures are PNG or JPEG", format),
                         {}, "save it as PNG");
    throw InputError(place, bytes.empty() ? "is empty" : "is neither a PNG nor a JPEG picture");
}

TextureImage from_rgb(const Image8& rgb) {
    TextureImage image;
    image.width = rgb.width, image.height = rgb.height;
    image.texels8.reserve(rgb.rgb.size() / 3 * 4);
    for (std::size_t i = 0; i + 2 < rgb.rgb.size(); i += 3)
        image.texels8.insert(image.texels8.end(),
                             {rgb.rgb[i], rgb.rgb[i + 1], rgb.rgb[i + 2], 255});
    return image;
}

TextureImage from_rgba(ImageRgba&& rgba) {
    TextureImage image;
    image.width = rgba.width, image.height = rgba.height, image.bits = rgba.bits;
    image.texels8 = std::move(rgba.values8);
    image.texels16 = std::move(rgba.values16);
    return image;
}

}  // namespace

std::string_view foreign_picture_format(std::string_view bytes) {
    for (const ForeignFormat& format : kForeign)
        if (bytes.size() >= format.offset && bytes.substr(format.offset).starts_with(format.mark))
            return format.name;
    return {};
}

std::shared_ptr<const TextureImage> decode_texture(std::string_view bytes,
                                                   const std::string& name) {
    if (!is_png(bytes) && !is_jpeg(bytes)) refuse(bytes, name);
    TextureImage image = is_png(bytes) ? from_rgba(decode_png_rgba(bytes, name))
                                       : from_rgb(decode_jpeg(bytes, name));
    image.name = name;
    return std::make_shared<const TextureImage>(std::move(image));
}

std::shared_ptr<const TextureImage> TexturePictures::load(const std::filesystem::path& path) {
    const std::string key = "file:" + path.lexically_normal().string();
    const auto known = find(key);
    return known ? known : decode(key, read_file(path), path.string());
}

std::shared_ptr<const TextureImage> TexturePictures::find(const std::string& key) const {
    const auto found = known_.find(key);
    return found != known_.end() ? found->second : nullptr;
}

std::shared_ptr<const TextureImage> TexturePictures::decode(const std::string& key,
                                                            std::string_view bytes,
                                                            const std::string& name) {
    if (auto known = find(key)) return known;
    auto image = decode_texture(bytes, name);
    bytes_ += image->texels8.size() + 2 * image->texels16.size();
    if (bytes_ > kMaxTextureBytes) {
        throw InputError(
            SourcePlace{name, 0, 0, {}},
            fmt::format("with this picture the textures exceed {} GiB", kMaxTextureBytes >> 30));
    }
    known_.emplace(key, image);
    return image;
}

}  // namespace dewbow
