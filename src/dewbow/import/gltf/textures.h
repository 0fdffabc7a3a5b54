// SPDX-License-Identifier: Apache-2.0
#pragma once

// Textures: what materials' textureInfo objects refer to.

#include "dewbow/import/gltf/document.h"
#include "dewbow/import/texture_picture.h"

namespace dewbow::gltf {

class Textures {
public:
    explicit Textures(Document& document) : document_(document) {}

    /// The texture that `info` names, with KHR_texture_transform. nullptr, which is noted, where
    /// its picture is of a format that is not read (WebP, KTX2) or missing in the file, or where it
    /// is laid on by coordinates beyond the second set. Throws InputError: a file that is missing,
    /// a picture that is damaged.
    /// @param what  "normal texture"; @param who  'material "gold"'.
    TexturePtr read(const Json& info, TextureCoding coding, std::string_view what,
                    const std::string& who);

private:
    std::shared_ptr<const TextureImage> picture(const Json& texture, std::string_view what,
                                                const std::string& who);
    std::shared_ptr<const TextureImage> image(const Json& reference, std::string_view what,
                                              const std::string& who);

    Document& document_;
    TexturePictures pictures_;
};

}  // namespace dewbow::gltf
