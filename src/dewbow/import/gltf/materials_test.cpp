// SPDX-License-Identifier: Apache-2.0

// What glTF's material factors become.

#include <gtest/gtest.h>

#include "dewbow/import/gltf/test_document.h"
#include "dewbow/optics/catalogue.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace gltf_test;

/// An index without dispersion is that against air at the d line: air's own dispersion over the
/// visible range, times the index, is left.
constexpr double kAirDispersion = 2e-5;
constexpr double kNm[] = {400.0, 486.1327, kLined.to(unit::nm), 656.2725, 700.0};

/// A scene of one triangle in a material with these members.
ParsedScene with_material(const std::string& members) {
    Parts parts;
    parts.materials = R"([{"name": "m", )" + members + "}]";
    return parse(parts);
}

const Material& only(const ParsedScene& parsed) {
    return parsed.scene.materials[std::size_t(parsed.scene.shapes.at(0).material)];
}

template <class Surface>
const Surface& surface_of(const ParsedScene& parsed) {
    return std::get<Surface>(only(parsed).surface);
}

double index_at(const DispersionPtr& index, double lambda_nm) {
    return (*index)(lambda_nm * unit::nm).value;
}

const char* const kGlassHead =
    R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0},
       "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},)";

std::string glass(const std::string& extensions) { return kGlassHead + extensions + "}"; }

TEST(GltfMaterials, DefaultsAreTheSpecifications) {
    const ParsedScene parsed = with_material(R"("doubleSided": true)");
    const auto& surface = surface_of<MetallicRoughness>(parsed);
    EXPECT_EQ(surface.metalness, 1.0);
    EXPECT_EQ(surface.roughness, 1.0);
    EXPECT_EQ(surface.ior, 1.5);
    EXPECT_NEAR((*surface.base_colour.spectrum)(550.0 * unit::nm), 1.0, 1e-3);
    EXPECT_EQ(only(parsed).emission, nullptr);
    EXPECT_TRUE(parsed.diagnostics.empty());
}

TEST(GltfMaterials, NoMaterialIsTheDefaultOne) {
    Parts parts;
    parts.primitive = R"({"attributes": {"POSITION": 0}})";
    EXPECT_EQ(only(parse(parts)).name, "default");
}

TEST(GltfMaterials, VolumeWithThicknessIsADielectricBody) {
    const auto parsed = with_material(glass(
        R"("KHR_materials_ior": {"ior": 2.42}, "KHR_materials_volume": {"thicknessFactor": 0.1})"));
    const auto& surface = surface_of<Dielectric>(parsed);
    EXPECT_FALSE(surface.tint);
    EXPECT_EQ(surface.interior->absorption, nullptr);
    for (const double nm : kNm) {
        EXPECT_NEAR(index_at(surface.interior->index, nm), 2.42 * index_at(air(), nm),
                    kAirDispersion);
    }
}

TEST(GltfMaterials, DispersionIsTwentyOverTheAbbeNumber) {
    const auto parsed = with_material(glass(
        R"("KHR_materials_ior": {"ior": 1.72825}, "KHR_materials_volume": {"thicknessFactor": 1},
                 "KHR_materials_dispersion": {"dispersion": 0.703977472720873})"));
    const auto& surface = surface_of<Dielectric>(parsed);
    // SF10: n_d 1.72825, V_d 28.41. The form rounds its constants to 1e-4 relative.
    EXPECT_NEAR(abbe_number(*surface.interior->index, *air()), 28.41, 0.01);
    EXPECT_NEAR(index_at(surface.interior->index, kLined.to(unit::nm)) /
                    index_at(air(), kLined.to(unit::nm)),
                1.72825, 1e-5);
}

TEST(GltfMaterials, IndexOneBendsNothingWhateverItsDispersion) {
    for (const char* dispersion : {"0", "0.5", "5"}) {
        const auto parsed = with_material(glass(
            R"("KHR_materials_ior": {"ior": 1}, "KHR_materials_volume": {"thicknessFactor": 1},
                     "KHR_materials_dispersion": {"dispersion": )" +
            std::string(dispersion) + "}"));
        const auto& surface = surface_of<Dielectric>(parsed);
        const auto& outside = parsed.scene.surroundings->index;
        for (const double nm : kNm) {
            EXPECT_EQ(index_at(surface.interior->index, nm), index_at(outside, nm)) << nm;
        }
    }
}

TEST(GltfMaterials, WithoutThicknessItIsThin) {
    for (const char* extension :
         {R"("KHR_materials_ior": {"ior": 1.3})",
          R"("KHR_materials_ior": {"ior": 1.3}, "KHR_materials_volume": {})"}) {
        const auto parsed = with_material(glass(extension));
        EXPECT_NEAR(index_at(surface_of<ThinDielectric>(parsed).index, 550.0),
                    1.3 * index_at(air(), 550.0), kAirDispersion);
        EXPECT_TRUE(parsed.diagnostics.empty());
    }
}

TEST(GltfMaterials, AttenuationIsAColourAtADistanceInTheWorld) {
    Parts parts;
    parts.nodes = R"([{"mesh": 0, "scale": [10, 10, 10]}])";
    parts.materials =
        "[{" + glass(R"("KHR_materials_volume": {"thicknessFactor": 1, "attenuationDistance": 2,
                                      "attenuationColor": [0.25, 0.25, 0.25]})") +
        "}]";
    const auto parsed = parse(parts);
    const auto& medium = *surface_of<Dielectric>(parsed).interior;
    ASSERT_NE(medium.absorption, nullptr);
    EXPECT_NEAR((*medium.absorption)(550.0 * unit::nm), -std::log(0.25) / 2.0, 1e-6);
}

