// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/lights.h"

#include <fmt/format.h>

#include <numbers>

#include "dewbow/import/gltf/photometry.h"
#include "dewbow/spectrum/lamp.h"

namespace dewbow::gltf {
namespace {

/// glTF's directional lights have no size; here they have the sun's, so that glass and mirrors show
/// them.
constexpr Angle kSunRadius = 0.2666 * unit::deg;

constexpr std::string_view kExtension = "KHR_lights_punctual";
constexpr double kHalfPi = std::numbers::pi / 2.0;
/// Writers round π/2 up.
constexpr double kAngleRounding = 1e-6;

/// The light that the node's extension refers to by index.
Json definition_of(Document& document, const Json& reference) {
    const auto extension = find_extension(document.root(), kExtension);
    if (!extension) reference.fail(fmt::format("the file holds no lights ({})", kExtension));
    const Json lights = extension->require("lights");
    const std::size_t size = lights.size();
    if (size == 0) reference.fail("there are no lights");
    return lights[reference.whole(size - 1)];
}

Light make_spot(const Json& definition, Point<World> position, Dir<World> direction,
                SpectrumPtr intensity) {
    double inner = 0.0, outer = std::numbers::pi / 4.0;
    if (const auto spot = definition.find("spot")) {
        outer = spot->number("outerConeAngle", {0.0, kHalfPi + kAngleRounding, true, false}, outer);
        inner = spot->number("innerConeAngle", {0.0, outer, false, true}, inner);
    }
    return SpotLight{position, direction, inner * unit::rad, std::min(outer, kHalfPi) * unit::rad,
                     std::move(intensity)};
}

/// The custom property `spectrum` of the light or of its node, the name of a lamp.
std::optional<Json> lamp_name(const Json& definition, const Json& node) {
    for (const Json& owner : {definition, node}) {
        const auto extras = owner.find("extras");
        const auto name = extras && extras->is_object() ? extras->find("spectrum") : std::nullopt;
        if (name && name->is_text()) return name;
    }
    return std::nullopt;
}

/// Candela or lux of it as a spectrum: of the lamp that is named, else of the light's colour.
SpectrumPtr size_of(const Json& definition, const Json& node) {
    const double intensity = definition.number("intensity", kAmountRange, 1.0);
    const Vec3 colour = definition.vec3("color", kAmountRange, {1.0, 1.0, 1.0});
    const auto name = lamp_name(definition, node);
    if (!name || intensity == 0.0) return photometric_spectrum(colour, intensity);
    try {
        return make_scaled(find_lamp(name->text()).spectrum, intensity * one_nit());
    } catch (const InputError& error) {
        name->fail(error.sentence(), error.hint());
    }
}

}  // namespace

std::optional<Light> read_light(Document& document, const PlacedNode& node) {
    const auto extension = find_extension(node.json, kExtension);
    if (!extension) return std::nullopt;
    const Json definition = definition_of(document, extension->require("light"));
    SpectrumPtr size = size_of(definition, node.json);
    if (!size) return std::nullopt;

    const std::string who = fmt::format("light \"{}\"", definition.text("name", node.name));
    if (definition.find("range")) {
        document.notes().add(definition.place(), "the range of {} is not used: it shines on", who);
    }
    const Point<World> position{node.world_from_node.apply({})};
    const Vec3 ahead = node.world_from_node.apply_linear({0.0, 0.0, -1.0});
    const Json type = definition.require("type");
    if (type.text() == "point") return PointLight{position, std::move(size)};
    if (type.text() != "directional" && type.text() != "spot") {
        type.fail(fmt::format("unknown type of light \"{}\"", type.text()),
                  "expected directional, point or spot");
    }
    if (!(length(ahead) > 0.0)) {
        document.notes().add(node.json.place(),
                             "{} has no direction: its node is scaled to nothing", who);
        return std::nullopt;
    }
    const Dir<World> direction{normalised(ahead)};
    if (type.text() == "directional") {
        return DistantLight{direction, kSunRadius, std::move(size)};
    }
    return make_spot(definition, position, direction, std::move(size));
}

}  // namespace dewbow::gltf
