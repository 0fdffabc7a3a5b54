// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/lights.h"

#include <fmt/format.h>

#include <numbers>

#include "dewbow/import/gltf/photometry.h"

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

}  // namespace

std::optional<Light> read_light(Document& document, const PlacedNode& node) {
    const auto extension = find_extension(node.json, kExtension);
    if (!extension) return std::nullopt;
    const Json definition = definition_of(document, extension->require("light"));
    const Vec3 colour = definition.vec3("color", kAmountRange, {1.0, 1.0, 1.0});
    SpectrumPtr size =
        photometric_spectrum(colour, definition.number("intensity", kAmountRange, 1.0));
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