TEST(GltfMaterials, BaseColourTintsGlass) {
    const auto parsed = with_material(
        R"("pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.25,
                                    "baseColorFactor": [0.85, 0.85, 0.85, 1]},
           "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
                          "KHR_materials_volume": {"thicknessFactor": 1}})");
    const auto& surface = surface_of<Dielectric>(parsed);
    EXPECT_EQ(surface.roughness, 0.25);
    EXPECT_NEAR((*surface.tint.spectrum)(450.0 * unit::nm), 0.85, 1e-6);
}

TEST(GltfMaterials, PartlyTransmittingIsAMixOfGlassAndTheRest) {
    const auto parsed = with_material(
        R"("pbrMetallicRoughness": {"metallicFactor": 0.2, "roughnessFactor": 0},
           "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}})");
    const auto& mix = surface_of<Mix>(parsed);
    EXPECT_NEAR(mix.second_share.value, 0.4, 1e-12);
    const auto& materials = parsed.scene.materials;
    const auto& rest = std::get<MetallicRoughness>(materials[std::size_t(mix.first)].surface);
    // The metal's share of the whole stays what it was.
    EXPECT_NEAR(rest.metalness.value * (1.0 - mix.second_share.value), 0.2, 1e-12);
    EXPECT_TRUE(std::holds_alternative<ThinDielectric>(materials[std::size_t(mix.second)].surface));
    EXPECT_EQ(materials.size(), 3u);
}

TEST(GltfMaterials, MetalDoesNotTransmit) {
    const auto parsed =
        with_material(R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}})");
    EXPECT_EQ(surface_of<MetallicRoughness>(parsed).metalness, 1.0);
}

TEST(GltfMaterials, IndexZeroReflectsAll) {
    const auto parsed = with_material(glass(
        R"("KHR_materials_ior": {"ior": 0}, "KHR_materials_volume": {"thicknessFactor": 1})"));
    const auto& surface = surface_of<MetallicRoughness>(parsed);
    EXPECT_EQ(surface.metalness, 1.0);
    EXPECT_EQ((*surface.base_colour.spectrum)(550.0 * unit::nm), 1.0);
}

TEST(GltfMaterials, OneNitHasALuminanceOfOne) {
    const auto parsed = with_material(
        R"("emissiveFactor": [1, 1, 1], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 40}})");
    const double luminance = kLuminousEfficacy * xyz_from_spectrum(*only(parsed).emission)[1];
    EXPECT_NEAR(luminance, 40.0, 40.0 * 1e-3);
    EXPECT_TRUE(only(parsed).two_sided_emission);
    EXPECT_EQ(parsed.scene.film.white_luminance, 1.0);
}

TEST(GltfMaterials, TheCataloguesGlassIsTakenByName) {
    const auto parsed = with_material(
        R"("extras": {"dewbow": {"glass": "schott/N-BK7"}}, )" +
        glass(
            R"("KHR_materials_ior": {"ior": 2}, "KHR_materials_volume": {"thicknessFactor": 1})"));
    const auto& surface = surface_of<Dielectric>(parsed);
    EXPECT_NEAR(index_at(surface.interior->index, kLined.to(unit::nm)) /
                    index_at(air(), kLined.to(unit::nm)),
                1.5168, 1e-4);
}

TEST(GltfMaterials, BlendersCustomPropertyNamesAGlass) {
    const auto parsed = with_material(R"("extras": {"glass": "schott/N-SF11"}, )" +
                                      glass(R"("KHR_materials_volume": {"thicknessFactor": 1})"));
    // SCHOTT's data sheet: n_d = 1.78472.
    EXPECT_NEAR(index_at(surface_of<Dielectric>(parsed).interior->index, 587.5618) /
                    index_at(air(), 587.5618),
                1.78472, 1e-4);
}

TEST(GltfMaterials, WhatHasToBeSaidOfAGlassIsSaidOnce) {
    Parts parts;
    const std::string quartz = R"({"extras": {"glass": "gem/quartz"}, )" +
                               glass(R"("KHR_materials_volume": {"thicknessFactor": 1})") + "}";
    parts.materials = "[" + quartz + ", " + quartz + "]";
    parts.primitive =
        R"({"attributes": {"POSITION": 0}, "material": 0}, {"attributes": {"POSITION": 0}, "material": 1})";
    const Diagnostics diagnostics = parse(parts).diagnostics;
    std::size_t found = 0;
    for (const Diagnostic& diagnostic : diagnostics)
        found += diagnostic.text == *birefringence_note(find_glass("gem/quartz"));
    EXPECT_EQ(found, 1u);
}

