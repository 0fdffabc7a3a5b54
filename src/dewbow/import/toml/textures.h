// SPDX-License-Identifier: Apache-2.0
#pragma once

// Inputs of materials that may be pictures. Where a colour or a number is wanted, a scene file may
// write the name of a picture, or
//
//     { texture = "wood.png",
//       factor = 0.5 | [r, g, b]                 times the picture
//       channel = "r" | "g" | "b" | "a"          for numbers
//       coding = "srgb" | "linear"               colours: srgb; numbers and normals: linear
//       wrap = "repeat" | "mirror" | "clamp"     or two of them, for u and v
//       filter = "linear" | "nearest"
//       uv_scale = [2, 2], uv_rotate_deg = 0, uv_offset = [0, 0], uv_set = 0 }
//
// and for a colour { vertex_colour = true, factor = … } too: those of the mesh.

#include <filesystem>

#include "dewbow/import/texture_picture.h"
#include "dewbow/import/toml/table.h"
#include "dewbow/scene/material.h"

namespace dewbow::toml_import {

/// The pictures of a scene file, which lie in its folder or below.
class TextureFolder {
public:
    explicit TextureFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The picture that `value` names, or InputError at it.
    std::shared_ptr<const TextureImage> load(const TomlDocument& document, const TomlValue& value);

private:
    std::filesystem::path folder_;
    TexturePictures pictures_;
};

/// A reflectance or a tint.
ColourInput read_colour(const TomlDocument& document, const TomlValue& value, std::string_view name,
                        TextureFolder& pictures);
/// A number from 0 to 1.
NumberInput read_share(const TomlDocument& document, const TomlValue& value, std::string_view name,
                       TextureFolder& pictures);
/// A share whose channel is the picture's alpha, or red where it has none.
NumberInput read_alpha(const TomlDocument& document, const TomlValue& value,
                       TextureFolder& pictures);
/// Reads `emission`: a spectrum, or a picture with `scale` or `luminance_cd_m2` of its white.
void read_emission(const TomlDocument& document, const TomlValue& value, TextureFolder& pictures,
                   Material& material);
/// A picture, with `scale` = 1 for how much it tilts.
NormalMap read_normal_map(const TomlDocument& document, const TomlValue& value,
                          TextureFolder& pictures);

}  // namespace dewbow::toml_import
