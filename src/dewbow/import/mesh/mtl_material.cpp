// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/mesh/mtl_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/import/named_glass.h"
#include "dewbow/import/nested_error.h"
#include "dewbow/import/texture_facts.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow {
namespace {

using Surface = decltype(Material::surface);

/// Index of glTF's surfaces, of which 1 is a file's way of saying nothing.
constexpr double kUsualIndex = 1.5;
constexpr MtlColour kBlack{0.0, 0.0, 0.0}, kWhite{1.0, 1.0, 1.0};

class Converter {
public:
    Converter(const MtlMaterial& material, MtlPictures& pictures, Diagnostics& diagnostics)
        : mtl_(material),
          file_(pictures.library().string()),
          diagnostics_(diagnostics),
          pictures_(pictures) {}

    Material convert() {
        Material material;
        material.name = mtl_.name;
        const bool is_glass = !mtl_.glass.empty() || asks_for_glass();
        material.surface = is_glass ? glass() : opaque();
        if (!is_glass) material.coverage = coverage();
        give_light(material);
        material.normal_map = normal_map();
        return material;
    }

private:
    double number(std::string_view word, double otherwise) const {
        const auto found = mtl_.numbers.find(word);
        return found == mtl_.numbers.end() ? otherwise : found->second;
    }
    bool has_number(std::string_view word) const { return mtl_.numbers.contains(word); }
    MtlColour colour(std::string_view word, MtlColour otherwise) const {
        const auto found = mtl_.colours.find(word);
        return found == mtl_.colours.end() ? otherwise : found->second;
    }
    const MtlMap* map(std::string_view word) const {
        const auto found = mtl_.maps.find(word);
        return found == mtl_.maps.end() ? nullptr : &found->second;
    }
    int illumination() const { return int(number("illum", 2.0)); }

    /// Colours that a map stands beside are factors on it; without a word of theirs they are 1.
    ColourInput colour_input(std::string_view word, MtlColour otherwise) {
        const MtlMap* picture = map(word);
        const MtlColour c = colour(word, picture ? kWhite : otherwise);
        const Colour<LinearSrgb> rgb{{c[0], c[1], c[2]}};
        ColourInput input(make_reflectance(rgb));
        input.factor = rgb;
        if (picture) input.texture = pictures_.texture(*picture, TextureCoding::srgb);
        return input;
    }

    NumberInput number_input(std::string_view word, double otherwise) {
        const MtlMap* picture = map(word);
        NumberInput input(number(word, picture ? 1.0 : otherwise));
        if (!picture) return input;
        input.texture = pictures_.texture(*picture, TextureCoding::linear);
        if (input.texture) input.channel = pictures_.channel_of(*picture, 0);
        return input;
    }

    /// "Transparency: glass on" (4, 6, 7, 9), with an index that bends.
    bool asks_for_glass() const {
        const int model = illumination();
        return (model == 4 || model == 6 || model == 7 || model == 9) && number("Ni", 1.0) > 1.0;
    }

    DispersionPtr index() {
        if (mtl_.glass.empty())
            return make_dispersion({"constant", {number("Ni", 1.0)}, IndexReference::air});
        try {
            return named_glass(mtl_.glass, {file_, mtl_.glass_line, 0, {}}, &diagnostics_);
        } catch (const InputError& error) {
            throw InputError({file_, mtl_.glass_line, 0, {}}, sentence_with_place(error), {},
                             error.hint());
        }
    }

    Surface glass() {
        Dielectric body;
        auto medium = std::make_shared<Medium>();
        medium->name = mtl_.name;
        medium->index = index();
        body.interior = medium;
        body.roughness = number_input("Pr", 0.0);
        const MtlColour filter = colour("Tf", kWhite);
        if (filter != kWhite) body.tint = make_reflectance({{filter[0], filter[1], filter[2]}});
        return body;
    }

    bool is_physically_based() const {
        const auto has = [&](const char* word) { return has_number(word) || map(word); };
        return has("Pr") || has("Pm") || has("Ps") || has("Pc");
    }

