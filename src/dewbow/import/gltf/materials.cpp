// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/import/gltf/material_properties.h"
#include "dewbow/import/gltf/photometry.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::gltf {
namespace {

using Surface = decltype(Material::surface);

constexpr Vec3 kWhite{1.0, 1.0, 1.0};

Colour<LinearSrgb> colour_of(Vec3 rgb) { return {{rgb.x, rgb.y, rgb.z}}; }

ColourInput input_of(const ColourProperty& property, bool vertex_colours = false) {
    ColourInput input;
    input.texture = property.texture;
    input.vertex_colour = vertex_colours;
    if (input.varies())
        input.factor = colour_of(property.factor);
    else
        input.spectrum = make_reflectance(colour_of(property.factor));
    return input;
}

/// Indices are those against air, as glass makers and glTF's authors mean them.
DispersionData dispersion_of(const MaterialProperties& p) {
    if (p.glass) return find_glass(p.glass->text()).data;
    if (p.dispersion == 0.0) return {"constant", {p.ior}, IndexReference::air};
    return {"abbe", {p.ior, 20.0 / p.dispersion}, IndexReference::air};
}

DispersionPtr index_of(const MaterialProperties& p, const Json& material) {
    // The very function that surrounds bodies, so that nothing bends and nothing reflects.
    if (!p.glass && p.ior == 1.0) return air();
    try {
        return make_dispersion(dispersion_of(p));
    } catch (const InputError& error) {
        (p.glass ? *p.glass : material).fail(error.sentence(), error.hint());
    }
}

MediumPtr medium_of(const MaterialProperties& p, const Json& material) {
    auto medium = std::make_shared<Medium>();
    medium->name = p.name;
    medium->index = index_of(p, material);
    if (std::isfinite(p.attenuation_distance) && p.attenuation_colour != kWhite) {
        medium->absorption =
            make_absorption(colour_of(p.attenuation_colour), p.attenuation_distance * unit::m);
    }
    return medium;
}

class MaterialBuilder {
public:
    MaterialBuilder(Scene& scene, const Json& json, const MaterialProperties& properties,
                    bool vertex_colours)
        : scene_(scene), json_(json), p_(properties), vertex_colours_(vertex_colours) {}

    int build() {
        if (p_.unlit) return finished(add("", Black{}), p_.base_colour);
        return finished(p_.ior == 0.0 && !p_.glass ? total_reflector() : surface(), p_.emissive);
    }

private:
    int add(std::string_view part, Surface surface) {
        Material material;
        material.name = part.empty() ? p_.name : fmt::format("{}/{}", p_.name, part);
        material.surface = std::move(surface);
        return scene_.add(std::move(material));
    }

    /// The whole of the material, or the part of that name.
    int mix(std::string_view part, int first, int second, const NumberInput& second_share) {
        Mix mix;
        mix.first = first;
        mix.second = second;
        mix.second_share = second_share;
        return add(part, mix);
    }

    /// What is said of the material as a whole.
    int finished(int index, const ColourProperty& emission) {
        Material& material = scene_.materials[std::size_t(index)];
        if (emission.texture) {
            // (1, 1, 1) of a texture is as bright as that of make_emission.
            material.emission_texture =
                EmissionTexture{emission.texture, colour_of(emission.factor * one_nit())};
        } else {
            material.emission = photometric_spectrum(emission.factor, 1.0);
        }
        // glTF leaves open what the back of an emitter does; in Blender and three.js it glows too.
        material.two_sided_emission = material.gives_light();
        material.coverage = p_.coverage;
        if (material.coverage) material.coverage->vertex_alpha = vertex_colours_;
        material.normal_map = p_.normal_map;
        return index;
    }

    int surface() {
        if (p_.transmission == 0.0 || (p_.metallic == 1.0)) return add("", opaque(p_.metallic));
        const bool textured = p_.metallic.varies() || p_.transmission.varies();
        if (textured && !(p_.metallic == 0.0)) {
            const int metal = add("metal", opaque(1.0));
            return mix("", dielectric("dielectric", p_.transmission, 0.0), metal, p_.metallic);
        }
        const double m = p_.metallic.value;
        NumberInput share = p_.transmission;
        share.value *= 1.0 - m;
        const double rest = 1.0 - share.value;
        return dielectric("", share, rest > 0.0 ? std::min(m / rest, 1.0) : 1.0);
    }