TEST(GltfMaterials, AGlassThatLetsNoLightThroughIsNoted) {
    const auto parsed = with_material(R"("extras": {"glass": "schott/N-SF11"})");
    ASSERT_EQ(parsed.diagnostics.size(), 1u);
    EXPECT_EQ(parsed.diagnostics[0].text,
              "the glass of material \"m\" is not used: the material lets no light through "
              "(transmission)");
}

TEST(GltfMaterials, ForeignExtrasAreLetBe) {
    EXPECT_NO_THROW(with_material(R"("extras": 3)"));
    EXPECT_NO_THROW(with_material(R"("extras": {"other": {"glass": 5}})"));
    EXPECT_NO_THROW(with_material(R"("extras": {"glass": true})"));
}

struct Wrong {
    const char* members;
    const char* phrase;
};

TEST(GltfMaterials, ErrorsNameThePlaceByJsonPointer) {
    const Wrong wrong[] = {
        {R"("extensions": {"KHR_materials_ior": {"ior": 0.5}})",
         "/materials/0/extensions/KHR_materials_ior/ior: is 0.5"},
        {R"("extensions": {"KHR_materials_ior": {"ior": "2"}})",
         "KHR_materials_ior/ior: is the string \"2\"; expected a number"},
        {R"("pbrMetallicRoughness": {"metallicFactor": -1})",
         "/materials/0/pbrMetallicRoughness/metallicFactor: is -1"},
        {R"("pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1]})",
         "expected an array of 4 numbers"},
        {R"("pbrMetallicRoughness": {"baseColorFactor": [1, 7, 1, 1]})", "baseColorFactor/1: is 7"},
        {R"("pbrMetallicRoughness": 5)",
         "/materials/0/pbrMetallicRoughness: is the number 5; expected an object"},
        {R"("emissiveFactor": [0, -1, 0])", "/materials/0/emissiveFactor/1: is -1"},
        {R"("extensions": {"KHR_materials_volume": {"attenuationDistance": 0}})",
         "attenuationDistance: is 0"},
        {R"("extensions": {"KHR_materials_transmission": {"transmissionFactor": 1.5}})",
         "transmissionFactor: is 1.5"},
        {R"("extensions": {"KHR_materials_dispersion": {"dispersion": -1}})",
         "dispersion/dispersion: is -1"},
    };
    for (const Wrong& row : wrong) {
        Parts parts;
        parts.materials = "[{" + std::string(row.members) + "}]";
        const std::string message = error_of(parts);
        EXPECT_NE(message.find(row.phrase), std::string::npos)
            << message << "\nfor " << row.members;
    }
}

TEST(GltfMaterials, UnknownGlassIsAnErrorAtItsName) {
    Parts parts;
    parts.materials = R"([{"extras": {"dewbow": {"glass": "schott/N-BK8"}},
        "pbrMetallicRoughness": {"metallicFactor": 0},
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}}])";
    const std::string message = error_of(parts);
    EXPECT_NE(message.find("/materials/0/extras/dewbow/glass"), std::string::npos) << message;
    EXPECT_NE(message.find("N-BK7"), std::string::npos) << message;
    parts.materials = R"([{"extras": {"glass": "schott/N-BK8"},
        "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}},
        "pbrMetallicRoughness": {"metallicFactor": 0}}])";
    EXPECT_NE(error_of(parts).find("/materials/0/extras/glass"), std::string::npos);
}

TEST(GltfMaterials, WhatIsNotUsedIsSaidOnceAKind) {
    Parts parts;
    parts.materials = R"([
        {"name": "a", "extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 1}}},
        {"name": "b", "extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 0.5}}},
        {"name": "c", "extensions": {"KHR_materials_iridescence": {"iridescenceFactor": 0},
                                     "KHR_materials_anisotropy": {"anisotropyStrength": 0.1}}},
        {"name": "unused", "extensions": {"KHR_materials_diffuse_transmission": {"diffuseTransmissionFactor": 1}}}])";
    parts.primitive =
        R"({"attributes": {"POSITION": 0}, "material": 0}, {"attributes": {"POSITION": 0}, "material": 1},
           {"attributes": {"POSITION": 0}, "material": 2})";
    const Diagnostics diagnostics = parse(parts).diagnostics;
    ASSERT_EQ(diagnostics.size(), 2u);
    EXPECT_EQ(
        diagnostics[0].text,
        "the extension KHR_materials_iridescence of material \"a\" and of another is not used");
    EXPECT_EQ(diagnostics[0].place.within, "/materials/0/extensions/KHR_materials_iridescence");
    EXPECT_EQ(diagnostics[1].text,
              "the extension KHR_materials_anisotropy of material \"c\" is not used");
}

}  // namespace
}  // namespace dewbow