    Surface opaque() {
        if (is_physically_based()) return metallic_roughness();
        const int model = illumination();
        const bool glossy = model >= 2 && (colour("Ks", kBlack) != kBlack || map("Ks"));
        if (!glossy) return Diffuse{colour_input("Kd", kBlack)};
        if (model == 3 && colour("Kd", kBlack) == kBlack && !map("Kd"))
            return Mirror{colour_input("Ks", kBlack)};
        return phong();
    }

    double surface_index() const {
        const double index = number("Ni", kUsualIndex);
        return index > 1.0 ? index : kUsualIndex;
    }

    Surface metallic_roughness() {
        MetallicRoughness surface;
        surface.base_colour = colour_input("Kd", kBlack);
        surface.ior = surface_index();
        surface.metalness = number_input("Pm", 0.0);
        surface.roughness = number_input("Pr", 1.0);
        surface.clearcoat = number("Pc", 0.0);
        surface.clearcoat_roughness = number("Pcr", 0.0);
        if (const double sheen = number("Ps", 0.0); sheen > 0.0) {
            surface.sheen_colour = make_constant(sheen);
            surface.sheen_roughness = surface.roughness;
        }
        return surface;
    }

    Surface phong() {
        MetallicRoughness surface;
        surface.base_colour = colour_input("Kd", kBlack);
        surface.ior = surface_index();
        surface.metalness = 0.0;
        surface.roughness = roughness_of_exponent(number("Ns", 0.0));
        surface.specular_colour = colour_input("Ks", kBlack);
        return surface;
    }

    std::optional<Coverage> coverage() {
        const MtlMap* picture = map("d");
        const double opacity = number("d", 1.0);
        if (!picture && opacity == 1.0) return std::nullopt;
        Coverage result;
        result.alpha = opacity;
        if (!picture) return result;
        result.alpha.texture = pictures_.texture(*picture, TextureCoding::linear);
        if (result.alpha.texture)
            result.alpha.channel =
                pictures_.channel_of(*picture, coverage_channel(*result.alpha.texture->image));
        return result;
    }

    void give_light(Material& material) {
        const MtlMap* picture = map("Ke");
        const MtlColour c = colour("Ke", picture ? kWhite : kBlack);
        if (c == kBlack) return;
        material.two_sided_emission = true;
        const Colour<LinearSrgb> rgb{{c[0], c[1], c[2]}};
        const TexturePtr texture =
            picture ? pictures_.texture(*picture, TextureCoding::srgb) : nullptr;
        if (texture) {
            material.emission_texture = EmissionTexture{texture, rgb};
        } else {
            material.emission = make_emission(rgb);
        }
    }

    /// Programs write normal maps as `norm` or as `map_Bump`; heights, which the latter means, are
    /// grey.
    std::optional<NormalMap> normal_map() {
        const MtlMap* picture = map("norm");
        if (!picture) {
            picture = map("bump");
            if (!picture) return std::nullopt;
            const auto image = pictures_.image(*picture);
            if (image && is_grey(*image)) {
                diagnostics_.push_back({{file_, picture->line, 0, {}},
                                        "heights (a grey map_Bump) are not used; normal maps are"});
                return std::nullopt;
            }
        }
        const TexturePtr texture = pictures_.texture(*picture, TextureCoding::linear);
        if (!texture) return std::nullopt;
        return NormalMap{texture, picture->bump};
    }

    const MtlMaterial& mtl_;
    std::string file_;
    Diagnostics& diagnostics_;
    MtlPictures& pictures_;
};

}  // namespace

double roughness_of_exponent(double exponent) {
    const double alpha = std::sqrt(2.0 / (exponent + 2.0));
    return std::sqrt(alpha);
}

Material material_of(const MtlMaterial& material, MtlPictures& pictures, Diagnostics& diagnostics) {
    return Converter(material, pictures, diagnostics).convert();
}

}  // namespace dewbow
