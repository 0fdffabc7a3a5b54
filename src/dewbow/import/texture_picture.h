// SPDX-License-Identifier: Apache-2.0
#pragma once

// Files of pictures as textures.

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "dewbow/scene/texture.h"

namespace dewbow {

/// Most bytes that the texels of one scene file may take in memory: sixty-four pictures of 8192²
/// pixels.
inline constexpr std::uint64_t kMaxTextureBytes = std::uint64_t{16} << 30;

/// A PNG or JPEG in memory, whichever it is by its first bytes. Grey and palettes become RGB; alpha
/// is 1 where the file has none; 16 bits stay 16. Throws InputError naming `name`; limits are those
/// of image/limits.h.
std::shared_ptr<const TextureImage> decode_texture(std::string_view bytes, const std::string& name);

/// "a WebP", "a KTX2"…: what `bytes` are a picture of that is not read; empty for PNG, JPEG and
/// what is no picture.
std::string_view foreign_picture_format(std::string_view bytes);

/// The pictures of one scene file, each read once however many textures show it.
class TexturePictures {
public:
    /// The picture of a file. Throws InputError naming the file.
    std::shared_ptr<const TextureImage> load(const std::filesystem::path& path);
    /// The picture that is known by `key`, or nullptr.
    std::shared_ptr<const TextureImage> find(const std::string& key) const;
    /// The picture in `bytes`, known by `key` from then on. Throws InputError naming `name`.
    std::shared_ptr<const TextureImage> decode(const std::string& key, std::string_view bytes,
                                               const std::string& name);

private:
    std::map<std::string, std::shared_ptr<const TextureImage>> known_;
    std::uint64_t bytes_ = 0;
};

}  // namespace dewbow
