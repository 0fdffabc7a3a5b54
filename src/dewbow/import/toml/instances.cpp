// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/instances.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "dewbow/import/merge.h"
#include "dewbow/import/terrain/ground_height.h"
#include "dewbow/import/toml/placement.h"
#include "dewbow/import/toml/places.h"
#include "dewbow/import/toml/tables.h"

namespace dewbow::toml_import {
namespace {

/// One table of [[instances]].
struct Instances {
    TomlPlace of_place;
    std::string of;
    std::string group;  ///< that they are put into; empty = the scene
    std::optional<int> material;
    Affine placement;
    std::vector<Place> places;
};

/// The shapes of the scene whose names `value` states: one, or an array of them.
std::vector<const Shape*> named_shapes(const TomlDocument& document, const TomlValue& value,
                                       const Scene& scene) {
    std::vector<std::string> known;
    for (const Shape& shape : scene.shapes) known.push_back(shape.name);
    std::vector<const Shape*> found;
    const auto find = [&](const TomlValue& name) {
        const std::string& wanted = read_text(document, name, "on");
        const auto at = std::find(known.begin(), known.end(), wanted);
        if (at == known.end())
            fail(document, name.place, fmt::format("there is no shape \"{}\" to stand on", wanted),
                 hint_for(wanted, known));
        const Shape& shape = scene.shapes[std::size_t(at - known.begin())];
        if (!std::holds_alternative<std::shared_ptr<const Mesh>>(shape.geometry))
            fail(document, name.place,
                 fmt::format("\"{}\" is neither terrain nor a mesh, to stand on", wanted));
        found.push_back(&shape);
    };
    if (const TomlValue::Array* names = value.array())
        for (const TomlValue& name : *names) find(name);
    else
        find(value);
    return found;
}

/// Lifts places by the height of the ground that `on` names.
void stand_on(const TomlDocument& document, const TomlValue& on, const Scene& scene,
              std::vector<Place>& places) {
    const GroundHeight ground(named_shapes(document, on, scene));
    for (std::size_t i = 0; i < places.size(); ++i) {
        Vec3& position = places[i].position;
        const auto height_m = ground.at(position.x, position.z);
        if (!height_m)
            fail(document, on.place,
                 fmt::format("place {} (x = {}, z = {}) is beside the ground", i + 1, position.x,
                             position.z));
        position.y += *height_m;
    }
}

Instances read_one(const TomlDocument& document, const TomlValue& value, std::size_t number,
                   const MaterialNames& names, const std::filesystem::path& folder,
                   const Scene& scene) {
    Table table(document, value, fmt::format("instance {}", number));
    Instances result;
    const TomlValue& of = table.require("of");
    result.of_place = of.place;
    result.of = read_text(document, of, "of");
    result.group = table.text("group", "");
    if (const TomlValue* material = table.find("material"))
        result.material = names.read(document, *material, "material");
    result.placement = read_placement(table, false);
    result.places = read_places(table, folder);
    if (const TomlValue* on = table.find("on")) stand_on(document, *on, scene, result.places);
    table.finish();
    return result;
}

/// Finds out what instances make before they are made: groups that contain themselves, and too many
/// shapes.
class Census {
public:
    Census(const TomlDocument& document, const std::vector<Instances>& all, Groups& groups)
        : document_(document), all_(all), groups_(groups) {
        for (const Instances& one : all)
            if (!one.group.empty()) groups_[one.group];
    }

    /// Shapes and lights that one table makes.
    std::uint64_t count(const Instances& one, int depth = 0) {
        if (!groups_.has(one.of)) fail_unknown(one);
        const std::uint64_t made = size_of(one, depth) * one.places.size();
        total_ += made;
        if (total_ > kMostInstancedShapes)
            fail(document_, one.of_place,
                 fmt::format("the instances make {} shapes by here; {} are possible", total_,
                             kMostInstancedShapes));
        return made;
    }

private:
    static constexpr int kMaxDepth = 64;
    static constexpr std::uint64_t kUnderWay = ~std::uint64_t{0};

    [[noreturn]] void fail_unknown(const Instances& one) const {
        const std::string hint = hint_for(one.of, groups_.names());
        fail(document_, one.of_place, fmt::format("there is no group \"{}\"", one.of),
             hint.empty() ? fmt::format("shapes and imports with group = \"{}\" make one", one.of)
                          : hint);
    }

