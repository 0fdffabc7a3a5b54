// SPDX-License-Identifier: Apache-2.0
#pragma once

// Fractal ground: a height field as a mesh.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/scene/shape.h"

namespace dewbow {

/// A valley along a line through the middle: relief is multiplied by
/// 1 − depth · exp(−(d / width)²), d being the distance from that line.
struct Valley {
    Angle azimuth = 0.0 * unit::deg;  ///< where it leads: from −z (north) towards +x (east)
    Length width = 100.0 * unit::m;   ///< > 0
    double depth = 0.9;               ///< 0 to 1
};

/// What fractal ground looks like.
///
/// Its relief is Musgrave's hybrid multifractal: octaves of gradient noise, each 1.92 times as fine
/// as the one before and 1.92^(roughness − 1) times as high, each multiplied by what the coarser
/// ones came to, so that low ground is smooth and heights are rugged.
///           [Musgrave, Kolb & Mace, "The synthesis and rendering of eroded fractal terrains",
///            SIGGRAPH 1989; Musgrave in Ebert et al., "Texturing and Modeling", 3rd ed., §16.3]
struct Terrain {
    Length size = 1000.0 * unit::m;    ///< edge of its square
    Length height = 100.0 * unit::m;   ///< from the lowest to the highest point of the fractal
    Length feature = 500.0 * unit::m;  ///< wavelength of the largest hills
    double roughness = 0.25;           ///< 0 smooth, 1 as rugged at all scales
    std::uint64_t seed = 0;
    int cells = 256;  ///< along an edge, 2 to kMostTerrainCells
    /// Cells in the middle are this many times smaller than even ones would be, ≥ 1.
    double middle_finer = 1.0;
    std::optional<Valley> valley;
    /// Relief falls to 0 at the border, so that the ground stands on its surroundings as a hill.
    bool island = false;

    /// Linear sRGB from the lowest ground to the highest; none: the mesh has no colours.
    std::vector<std::array<float, 3>> colours;
    /// How far noise moves the choice of a colour, as a share of them all: patches.
    double mottling = 0.0;
};

inline constexpr int kMostTerrainCells = 2048;

/// The mesh: x and z from −size/2 to size/2, y up from 0, smooth normals, texture coordinates 0 to
/// 1 along x and z, front faces upwards. Octaves whose waves are shorter than two to four cells
/// fade out. A function of its argument alone.
std::shared_ptr<const Mesh> make_terrain(const Terrain& terrain);

}  // namespace dewbow
