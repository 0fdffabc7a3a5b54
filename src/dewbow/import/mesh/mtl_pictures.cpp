// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/mtl_pictures.h"

#include <fmt/format.h>

#include "dewbow/base/file.h"
#include "dewbow/import/nested_error.h"

namespace dewbow {

std::shared_ptr<const TextureImage> MtlPictures::image(const MtlMap& map) {
    const std::filesystem::path folder =
        library_.has_parent_path() ? library_.parent_path() : std::filesystem::path(".");
    try {
        return pictures_->load(resolve_inside(folder, map.file));
    } catch (const InputError& error) {
        if (!missing_.insert(map.file).second) return nullptr;
        const std::string text =
            fmt::format("the picture \"{}\" is not used: {}", map.file, sentence_with_place(error));
        const SourcePlace place{library_.string(), map.line, 0, {}};
        diagnostics_.push_back({place, text});
    }
    return nullptr;
}

TexturePtr MtlPictures::texture(const MtlMap& map, TextureCoding coding) {
    const auto picture = image(map);
    if (!picture) return nullptr;
    auto texture = std::make_shared<Texture>();
    texture->image = picture;
    texture->coding = coding;
    if (map.clamp) texture->wrap_u = texture->wrap_v = TextureWrap::clamp;
    // MTL scales and moves coordinates whose v grows upwards: v' = s v + o. Ours is 1 − v.
    texture->transform = {{{map.scale[0], 0.0, map.offset[0]},
                           {0.0, map.scale[1], 1.0 - map.scale[1] - map.offset[1]}}};
    return texture;
}

int MtlPictures::channel_of(const MtlMap& map, int otherwise) const {
    if (map.channel == 'r') return 0;
    if (map.channel == 'g') return 1;
    if (map.channel == 'b') return 2;
    if (map.channel == 'm') return 3;
    return otherwise;
}

}  // namespace dewbow
