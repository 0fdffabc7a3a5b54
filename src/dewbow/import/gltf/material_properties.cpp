// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/material_properties.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewbow::gltf {
namespace {

constexpr std::string_view kKnownExtensions[] = {
    "KHR_materials_clearcoat", "KHR_materials_dispersion",   "KHR_materials_emissive_strength",
    "KHR_materials_ior",       "KHR_materials_sheen",        "KHR_materials_specular",
    "KHR_materials_unlit",     "KHR_materials_transmission", "KHR_materials_volume",
};
/// Writers round: what exceeds 1 by less than this is 1.
constexpr double kRounding = 1e-4;
constexpr Range kFactorRange{0.0, 1.0 + kRounding};
constexpr Range kIndexRange{0.0, 10.0};
constexpr Range kDispersionRange{0.0, 1e4};
constexpr Range kDistanceRange{0.0, kHuge, true, false};
constexpr Vec3 kWhite{1.0, 1.0, 1.0};

enum TextureChannel { kRed = 0, kGreen = 1, kBlue = 2, kAlpha = 3 };

double factor(const Json& object, std::string_view key, double otherwise) {
    return std::min(object.number(key, kFactorRange, otherwise), 1.0);
}

Vec3 colour_factor(const Json& object, std::string_view key, Vec3 otherwise) {
    return min(object.vec3(key, kFactorRange, otherwise), kWhite);
}

class PropertyReader {
public:
    PropertyReader(Document& document, Textures& textures, const Json& material)
        : document_(document), textures_(textures), material_(material) {
        p_.name = material.text("name", "");
        if (p_.name.empty())
            p_.name = "material " + material.pointer().substr(material.pointer().rfind('/') + 1);
        who_ = fmt::format("material \"{}\"", p_.name);
    }

    MaterialProperties read() {
        note_extensions(document_, material_, kKnownExtensions, who_);
        const auto pbr = material_.find("pbrMetallicRoughness");
        if (pbr) read_base_colour(*pbr);
        read_alpha();
        p_.unlit = find_extension(material_, "KHR_materials_unlit").has_value();
        if (p_.unlit) return p_;
        if (pbr) read_metallic_roughness(*pbr);
        read_index();
        read_transmission();
        read_volume();
        read_layers();
        read_emission();
        read_normal_map();
        if (const auto extras = material_.find("extras")) read_extras(*extras);
        return p_;
    }

private:
    TexturePtr texture(const Json& owner, std::string_view key, TextureCoding coding,
                       std::string_view what) {
        const auto info = owner.find(key);
        return info ? textures_.read(*info, coding, what, who_) : nullptr;
    }
    TexturePtr colours(const Json& owner, std::string_view key, std::string_view what) {
        return texture(owner, key, TextureCoding::srgb, what);
    }
    /// `value` times a channel of the texture `key`, which is read only where it matters.
    NumberInput number(double value, const Json& owner, std::string_view key,
                       TextureChannel channel, std::string_view what) {
        NumberInput input = value;
        if (value == 0.0) return input;
        const bool srgb_colours = channel == kAlpha;  // alpha beside colours; it is linear itself
        input.texture =
            texture(owner, key, srgb_colours ? TextureCoding::srgb : TextureCoding::linear, what);
        input.channel = channel;
        return input;
    }

    void read_base_colour(const Json& pbr) {
        if (const auto colour = pbr.find("baseColorFactor")) {
            const std::vector<double> rgba = colour->numbers(4, kFactorRange);
            p_.base_colour.factor = min({rgba[0], rgba[1], rgba[2]}, kWhite);
            alpha_.value = std::min(rgba[3], 1.0);
        }
        p_.base_colour.texture = colours(pbr, "baseColorTexture", "base colour texture");
        alpha_.texture = p_.base_colour.texture;
        alpha_.channel = kAlpha;
    }

    void read_metallic_roughness(const Json& pbr) {
        p_.metallic = factor(pbr, "metallicFactor", 1.0);
        p_.roughness = factor(pbr, "roughnessFactor", 1.0);
        if (p_.metallic == 0.0 && p_.roughness == 0.0) return;
        const TexturePtr both = texture(pbr, "metallicRoughnessTexture", TextureCoding::linear,
                                        "metallic-roughness texture");
        if (p_.metallic.value > 0.0) p_.metallic.texture = both, p_.metallic.channel = kBlue;
        if (p_.roughness.value > 0.0) p_.roughness.texture = both, p_.roughness.channel = kGreen;
    }

    void read_index() {
        const auto extension = find_extension(material_, "KHR_materials_ior");
        if (!extension) return;
        p_.ior = extension->number("ior", kIndexRange, p_.ior);
        if (p_.ior > 0.0 && p_.ior < 1.0) {
            extension->require("ior").fail(
                fmt::format("is {}; it must be 0 or between 1 and {}", p_.ior, kIndexRange.high));
        }
    }

    void read_transmission() {
        const auto extension = find_extension(material_, "KHR_materials_transmission");
        if (!extension) return;
        p_.transmission = number(factor(*extension, "transmissionFactor", 0.0), *extension,
                                 "transmissionTexture", kRed, "transmission texture");
    }

