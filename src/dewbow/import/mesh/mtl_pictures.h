// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pictures of a material library.

#include <filesystem>
#include <set>

#include "dewbow/import/mesh/mtl.h"
#include "dewbow/import/texture_picture.h"

namespace dewbow {

class MtlPictures {
public:
    /// @param library  the file; its pictures lie beside it or below.
    MtlPictures(const std::filesystem::path& library, std::shared_ptr<TexturePictures> pictures,
                Diagnostics& diagnostics)
        : library_(library), pictures_(std::move(pictures)), diagnostics_(diagnostics) {}

    const std::filesystem::path& library() const { return library_; }

    /// The picture with its options. nullptr, with a note, where it cannot be had.
    TexturePtr texture(const MtlMap& map, TextureCoding coding);
    /// The channel that -imfchan names (m, the matte, is alpha); for luminance and depth
    /// `otherwise`.
    int channel_of(const MtlMap& map, int otherwise) const;
    /// nullptr, with a note, where it cannot be had.
    std::shared_ptr<const TextureImage> image(const MtlMap& map);

private:
    std::filesystem::path library_;
    std::shared_ptr<TexturePictures> pictures_;
    Diagnostics& diagnostics_;
    std::set<std::string> missing_;  ///< have been noted
};

}  // namespace dewbow