    /// Glass of that share, beside what is opaque.
    int dielectric(std::string_view part, const NumberInput& glass_share, double metalness) {
        if (glass_share == 1.0) return add(part, glass());
        const int rest = add("opaque", opaque(metalness));
        return mix(part, rest, add("glass", glass()), glass_share);
    }

    Surface opaque(const NumberInput& metalness) const {
        MetallicRoughness s;
        s.base_colour = input_of(p_.base_colour, vertex_colours_);
        s.metalness = metalness;
        s.roughness = p_.roughness;
        s.ior = p_.ior;
        s.specular = p_.specular;
        if (!p_.specular_colour.is(kWhite)) s.specular_colour = input_of(p_.specular_colour);
        add_layers(s);
        return s;
    }

    void add_layers(MetallicRoughness& s) const {
        s.clearcoat = p_.clearcoat;
        s.clearcoat_roughness = p_.clearcoat_roughness;
        if (!p_.sheen_colour.is({})) s.sheen_colour = input_of(p_.sheen_colour);
        s.sheen_roughness = p_.sheen_roughness;
    }

    /// What KHR_materials_ior means by an index of 0: the part that is no metal reflects all.
    int total_reflector() {
        MetallicRoughness metal;
        metal.roughness = p_.roughness;
        metal.base_colour = input_of(p_.base_colour, vertex_colours_);
        if (p_.metallic == 1.0) return add("", metal);
        MetallicRoughness reflector = metal;
        reflector.base_colour = make_constant(1.0);
        if (p_.metallic == 0.0) return add("", reflector);
        const int first = add("reflector", reflector);
        return mix("", first, add("metal", metal), p_.metallic);
    }

    ColourInput tint() const {
        if (p_.base_colour.is(kWhite) && !vertex_colours_) return nullptr;
        return input_of(p_.base_colour, vertex_colours_);
    }

    Surface glass() const {
        if (p_.thickness > 0.0) return Dielectric{medium_of(p_, json_), p_.roughness, tint()};
        return ThinDielectric{index_of(p_, json_), tint(), p_.roughness};
    }

    Scene& scene_;
    const Json& json_;
    const MaterialProperties& p_;
    const bool vertex_colours_;
};

}  // namespace

int Materials::read(const std::optional<Json>& reference, bool vertex_colours) {
    if (!reference) {
        const auto [found, is_new] = default_.try_emplace(vertex_colours);
        if (is_new) {
            MetallicRoughness white;
            white.base_colour = input_of({kWhite}, vertex_colours);
            found->second = scene_.add({"default", white});
        }
        return found->second;
    }
    const Json material = document_.item("materials", *reference);
    const std::uint64_t index = reference->whole(document_.count("materials") - 1);
    const auto found = known_.find({index, vertex_colours});
    if (found != known_.end()) return found->second;
    const MaterialProperties properties = read_properties(document_, textures_, material);
    note_glass(properties);
    if (properties.unlit && vertex_colours) {
        document_.notes().add(material.place(),
                              "the vertex colours of {} are not used: it is unlit",
                              fmt::format("material \"{}\"", properties.name));
    }
    const int result = MaterialBuilder(scene_, material, properties, vertex_colours).build();
    known_.emplace(std::pair{index, vertex_colours}, result);
    return result;
}

void Materials::note_glass(const MaterialProperties& properties) {
    if (!properties.glass || properties.transmission == 0.0) return;
    try {
        const Glass& glass = find_glass(properties.glass->text());
        for (const auto& note : {range_warning(glass), birefringence_note(glass)})
            if (note) document_.notes().add(properties.glass->place(), *note, {});
    } catch (const InputError& error) {
        properties.glass->fail(error.sentence(), error.hint());
    }
}

}  // namespace dewbow::gltf
