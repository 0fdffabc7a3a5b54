// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a surface does to light. A new kind is a struct here, its lobes in render/surface, and a row
// in the importers that know it.

#include <optional>
#include <string>
#include <variant>

#include "dewbow/scene/medium.h"
#include "dewbow/scene/surface_input.h"

namespace dewbow {

/// Lambert's surface. `reflectance` in [0, 1].
struct Diffuse {
    ColourInput reflectance;
};

/// A perfect mirror with `reflectance` in [0, 1] at every angle.
struct Mirror {
    ColourInput reflectance;
};

/// The boundary of a transparent body, smooth (roughness 0) or rough (GGX, alpha = roughness²).
struct Dielectric {
    MediumPtr interior;
    NumberInput roughness{};
    /// Factor on light that crosses the boundary (glTF's base colour); empty = 1.
    ColourInput tint{};
};

/// A pane too thin to bend light: both its faces at once. [glTF: transmission without volume]
struct ThinDielectric {
    DispersionPtr index;
    ColourInput tint{};  ///< factor on transmitted light; empty = 1
    NumberInput roughness{};
};

/// A bare metal with measured index n + i k, smooth (roughness 0) or rough (GGX).
struct Conductor {
    SpectrumPtr n, k;  ///< against vacuum
    NumberInput roughness{};
};

/// glTF's metallic-roughness surface: GGX over Lambert, or a metal whose reflectance at normal
/// incidence is the base colour; with the layers of KHR_materials_specular, _clearcoat, _sheen.
struct MetallicRoughness {
    ColourInput base_colour;
    NumberInput metalness = 1.0;
    NumberInput roughness = 1.0;
    double ior = 1.5;
    NumberInput specular = 1.0;     ///< factor on what the dielectric part reflects
    ColourInput specular_colour{};  ///< factor on its reflectance at normal incidence; empty = 1
    NumberInput clearcoat{};        ///< strength of a layer of index 1.5 on top
    NumberInput clearcoat_roughness{};
    ColourInput sheen_colour{};  ///< of fibres on top; empty = none
    NumberInput sheen_roughness{};
};

/// At each meeting with the surface light takes `second` with probability `second_share`, else
/// `first` (indices of materials). The parts give off no light of their own, and if both are
/// boundaries of bodies they have the same interior.
struct Mix {
    int first = 0, second = 0;
    NumberInput second_share = 0.5;
};

/// Reflects nothing.
struct Black {};

/// Radiance from a picture: factor × texel, where (1, 1, 1) is D65 of the radiance whose Y is that
/// of the constant spectrum 1 W m⁻² sr⁻¹ nm⁻¹.
struct EmissionTexture {
    TexturePtr texture;
    Colour<LinearSrgb> factor{{1.0, 1.0, 1.0}};
};

/// How much of a surface is there: alpha, from 0 (a hole) to 1.
struct Coverage {
    NumberInput alpha = 1.0;
    bool vertex_alpha = false;     ///< times the alpha of the mesh's colours
    std::optional<double> cutoff;  ///< all or nothing: there where alpha >= cutoff
};

/// Tilts the shading normal: texels 2 rgb − 1 in the frame of tangent, bitangent and normal.
struct NormalMap {
    TexturePtr texture;
    double scale = 1.0;  ///< factor on x and y
};

struct Material {
    std::string name;
    std::variant<Black, Diffuse, Mirror, Dielectric, ThinDielectric, Conductor, MetallicRoughness,
                 Mix>
        surface;
    /// Radiance that the surface gives off, W m⁻² sr⁻¹ nm⁻¹, the same in all directions; nullptr =
    /// none.
    SpectrumPtr emission{};
    /// Whether both sides give off light, or only the one that the normal points to.
    bool two_sided_emission = false;
    /// Instead of `emission`: light that differs from place to place.
    std::optional<EmissionTexture> emission_texture{};
    std::optional<Coverage> coverage{};  ///< none: all of it is there
    std::optional<NormalMap> normal_map{};

    bool gives_light() const { return emission || emission_texture; }
};

}  // namespace dewbow
