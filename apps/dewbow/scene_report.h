// SPDX-License-Identifier: Apache-2.0
#pragma once

// What is in a scene, and what of it will cost time, light or memory.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "dewbow/scene/scene.h"

namespace dewbow {

struct MaterialFacts {
    std::string name, kind;  ///< "glass", "diffuse"…, as scene files call them
    std::size_t shapes = 0;  ///< that wear it
    bool glows = false;
    std::string glass;          ///< of the catalogue, if the index is one of it
    std::optional<double> n_d;  ///< against air, of what is inside
    std::optional<double> v_d;  ///< nothing without dispersion
    std::optional<double> roughness;
};

struct TextureFacts {
    std::string name;
    int width = 0, height = 0, bits = 8;
    std::uint64_t bytes = 0;
};

/// The light of a dome of sky.
struct SkyFacts {
    double illuminance_lx = 0.0;  ///< on level ground
    double zenith_cd_m2 = 0.0;    ///< luminance straight overhead
};
/// A distant light: a sun or a moon.
struct DistantFacts {
    double altitude_deg = 0.0, azimuth_deg = 0.0;  ///< of where it stands, from north over east
    double illuminance_lx = 0.0;                   ///< on a surface that faces it
};

/// A rain, where its density is 1.
struct RainFacts {
    std::string name, region;  ///< "500 m thick"
    double drops_per_m3 = 0.0, mm_per_h = 0.0;
    double extinction_per_km = 0.0;       ///< at kExtinctionWavelength
    std::optional<double> optical_depth;  ///< of that, through the region's thinnest way
};

/// Something that costs, and why.
struct Cost {
    std::string what, why;
};

struct SceneReport {
    std::map<std::string, std::size_t> shapes;  ///< by type
    std::size_t meshes = 0;                     ///< different ones
    std::uint64_t triangles = 0;                ///< of these, each once
    std::uint64_t placed_triangles = 0;         ///< of all shapes
    std::map<std::string, std::size_t> lights;  ///< by type; "glowing shape" too
    std::vector<SkyFacts> skies;
    std::vector<DistantFacts> distant;
    std::vector<RainFacts> rains;
    std::vector<MaterialFacts> materials;
    std::vector<TextureFacts> textures;
    Bounds bounds;  ///< of all but infinite planes, m
    std::uint64_t mesh_bytes = 0, texture_bytes = 0, shape_bytes = 0;
    std::vector<Cost> costs;

    std::uint64_t bytes() const { return mesh_bytes + texture_bytes + shape_bytes; }
};

SceneReport report_of(const Scene& scene);

}  // namespace dewbow
