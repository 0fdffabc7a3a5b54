// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/material_factors.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewbow::gltf {
namespace {

constexpr std::string_view kKnownExtensions[] = {
    "KHR_materials_dispersion", "KHR_materials_emissive_strength",
    "KHR_materials_ior",        "KHR_materials_transmission",
    "KHR_materials_volume",
};
/// Writers round: what exceeds 1 by less than this is 1.
constexpr double kRounding = 1e-4;
constexpr Range kFactorRange{0.0, 1.0 + kRounding};
constexpr Range kIndexRange{0.0, 10.0};
constexpr Range kDispersionRange{0.0, 1e4};
constexpr Range kDistanceRange{0.0, kHuge, true, false};

double factor(const Json& object, std::string_view key, double otherwise) {
    return std::min(object.number(key, kFactorRange, otherwise), 1.0);
}

Vec3 colour_factor(const Json& object, std::string_view key) {
    return min(object.vec3(key, kFactorRange, {1.0, 1.0, 1.0}), {1.0, 1.0, 1.0});
}

class FactorReader {
public:
    FactorReader(Document& document, const Json& material)
        : document_(document), material_(material) {
        factors_.name = material.text("name", "");
        if (factors_.name.empty()) {
            factors_.name =
                "material " + material.pointer().substr(material.pointer().rfind('/') + 1);
        }
        who_ = fmt::format("material \"{}\"", factors_.name);
    }

    MaterialFactors read() {
        note_extensions(document_, material_, kKnownExtensions, who_);
        if (const auto pbr = material_.find("pbrMetallicRoughness")) read_metallic_roughness(*pbr);
        read_index();
        read_transmission();
        read_emission();
        read_alpha();
        note_texture(material_, "normalTexture", "normal", true);
        if (const auto extras = material_.find("extras")) read_extras(*extras);
        return factors_;
    }

private:
    /// @param matters  whether the texture would show.
    void note_texture(const Json& owner, std::string_view key, std::string_view kind,
                      bool matters) {
        const auto texture = owner.find(key);
        if (!texture || !matters) return;
        document_.notes().add(texture->place(),
                              fmt::format("the {} texture of {{}} is not used", kind), who_);
    }

    void read_metallic_roughness(const Json& pbr) {
        if (const auto colour = pbr.find("baseColorFactor")) {
            const std::vector<double> rgba = colour->numbers(4, kFactorRange);
            factors_.base_colour = min({rgba[0], rgba[1], rgba[2]}, {1.0, 1.0, 1.0});
            alpha_ = rgba[3];
        }
        factors_.metallic = factor(pbr, "metallicFactor", 1.0);
        factors_.roughness = factor(pbr, "roughnessFactor", 1.0);
        note_texture(pbr, "baseColorTexture", "base colour", factors_.base_colour != Vec3{});
        note_texture(pbr, "metallicRoughnessTexture", "metallic-roughness",
                     factors_.metallic > 0.0 || factors_.roughness > 0.0);
        has_alpha_texture_ = pbr.find("baseColorTexture").has_value();
    }

    void read_index() {
        const auto extension = find_extension(material_, "KHR_materials_ior");
        if (!extension) return;
        factors_.ior = extension->number("ior", kIndexRange, factors_.ior);
        if (factors_.ior > 0.0 && factors_.ior < 1.0) {
            extension->require("ior").fail(fmt::format("is {}; it must be 0 or between 1 and {}",
                                                       factors_.ior, kIndexRange.high));
        }
    }

    void read_transmission() {
        if (const auto extension = find_extension(material_, "KHR_materials_transmission")) {
            factors_.transmission = factor(*extension, "transmissionFactor", 0.0);
            note_texture(*extension, "transmissionTexture", "transmission",
                         factors_.transmission > 0.0);
        }
        if (const auto extension = find_extension(material_, "KHR_materials_volume")) {
            factors_.thickness = extension->number("thicknessFactor", kAmountRange, 0.0);
            factors_.attenuation_distance = extension->number("attenuationDistance", kDistanceRange,
                                                              factors_.attenuation_distance);
            factors_.attenuation_colour = colour_factor(*extension, "attenuationColor");
        }
        if (const auto extension = find_extension(material_, "KHR_materials_dispersion")) {
            factors_.dispersion = extension->number("dispersion", kDispersionRange, 0.0);
        }
    }

    void read_emission() {
        factors_.emissive = material_.vec3("emissiveFactor", kAmountRange, {});
        if (const auto extension = find_extension(material_, "KHR_materials_emissive_strength")) {
            factors_.emissive *= extension->number("emissiveStrength", kAmountRange, 1.0);
        }
        const auto texture = material_.find("emissiveTexture");
        if (!texture || factors_.emissive == Vec3{}) return;
        // Most such textures are black but for a few places: all of the factor would drown the
        // picture.
        document_.notes().add(texture->place(),
                              "the emissive texture of {} is not used; without it nothing glows",
                              who_);
        factors_.emissive = {};
    }

    void read_alpha() {
        const std::string mode = material_.text("alphaMode", "OPAQUE");
        const double cutoff = material_.number("alphaCutoff", kAmountRange, 0.5);
        const bool blends = mode == "BLEND" && (alpha_ < 1.0 || has_alpha_texture_);
        const bool masks = mode == "MASK" && (alpha_ < cutoff || has_alpha_texture_);
        if (!blends && !masks) return;
        document_.notes().add(
            material_.place(),
            fmt::format("alphaMode {} of {{}} is not used: all of it is there", mode), who_);
    }

    void read_extras(const Json& extras) {
        // Other programs put anything here; what is called dewbow is ours.
        if (!extras.is_object()) return;
        if (const auto own = extras.find("dewbow")) factors_.glass = own->find("glass");
    }

    Document& document_;
    const Json& material_;
    std::string who_;
    MaterialFactors factors_;
    double alpha_ = 1.0;
    bool has_alpha_texture_ = false;
};

}  // namespace

MaterialFactors read_factors(Document& document, const Json& material) {
    return FactorReader(document, material).read();
}

}  // namespace dewbow::gltf
