// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/materials.h"

#include <fmt/format.h>

#include "dewbow/import/gltf/material_factors.h"
#include "dewbow/import/gltf/photometry.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::gltf {
namespace {

using Surface = decltype(Material::surface);

constexpr Vec3 kWhite{1.0, 1.0, 1.0};

Colour<LinearSrgb> colour_of(Vec3 rgb) { return {{rgb.x, rgb.y, rgb.z}}; }

SpectrumPtr tint_of(const MaterialFactors& factors) {
    return factors.base_colour == kWhite ? nullptr
                                         : make_reflectance(colour_of(factors.base_colour));
}

/// Indices are those against air, as glass makers and glTF's authors mean them.
DispersionData dispersion_of(const MaterialFactors& factors) {
    if (factors.glass) return find_glass(factors.glass->text()).data;
    if (factors.dispersion == 0.0) return {"constant", {factors.ior}, IndexReference::air};
    return {"abbe", {factors.ior, 20.0 / factors.dispersion}, IndexReference::air};
}

DispersionPtr index_of(const MaterialFactors& factors, const Json& material) {
    // The very function that surrounds bodies, so that nothing bends and nothing reflects.
    if (!factors.glass && factors.ior == 1.0) return air();
    try {
        return make_dispersion(dispersion_of(factors));
    } catch (const InputError& error) {
        (factors.glass ? *factors.glass : material).fail(error.sentence(), error.hint());
    }
}

MediumPtr medium_of(const MaterialFactors& factors, const Json& material) {
    auto medium = std::make_shared<Medium>();
    medium->name = factors.name;
    medium->index = index_of(factors, material);
    if (std::isfinite(factors.attenuation_distance) && factors.attenuation_colour != kWhite) {
        medium->absorption = make_absorption(colour_of(factors.attenuation_colour),
                                             factors.attenuation_distance * unit::m);
    }
    return medium;
}

/// A boundary that reflects all: what KHR_materials_ior means by an index of 0.
Surface total_reflector(const MaterialFactors& factors) {
    return MetallicRoughness{make_constant(1.0), 1.0, factors.roughness, 1.5};
}

class MaterialBuilder {
public:
    MaterialBuilder(Document& document, Scene& scene, const Json& json)
        : document_(document), scene_(scene), json_(json), factors_(read_factors(document, json)) {}

    int build() {
        const double glass_share = factors_.ior == 0.0 && !factors_.glass
                                       ? 0.0
                                       : (1.0 - factors_.metallic) * factors_.transmission;
        return mixed(opaque(glass_share), "opaque", glass_share, "glass",
                     glass_share > 0.0 ? glass() : Surface{});
    }

private:
    /// The material that is `second` with that share and `first` else; a mix only where there are
    /// two.
    int mixed(const Surface& first, const char* first_name, double second_share,
              const char* second_name, const Surface& second) {
        if (second_share <= 0.0) return add(factors_.name, first, true);
        if (second_share >= 1.0) return add(factors_.name, second, true);
        const int index = add(factors_.name, Black{}, true);
        Mix mix;
        mix.first = add(fmt::format("{}/{}", factors_.name, first_name), first, false);
        mix.second = add(fmt::format("{}/{}", factors_.name, second_name), second, false);
        mix.second_share = second_share;
        scene_.materials[std::size_t(index)].surface = mix;
        return index;
    }

    int add(const std::string& name, Surface surface, bool glows) {
        Material material{name, std::move(surface), nullptr, false};
        if (glows) material.emission = photometric_spectrum(factors_.emissive, 1.0);
        // glTF leaves open what the back of an emitter does; in Blender and three.js it glows too.
        material.two_sided_emission = material.emission != nullptr;
        return scene_.add(std::move(material));
    }

    Surface opaque(double glass_share) const {
        if (factors_.ior == 0.0) return opaque_reflector();
        const double rest = 1.0 - glass_share;
        const double metalness = rest > 0.0 ? factors_.metallic / rest : 1.0;
        return MetallicRoughness{make_reflectance(colour_of(factors_.base_colour)),
                                 std::min(metalness, 1.0), factors_.roughness, factors_.ior};
    }

    Surface opaque_reflector() const {
        if (factors_.metallic == 0.0) return total_reflector(factors_);
        // Metal of the base colour, and for the rest a boundary that is white: one metal between
        // the two.
        const double m = factors_.metallic;
        const Vec3 colour = factors_.base_colour * m + kWhite * (1.0 - m);
        return MetallicRoughness{make_reflectance(colour_of(colour)), 1.0, factors_.roughness, 1.5};
    }

    Surface glass() {
        if (factors_.thickness > 0.0) {
            return Dielectric{medium_of(factors_, json_), factors_.roughness, tint_of(factors_)};
        }
        if (factors_.roughness > 0.0) {
            document_.notes().add(json_.place(),
                                  "the roughness of {}, which is thin-walled, is not used",
                                  fmt::format("material \"{}\"", factors_.name));
        }
        return ThinDielectric{index_of(factors_, json_), tint_of(factors_)};
    }

    Document& document_;
    Scene& scene_;
    const Json& json_;
    const MaterialFactors factors_;
};

}  // namespace

int Materials::read(const std::optional<Json>& reference) {
    if (!reference) {
        if (!default_) {
            default_ = scene_.add(
                {"default", MetallicRoughness{make_constant(1.0), 1.0, 1.0, 1.5}, nullptr, false});
        }
        return *default_;
    }
    const Json material = document_.item("materials", *reference);
    const std::uint64_t index = reference->whole(document_.count("materials") - 1);
    const auto found = known_.find(index);
    if (found != known_.end()) return found->second;
    const int result = MaterialBuilder(document_, scene_, material).build();
    known_.emplace(index, result);
    return result;
}

}  // namespace dewbow::gltf