    /// The texture of thicknesses is for renderers that cannot follow rays.
    void read_volume() {
        if (const auto extension = find_extension(material_, "KHR_materials_volume")) {
            p_.thickness = extension->number("thicknessFactor", kAmountRange, 0.0);
            p_.attenuation_distance =
                extension->number("attenuationDistance", kDistanceRange, p_.attenuation_distance);
            p_.attenuation_colour = colour_factor(*extension, "attenuationColor", kWhite);
        }
        if (const auto extension = find_extension(material_, "KHR_materials_dispersion"))
            p_.dispersion = extension->number("dispersion", kDispersionRange, 0.0);
    }

    void read_layers() {
        if (const auto e = find_extension(material_, "KHR_materials_specular")) read_specular(*e);
        if (const auto e = find_extension(material_, "KHR_materials_clearcoat")) read_clearcoat(*e);
        if (const auto e = find_extension(material_, "KHR_materials_sheen")) read_sheen(*e);
    }

    void read_specular(const Json& extension) {
        p_.specular = number(factor(extension, "specularFactor", 1.0), extension, "specularTexture",
                             kAlpha, "specular texture");
        const Vec3 colour = extension.vec3("specularColorFactor", kAmountRange, kWhite);
        p_.specular_colour.factor = min(colour, kWhite);
        if (p_.specular_colour.factor != colour) {
            document_.notes().add(extension.place(),
                                  "the specular colour of {} is above 1 and counts as 1", who_);
        }
        p_.specular_colour.texture =
            colours(extension, "specularColorTexture", "specular colour texture");
    }

    void read_clearcoat(const Json& extension) {
        p_.clearcoat = number(factor(extension, "clearcoatFactor", 0.0), extension,
                              "clearcoatTexture", kRed, "clearcoat texture");
        if (p_.clearcoat == 0.0) return;
        p_.clearcoat_roughness =
            number(factor(extension, "clearcoatRoughnessFactor", 0.0), extension,
                   "clearcoatRoughnessTexture", kGreen, "clearcoat roughness texture");
        if (const auto map = extension.find("clearcoatNormalTexture")) {
            document_.notes().add(map->place(), "the clearcoat normal texture of {} is not used",
                                  who_);
        }
    }

    void read_sheen(const Json& extension) {
        p_.sheen_colour.factor = colour_factor(extension, "sheenColorFactor", {});
        if (p_.sheen_colour.factor == Vec3{}) return;
        p_.sheen_colour.texture = colours(extension, "sheenColorTexture", "sheen colour texture");
        p_.sheen_roughness = number(factor(extension, "sheenRoughnessFactor", 0.0), extension,
                                    "sheenRoughnessTexture", kAlpha, "sheen roughness texture");
    }

    void read_emission() {
        p_.emissive.factor = material_.vec3("emissiveFactor", kAmountRange, {});
        if (const auto extension = find_extension(material_, "KHR_materials_emissive_strength"))
            p_.emissive.factor *= extension->number("emissiveStrength", kAmountRange, 1.0);
        if (p_.emissive.factor == Vec3{} || !material_.find("emissiveTexture")) return;
        p_.emissive.texture = colours(material_, "emissiveTexture", "emissive texture");
        // Most such textures are black but for a few places: all of the factor would drown the
        // picture.
        if (!p_.emissive.texture) p_.emissive.factor = {};
    }

    void read_normal_map() {
        const auto info = material_.find("normalTexture");
        if (!info) return;
        const double scale = info->number("scale", kCoordinateRange, 1.0);
        const TexturePtr map =
            texture(material_, "normalTexture", TextureCoding::linear, "normal texture");
        if (map && scale != 0.0) p_.normal_map = NormalMap{map, scale};
    }

    void read_alpha() {
        const std::string mode = material_.text("alphaMode", "OPAQUE");
        if (mode == "OPAQUE") return;
        if (mode != "MASK" && mode != "BLEND") {
            material_.require("alphaMode")
                .fail(fmt::format("\"{}\" is no mode of alpha", mode),
                      "expected OPAQUE, MASK or BLEND");
        }
        Coverage coverage;
        coverage.alpha = alpha_;
        if (mode == "MASK") coverage.cutoff = material_.number("alphaCutoff", kAmountRange, 0.5);
        p_.coverage = coverage;
    }

    void read_extras(const Json& extras) {
        // Other programs put anything here; what is called dewbow is ours. Blender's custom
        // properties stand side by side.
        if (!extras.is_object()) return;
        if (const auto own = extras.find("dewbow")) p_.glass = own->find("glass");
        const auto custom = extras.find("glass");
        if (!p_.glass && custom && custom->is_text()) p_.glass = custom;
        if (p_.glass && p_.transmission == 0.0) {
            document_.notes().add(
                p_.glass->place(),
                "the glass of {} is not used: the material lets no light through (transmission)",
                who_);
        }
    }

    Document& document_;
    Textures& textures_;
    const Json& material_;
    std::string who_;
    MaterialProperties p_;
    NumberInput alpha_ = 1.0;
};

}  // namespace

MaterialProperties read_properties(Document& document, Textures& textures, const Json& material) {
    return PropertyReader(document, textures, material).read();
}

}  // namespace dewbow::gltf
