// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/materials.h"

#include <fmt/format.h>

#include "dewbow/import/toml/glass.h"
#include "dewbow/import/toml/spectra.h"

namespace dewbow::toml_import {
namespace {

using Surface = decltype(Material::surface);

constexpr Range kSurfaceIndexRange{1.0, 10.0};
constexpr int kMaxPriority = 1'000'000;

struct MaterialContext {
    const std::string& name;
    const MaterialNames& names;
};

SpectrumPtr required_share(Table& table, std::string_view key) {
    return read_spectrum(table.document(), table.require(key), key, SpectrumUse::share);
}

SpectrumPtr optional_share(Table& table, std::string_view key) {
    const TomlValue* value = table.find(key);
    return value ? read_spectrum(table.document(), *value, key, SpectrumUse::share) : nullptr;
}

Surface read_diffuse(Table& table, const MaterialContext&) {
    return Diffuse{required_share(table, "reflectance")};
}

Surface read_mirror(Table& table, const MaterialContext&) {
    const SpectrumPtr reflectance = optional_share(table, "reflectance");
    return Mirror{reflectance ? reflectance : make_constant(1.0)};
}

Surface read_glass(Table& table, const MaterialContext& context) {
    Dielectric glass;
    const auto priority = table.integer("priority", -kMaxPriority, kMaxPriority, 0);
    glass.interior = read_medium(table, context.name, int(priority));
    glass.roughness = table.number("roughness", kShareRange, 0.0);
    glass.tint = optional_share(table, "tint");
    return glass;
}

Surface read_thin_glass(Table& table, const MaterialContext&) {
    return ThinDielectric{read_index(table), optional_share(table, "tint")};
}

Surface read_metallic_roughness(Table& table, const MaterialContext&) {
    MetallicRoughness surface;
    surface.base_colour = required_share(table, "base_colour");
    surface.metalness = table.number("metalness", kShareRange, surface.metalness.value);
    surface.roughness = table.number("roughness", kShareRange, surface.roughness.value);
    surface.ior = table.number("ior", kSurfaceIndexRange, surface.ior);
    return surface;
}

Surface read_mix(Table& table, const MaterialContext& context) {
    Mix mix;
    mix.first = context.names.read(table.document(), table.require("first"), "first");
    mix.second = context.names.read(table.document(), table.require("second"), "second");
    mix.second_share = table.number("second_share", kShareRange, mix.second_share.value);
    return mix;
}

Surface read_black(Table&, const MaterialContext&) { return Black{}; }

struct MaterialType {
    std::string name;
    Surface (*read)(Table&, const MaterialContext&);
};

const std::vector<MaterialType>& material_types() {
    static const std::vector<MaterialType> types = {
        {"diffuse", read_diffuse},
        {"mirror", read_mirror},
        {"glass", read_glass},
        {"thin-glass", read_thin_glass},
        {"metallic-roughness", read_metallic_roughness},
        {"mix", read_mix},
        {"black", read_black},
    };
    return types;
}

const MaterialType& read_type(Table& table) {
    std::vector<std::string> names;
    for (const MaterialType& type : material_types()) names.push_back(type.name);
    const TomlValue& value = table.require("type");
    return material_types()[read_choice(table.document(), value, "material type", names)];
}

Material read_material(const TomlDocument& document, const TomlEntry& entry,
                       const MaterialNames& names) {
    Table table(document, entry.value, fmt::format("[materials.{}]", entry.key));
    Material material;
    material.name = entry.key;
    material.surface = read_type(table).read(table, {entry.key, names});
    if (const TomlValue* emission = table.find("emission")) {
        material.emission = read_spectrum(document, *emission, "emission", SpectrumUse::radiance);
    }
    material.two_sided_emission = table.boolean("two_sided_emission", false);
    table.finish();
    return material;
}

/// Finds mixes that contain themselves while their place in the file is known.
class MixCheck {
public:
    /// The materials of `entries` stand in `scene` from index `first` on.
    MixCheck(const TomlDocument& document, const TomlValue::Table& entries, const Scene& scene,
             std::size_t first)
        : document_(document),
          entries_(entries),
          scene_(scene),
          first_(first),
          visits_(entries.size(), Visit::not_yet) {}

    void run() {
        for (std::size_t i = 0; i < entries_.size(); ++i) enter(i, 0);
    }

private:
    enum class Visit : char { not_yet, under_way, done };
    static constexpr int kMaxDepth = 64;

    void enter(std::size_t i, int depth) {
        if (visits_[i] == Visit::done) return;
        if (visits_[i] == Visit::under_way)
            fail(document_, entries_[i].key_place,
                 fmt::format("the mix [materials.{}] contains itself", entries_[i].key));
        if (depth > kMaxDepth)
            fail(document_, entries_[i].key_place,
                 fmt::format("mixes are nested more than {} deep", kMaxDepth));
        visits_[i] = Visit::under_way;
        if (const auto* mix = std::get_if<Mix>(&scene_.materials[first_ + i].surface)) {
            enter(std::size_t(mix->first) - first_, depth + 1);
            enter(std::size_t(mix->second) - first_, depth + 1);
        }
        visits_[i] = Visit::done;
    }

    const TomlDocument& document_;
    const TomlValue::Table& entries_;
    const Scene& scene_;
    std::size_t first_;
    std::vector<Visit> visits_;
};

}  // namespace

void MaterialNames::add(const std::string& name, int index) {
    indices_.emplace(name, index);
    names_.push_back(name);
}

int MaterialNames::read(const TomlDocument& document, const TomlValue& value,
                        std::string_view key) const {
    const std::string& name = read_text(document, value, key);
    const auto found = indices_.find(name);
    if (found != indices_.end()) return found->second;
    fail(document, value.place, fmt::format("there is no material \"{}\"", name),
         hint_for(name, names_));
}

MaterialNames read_materials(const TomlDocument& document, const TomlValue* materials,
                             Scene& scene) {
    MaterialNames names;
    if (!materials) return names;
    const Table check(document, *materials, "[materials]");
    // All names first: a mix may name a material that stands below it.
    const TomlValue::Table& entries = *materials->table();
    const std::size_t first = scene.materials.size();
    for (std::size_t i = 0; i < entries.size(); ++i) names.add(entries[i].key, int(first + i));
    for (const TomlEntry& entry : entries) scene.add(read_material(document, entry, names));
    MixCheck(document, entries, scene, first).run();
    return names;
}

}  // namespace dewbow::toml_import
