// SPDX-License-Identifier: Apache-2.0
#pragma once

// Things that stand in many places. Shapes, imports and instances with `group = "NAME"` are not
// seen themselves; they make up the group of that name. [[instances]] tables place it:
//
//     of            the group
//     group         puts the instances into another group
//     material      instead of all materials that the group has
//     scale, rotate_…, position             where the group stands within each place (placement.h)
//     positions | file                      the places (places.h); one if left out
//     on            "shape" or ["shape", …]: the places' y is above the highest of these meshes

#include <filesystem>
#include <map>

#include "dewbow/import/toml/materials.h"

namespace dewbow::toml_import {

/// What a name stands for.
struct Group {
    std::vector<Shape> shapes;
    std::vector<Light> lights;
};

class Groups {
public:
    /// How much of a scene was there at some time.
    struct Mark {
        std::size_t shapes, lights;
    };
    static Mark mark(const Scene& scene) { return {scene.shapes.size(), scene.lights.size()}; }

    /// If `table` says `group`, moves what `scene` has had added since `mark` to that group.
    void take(Table& table, Scene& scene, Mark mark);
    Group& operator[](const std::string& name) { return groups_[name]; }
    bool has(const std::string& name) const { return groups_.contains(name); }
    std::vector<std::string> names() const;
    /// Whether a shape of a group gives off light, or a light is in one.
    bool bring_light(const Scene& scene) const;

private:
    std::map<std::string, Group> groups_;
};

/// Most shapes that the instances of a scene may make: with all that belongs to them about 8 GiB.
inline constexpr std::uint64_t kMostInstancedShapes = 20'000'000;

/// Adds the instances of the array `instances` to `scene`. nullptr adds none. Throws InputError
/// where one names no group, a group contains itself, or there are too many shapes.
void read_instances(const TomlDocument& document, const TomlValue* instances,
                    const MaterialNames& names, const std::filesystem::path& folder, Groups& groups,
                    Scene& scene);

}  // namespace dewbow::toml_import
