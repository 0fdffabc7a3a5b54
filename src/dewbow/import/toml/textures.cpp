// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/toml/textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "dewbow/base/file.h"
#include "dewbow/import/texture_facts.h"
#include "dewbow/import/toml/spectra.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/rgb.h"

namespace dewbow::toml_import {
namespace {

constexpr Range kUvRange{-1e6, 1e6};
constexpr Range kStrengthRange{-1e3, 1e3};

const std::array<std::string, 3> kWrapNames = {"repeat", "mirror", "clamp"};
constexpr std::array kWraps = {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp};
const std::array<std::string, 2> kFilterNames = {"linear", "nearest"};
const std::array<std::string, 2> kCodingNames = {"srgb", "linear"};
constexpr std::array kCodings = {TextureCoding::srgb, TextureCoding::linear};
const std::array<std::string, 4> kChannelNames = {"r", "g", "b", "a"};

bool has_key(const TomlValue& value, std::string_view key) {
    const TomlValue::Table* table = value.table();
    return table && std::any_of(table->begin(), table->end(),
                                [&](const TomlEntry& entry) { return entry.key == key; });
}
/// A picture's name, or a table with one.
bool is_picture(const TomlValue& value) { return value.text() || has_key(value, "texture"); }

void read_wrap(Table& table, Texture& texture) {
    const TomlValue* value = table.find("wrap");
    if (!value) return;
    const auto wrap_of = [&](const TomlValue& word) {
        return kWraps[read_choice(table.document(), word, "wrap", kWrapNames)];
    };
    const TomlValue::Array* pair = value->array();
    if (pair && pair->size() != 2)
        fail(table.document(), value->place,
             fmt::format("wrap is {}; expected a word, or two for u and v", describe(*value)));
    texture.wrap_u = wrap_of(pair ? (*pair)[0] : *value);
    texture.wrap_v = wrap_of(pair ? (*pair)[1] : *value);
}

std::array<double, 2> read_pair(Table& table, std::string_view key, double otherwise) {
    const TomlValue* value = table.find(key);
    if (!value) return {otherwise, otherwise};
    if (!value->array()) {
        const double both = read_number(table.document(), *value, key, kUvRange);
        return {both, both};
    }
    const std::vector<double> v = read_numbers(table.document(), *value, key, kUvRange, 2);
    return {v[0], v[1]};
}

/// Scaled, then turned, then moved.   [KHR_texture_transform]
void read_uv(Table& table, Texture& texture) {
    const auto scale = read_pair(table, "uv_scale", 1.0);
    const auto offset = read_pair(table, "uv_offset", 0.0);
    const Angle turn = table.number("uv_rotate_deg", kUvRange, 0.0) * unit::deg;
    const double c = cos(turn), s = sin(turn);
    texture.transform = {
        {{c * scale[0], s * scale[1], offset[0]}, {-s * scale[0], c * scale[1], offset[1]}}};
    texture.texcoord_set = int(table.integer("uv_set", 0, 1, 0));
}

/// All but factor and channel.
TexturePtr read_texture(Table& table, TextureCoding coding, TextureFolder& pictures) {
    auto texture = std::make_shared<Texture>();
    texture->coding = coding;
    const TomlDocument& document = table.document();
    if (const TomlValue* value = table.find("coding"))
        texture->coding = kCodings[read_choice(document, *value, "coding", kCodingNames)];
    if (const TomlValue* value = table.find("filter"))
        texture->interpolates = read_choice(document, *value, "filter", kFilterNames) == 0;
    read_wrap(table, *texture);
    read_uv(table, *texture);
    texture->image = pictures.load(document, table.require("texture"));
    return texture;
}

/// A picture that is written as nothing but its name.
TexturePtr plain_texture(const TomlDocument& document, const TomlValue& value, TextureCoding coding,
                         TextureFolder& pictures) {
    auto texture = std::make_shared<Texture>();
    texture->coding = coding;
    texture->image = pictures.load(document, value);
    return texture;
}

Colour<LinearSrgb> read_factor(Table& table, const Range& range) {
    const TomlValue* value = table.find("factor");
    if (!value) return {{1.0, 1.0, 1.0}};
    if (!value->array()) {
        const double grey = read_number(table.document(), *value, "factor", range);
        return {{grey, grey, grey}};
    }
    const Vec3 v = read_vec3(table.document(), *value, "factor", range);
    return {{v.x, v.y, v.z}};
}

/// @param channel  of the picture unless `channel` names another.
NumberInput number_of_picture(const TomlDocument& document, const TomlValue& value,
                              std::string_view name, TextureFolder& pictures,
                              int (*channel)(const TextureImage&)) {
    NumberInput input(1.0);
    if (value.text()) {
        input.texture = plain_texture(document, value, TextureCoding::linear, pictures);
        input.channel = channel(*input.texture->image);
        return input;
    }
    Table table(document, value, fmt::format("the texture of {}", name));
    input.texture = read_texture(table, TextureCoding::linear, pictures);
    input.value = table.number("factor", kShareRange, 1.0);
    const TomlValue* word = table.find("channel");
    input.channel = word ? int(read_choice(document, *word, "channel", kChannelNames))
                         : channel(*input.texture->image);
    table.finish();
    return input;
}

int red(const TextureImage&) { return 0; }

}  // namespace

std::shared_ptr<const TextureImage> TextureFolder::load(const TomlDocument& document,
                                                        const TomlValue& value) {
    const std::string& reference = read_text(document, value, "the name of a picture");
    return at_place(document, value.place,
                    [&] { return pictures_.load(resolve_inside(folder_, reference)); });
}

ColourInput read_colour(const TomlDocument& document, const TomlValue& value, std::string_view name,
                        TextureFolder& pictures) {
    ColourInput input;
    if (value.text()) {
        input.texture = plain_texture(document, value, TextureCoding::srgb, pictures);
        return input;
    }
    if (!is_picture(value) && !has_key(value, "vertex_colour"))
        return read_spectrum(document, value, name, SpectrumUse::share);
    Table table(document, value, fmt::format("the texture of {}", name));
    input.vertex_colour = table.boolean("vertex_colour", false);
    input.factor = read_factor(table, kShareRange);
    if (table.find("texture") || !input.vertex_colour)
        input.texture = read_texture(table, TextureCoding::srgb, pictures);
    table.finish();
    return input;
}

NumberInput read_share(const TomlDocument& document, const TomlValue& value, std::string_view name,
                       TextureFolder& pictures) {
    if (!value.text() && !value.table()) return read_number(document, value, name, kShareRange);
    return number_of_picture(document, value, name, pictures, red);
}

NumberInput read_alpha(const TomlDocument& document, const TomlValue& value,
                       TextureFolder& pictures) {
    if (!value.text() && !value.table()) return read_number(document, value, "alpha", kShareRange);
    return number_of_picture(document, value, "alpha", pictures, coverage_channel);
}

void read_emission(const TomlDocument& document, const TomlValue& value, TextureFolder& pictures,
                   Material& material) {
    if (!has_key(value, "texture")) {
        material.emission = read_spectrum(document, value, "emission", SpectrumUse::radiance);
        return;
    }
    Table table(document, value, "the texture of emission");
    EmissionTexture emission;
    emission.texture = read_texture(table, TextureCoding::srgb, pictures);
    emission.factor = read_factor(table, kAmountRange);
    table.at_most_one_of({"scale", "luminance_cd_m2"});
    double scale = table.number("scale", kAmountRange, 1.0);
    if (const auto luminance = table.find_number("luminance_cd_m2", kAmountRange))
        scale = *luminance / (kLuminousEfficacy * cie_y_integral());
    for (double& channel : emission.factor.v) channel *= scale;
    table.finish();
    material.emission_texture = std::move(emission);
}

NormalMap read_normal_map(const TomlDocument& document, const TomlValue& value,
                          TextureFolder& pictures) {
    if (value.text()) return {plain_texture(document, value, TextureCoding::linear, pictures), 1.0};
    Table table(document, value, "normal_map");
    NormalMap map;
    map.texture = read_texture(table, TextureCoding::linear, pictures);
    map.scale = table.number("scale", kStrengthRange, 1.0);
    table.finish();
    return map;
}

}  // namespace dewbow::toml_import
