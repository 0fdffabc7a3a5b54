// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/materials.h"

#include <fmt/format.h>

#include "dewbow/import/toml/glass.h"
#include "dewbow/import/toml/spectra.h"
#include "dewbow/import/toml/textures.h"
#include "dewbow/optics/metal.h"

namespace dewbow::toml_import {
namespace {

using Surface = decltype(Material::surface);

constexpr Range kSurfaceIndexRange{1.0, 10.0};
constexpr int kMaxPriority = 1'000'000;

struct MaterialContext {
    const std::string& name;
    const MaterialNames& names;
    TextureFolder& pictures;
    Diagnostics& diagnostics;
};

/// The colour of `key`; nothing if it is not there.
ColourInput find_colour(Table& table, std::string_view key, const MaterialContext& context) {
    const TomlValue* value = table.find(key);
    return value ? read_colour(table.document(), *value, key, context.pictures) : ColourInput();
}

ColourInput require_colour(Table& table, std::string_view key, const MaterialContext& context) {
    return read_colour(table.document(), table.require(key), key, context.pictures);
}

NumberInput share(Table& table, std::string_view key, double otherwise,
                  const MaterialContext& context) {
    const TomlValue* value = table.find(key);
    return value ? read_share(table.document(), *value, key, context.pictures)
                 : NumberInput(otherwise);
}

Surface read_diffuse(Table& table, const MaterialContext& context) {
    return Diffuse{require_colour(table, "reflectance", context)};
}

Surface read_mirror(Table& table, const MaterialContext& context) {
    const ColourInput reflectance = find_colour(table, "reflectance", context);
    return Mirror{reflectance ? reflectance : ColourInput(make_constant(1.0))};
}

Surface read_glass(Table& table, const MaterialContext& context) {
    Dielectric glass;
    const auto priority = table.integer("priority", -kMaxPriority, kMaxPriority, 0);
    glass.interior = read_medium(table, context.name, int(priority), &context.diagnostics);
    glass.roughness = share(table, "roughness", 0.0, context);
    glass.tint = find_colour(table, "tint", context);
    return glass;
}

Surface read_thin_glass(Table& table, const MaterialContext& context) {
    ThinDielectric glass;
    glass.index = read_index(table, &context.diagnostics);
    glass.tint = find_colour(table, "tint", context);
    glass.roughness = share(table, "roughness", 0.0, context);
    return glass;
}

Surface read_metal(Table& table, const MaterialContext& context) {
    Conductor surface;
    const TomlDocument& document = table.document();
    for (const char* key : {"n", "k"}) table.at_most_one_of({"metal", key});
    if (const TomlValue* value = table.find("metal")) {
        const std::string& name = read_text(document, *value, "metal");
        const Metal& metal =
            at_place(document, value->place, [&]() -> const Metal& { return find_metal(name); });
        surface.n = metal.n, surface.k = metal.k;
    } else if (table.find("n") || table.find("k")) {
        surface.n = read_spectrum(document, table.require("n"), "n", SpectrumUse::index);
        surface.k = read_spectrum(document, table.require("k"), "k", SpectrumUse::index);
    } else {
        table.require("metal");
    }
    surface.roughness = share(table, "roughness", 0.0, context);
    return surface;
}

Surface read_metallic_roughness(Table& table, const MaterialContext& context) {
    MetallicRoughness surface;
    surface.base_colour = require_colour(table, "base_colour", context);
    surface.metalness = share(table, "metalness", surface.metalness.value, context);
    surface.roughness = share(table, "roughness", surface.roughness.value, context);
    surface.ior = table.number("ior", kSurfaceIndexRange, surface.ior);
    surface.specular = share(table, "specular", surface.specular.value, context);
    surface.specular_colour = find_colour(table, "specular_colour", context);
    surface.clearcoat = share(table, "clearcoat", 0.0, context);
    surface.clearcoat_roughness = share(table, "clearcoat_roughness", 0.0, context);
    surface.sheen_colour = find_colour(table, "sheen_colour", context);
    surface.sheen_roughness = share(table, "sheen_roughness", 0.0, context);
    return surface;
}

Surface read_mix(Table& table, const MaterialContext& context) {
    Mix mix;
    mix.first = context.names.read(table.document(), table.require("first"), "first");
    mix.second = context.names.read(table.document(), table.require("second"), "second");
    mix.second_share = share(table, "second_share", mix.second_share.value, context);
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
        {"metal", read_metal},
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

std::optional<Coverage> read_coverage(Table& table, TextureFolder& pictures) {
    const TomlValue* alpha = table.find("alpha");
    const auto cutoff = table.find_number("alpha_cutoff", kShareRange);
    const bool vertex_alpha = table.boolean("vertex_alpha", false);
    if (!alpha && !cutoff && !vertex_alpha) return std::nullopt;
    Coverage coverage;
    if (alpha) coverage.alpha = read_alpha(table.document(), *alpha, pictures);
    coverage.vertex_alpha = vertex_alpha;
    coverage.cutoff = cutoff;
    return coverage;
}

Material read_material(const TomlDocument& document, const TomlEntry& entry,
                       const MaterialNames& names, TextureFolder& pictures,
                       Diagnostics& diagnostics) {
    Table table(document, entry.value, fmt::format("[materials.{}]", entry.key));
    Material material;
    material.name = entry.key;
    material.surface = read_type(table).read(table, {entry.key, names, pictures, diagnostics});
    if (const TomlValue* emission = table.find("emission"))
        read_emission(document, *emission, pictures, material);
    material.two_sided_emission = table.boolean("two_sided_emission", false);
    material.coverage = read_coverage(table, pictures);
    if (const TomlValue* map = table.find("normal_map"))
        material.normal_map = read_normal_map(document, *map, pictures);
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
                             const std::filesystem::path& folder, Scene& scene,
                             Diagnostics& diagnostics) {
    MaterialNames names;
    if (!materials) return names;
    const Table check(document, *materials, "[materials]");
    // All names first: a mix may name a material that stands below it.
    const TomlValue::Table& entries = *materials->table();
    const std::size_t first = scene.materials.size();
    for (std::size_t i = 0; i < entries.size(); ++i) names.add(entries[i].key, int(first + i));
    TextureFolder pictures(folder);
    for (const TomlEntry& entry : entries)
        scene.add(read_material(document, entry, names, pictures, diagnostics));
    MixCheck(document, entries, scene, first).run();
    return names;
}

}  // namespace dewbow::toml_import