    /// Of the group that `one` places.
    std::uint64_t size_of(const Instances& one, int depth) {
        const auto [found, is_new] = sizes_.try_emplace(one.of, kUnderWay);
        if (!is_new && found->second != kUnderWay) return found->second;
        if (!is_new)
            fail(document_, one.of_place, fmt::format("the group \"{}\" contains itself", one.of));
        if (depth > kMaxDepth)
            fail(document_, one.of_place,
                 fmt::format("groups are nested more than {} deep", kMaxDepth));
        const Group& group = groups_[one.of];
        std::uint64_t size = group.shapes.size() + group.lights.size();
        for (const Instances& inner : all_)
            if (inner.group == one.of) size += count(inner, depth + 1);
        return sizes_[one.of] = size;
    }

    const TomlDocument& document_;
    const std::vector<Instances>& all_;
    Groups& groups_;
    std::map<std::string, std::uint64_t> sizes_;
    std::uint64_t total_ = 0;
};

/// Places groups, the inner ones first. All has been counted.
class Placer {
public:
    Placer(const std::vector<Instances>& all, Groups& groups) : all_(all), groups_(groups) {}

    void place(const Instances& one, std::vector<Shape>& shapes, std::vector<Light>& lights) {
        fill(one.of);
        const Group& group = groups_[one.of];
        shapes.reserve(shapes.size() + group.shapes.size() * one.places.size());
        for (const Place& place : one.places) {
            const Affine outer_from_group = place.affine() * one.placement;
            for (const Shape& shape : group.shapes) {
                Shape copy = shape;
                copy.world_from_object =
                    Transform<World, Object>(outer_from_group * shape.world_from_object.affine());
                copy.material = one.material.value_or(shape.material);
                shapes.push_back(mirrors_.upright(std::move(copy)));
            }
            for (const Light& light : group.lights)
                lights.push_back(moved(light, outer_from_group));
        }
    }

private:
    void fill(const std::string& name) {
        if (!filled_.insert(name).second) return;
        Group& group = groups_[name];
        for (const Instances& inner : all_)
            if (inner.group == name) place(inner, group.shapes, group.lights);
    }

    const std::vector<Instances>& all_;
    Groups& groups_;
    std::set<std::string> filled_;
    Mirrors mirrors_;
};

}  // namespace

void Groups::take(Table& table, Scene& scene, Mark mark) {
    const TomlValue* value = table.find("group");
    if (!value) return;
    const std::string& name = read_text(table.document(), *value, "group");
    if (name.empty()) fail(table.document(), value->place, "group is empty; it must be a name");
    Group& group = groups_[name];
    const auto first_shape = scene.shapes.begin() + std::ptrdiff_t(mark.shapes);
    std::move(first_shape, scene.shapes.end(), std::back_inserter(group.shapes));
    scene.shapes.erase(first_shape, scene.shapes.end());
    const auto first_light = scene.lights.begin() + std::ptrdiff_t(mark.lights);
    std::move(first_light, scene.lights.end(), std::back_inserter(group.lights));
    scene.lights.erase(first_light, scene.lights.end());
}

std::vector<std::string> Groups::names() const {
    std::vector<std::string> all;
    for (const auto& [name, group] : groups_) all.push_back(name);
    return all;
}

bool Groups::bring_light(const Scene& scene) const {
    Scene inside = make_empty_scene();
    inside.materials = scene.materials;
    for (const auto& [name, group] : groups_) {
        inside.shapes.insert(inside.shapes.end(), group.shapes.begin(), group.shapes.end());
        inside.lights.insert(inside.lights.end(), group.lights.begin(), group.lights.end());
    }
    return brings_light(inside);
}

void read_instances(const TomlDocument& document, const TomlValue* instances,
                    const MaterialNames& names, const std::filesystem::path& folder, Groups& groups,
                    Scene& scene) {
    std::vector<Instances> all;
    for_each_table(document, instances, "instances",
                   [&](const TomlValue& value, std::size_t number) {
                       all.push_back(read_one(document, value, number, names, folder, scene));
                   });
    Census census(document, all, groups);
    for (const Instances& one : all) census.count(one);
    Placer placer(all, groups);
    for (const Instances& one : all)
        if (one.group.empty()) placer.place(one, scene.shapes, scene.lights);
}

}  // namespace dewbow::toml_import
