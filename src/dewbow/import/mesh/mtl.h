// SPDX-License-Identifier: Apache-2.0
#pragma once

// MTL, the material libraries of OBJ files, as they are written; mtl_material.h says what surfaces
// they become.
//
//     newmtl NAME
//     Kd, Ks, Ke, Tf          r g b in linear sRGB (one number: grey)
//     Ns, Ni, d, Tr, illum    exponent, index, opacity, 1 − opacity, illumination model
//     Pr, Pm, Ps, Pc, Pcr     roughness, metalness, sheen, clearcoat and its roughness
//     map_Kd, map_Ks, map_Ke, map_d, map_Pr, map_Pm, map_Bump (bump), norm   [OPTIONS] FILE
//     # dewbow: glass NAME    a glass of the catalogue, in a comment that other programs pass over
//
// [Alias|Wavefront, "MTL material format", 1995; the P… statements: Exocortex, "Extending Wavefront
// MTL for Physically-Based", 2014]

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dewbow/base/error.h"

namespace dewbow {

using MtlColour = std::array<double, 3>;

/// A picture with its options.
struct MtlMap {
    std::string file;
    std::size_t line = 0;
    std::array<double, 2> offset{0.0, 0.0}, scale{1.0, 1.0};  ///< -o, -s
    bool clamp = false;                                       ///< -clamp on
    double bump = 1.0;                                        ///< -bm
    std::optional<char> channel;                              ///< -imfchan: r g b m l z
};

struct MtlMaterial {
    std::string name;
    std::size_t line = 0;
    /// By the statement's word: "Kd", "Ks", "Ke", "Tf".
    std::map<std::string, MtlColour, std::less<>> colours;
    /// "Ns", "Ni", "d" (Tr is turned into it), "illum", "Pr", "Pm", "Ps", "Pc", "Pcr".
    std::map<std::string, double, std::less<>> numbers;
    /// "Kd", "Ks", "Ke", "d", "Pr", "Pm", "bump", "norm".
    std::map<std::string, MtlMap, std::less<>> maps;
    std::string glass;  ///< empty = none
    std::size_t glass_line = 0;
};

/// @param file  name for messages.
/// Numbers outside their range are held in it, and other statements passed over, each kind noted
/// once with its line. Throws InputError with line and excerpt (not a number, no newmtl above).
std::vector<MtlMaterial> parse_mtl(const std::string& file, std::string_view text,
                                   Diagnostics& diagnostics);

}  // namespace dewbow
