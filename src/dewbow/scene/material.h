// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a surface does to light. A new kind is a struct here, its lobes in render/bsdf, and a row in
// the importers that know it.

#include <optional>
#include <string>
#include <variant>

#include "dewbow/scene/medium.h"

namespace dewbow {

/// Lambert's surface. `reflectance` in [0, 1].
struct Diffuse {
    SpectrumPtr reflectance;
};

/// A perfect mirror with `reflectance` in [0, 1] at every angle.
struct Mirror {
    SpectrumPtr reflectance;
};

/// The boundary of a transparent body, smooth (roughness 0) or rough (GGX, alpha = roughness²).
struct Dielectric {
    MediumPtr interior;
    double roughness = 0.0;
    /// Factor on light that crosses the boundary (glTF's base colour); nullptr = 1.
    SpectrumPtr tint;
};

/// A pane too thin to bend light: both its faces at once. [glTF: transmission without volume]
struct ThinDielectric {
    DispersionPtr index;
    SpectrumPtr tint;  ///< factor on transmitted light; nullptr = 1
};

/// glTF's metallic-roughness surface: GGX over Lambert, or a metal whose reflectance at normal
/// incidence is the base colour.
struct MetallicRoughness {
    SpectrumPtr base_colour;
    double metalness = 1.0;
    double roughness = 1.0;
    double ior = 1.5;
};

/// At each meeting with the surface light takes `second` with probability `second_share`, else
/// `first` (indices of materials). The parts give off no light of their own, and if both are
/// boundaries of bodies they have the same interior.
struct Mix {
    int first = 0, second = 0;
    double second_share = 0.5;
};

/// Reflects nothing.
struct Black {};

struct Material {
    std::string name;
    std::variant<Black, Diffuse, Mirror, Dielectric, ThinDielectric, MetallicRoughness, Mix>
        surface;
    /// Radiance that the surface gives off, W m⁻² sr⁻¹ nm⁻¹, the same in all directions; nullptr =
    /// none.
    SpectrumPtr emission;
    /// Whether both sides give off light, or only the one that the normal points to.
    bool two_sided_emission = false;
};

}  // namespace dewbow
