// SPDX-License-Identifier: Apache-2.0
#include "dewbow/import/gltf/cameras.h"

#include <fmt/format.h>

#include <numbers>

#include "dewbow/import/merge.h"

namespace dewbow::gltf {
namespace {

constexpr Range kHalfHeightRange{0.0, kHuge, true, false};
constexpr Range kFieldOfViewRange{0.0, std::numbers::pi, true, true};

/// Whether a line of sight and an upright are left of the frame.
bool has_view(const Affine& affine) {
    const Vec3 ahead = affine.apply_linear({0.0, 0.0, -1.0}),
               up = affine.apply_linear({0.0, 1.0, 0.0});
    return length(cross(ahead, up)) > 1e-9 * length(ahead) * length(up);
}

/// Nothing for a kind that is not known.
std::optional<Projection> read_projection(const Json& definition) {
    if (const auto perspective = definition.find("perspective"))
        return Perspective{perspective->require("yfov").number(kFieldOfViewRange) * unit::rad};
    if (const auto orthographic = definition.find("orthographic"))  // ymag: half the height
        return Orthographic{2.0 * orthographic->require("ymag").number(kHalfHeightRange) * unit::m};
    return std::nullopt;
}

}  // namespace

std::optional<CameraView> read_camera(Document& document, const PlacedNode& node) {
    const auto reference = node.json.find("camera");
    if (!reference) return std::nullopt;
    const Json definition = document.item("cameras", *reference);
    CameraView camera;
    camera.name = definition.text("name", node.name);
    const std::string who = fmt::format("camera \"{}\"", camera.name);
    const auto projection = read_projection(definition);
    if (!projection) {
        document.notes().add(definition.place(),
                             "{} is neither perspective nor orthographic and is not used", who);
        return std::nullopt;
    }
    camera.projection = *projection;
    if (!has_view(node.world_from_node)) {
        document.notes().add(node.json.place(), "{} looks nowhere: its node is scaled to nothing",
                             who);
        return std::nullopt;
    }
    camera.world_from_camera = Transform<World, Camera>(without_scale(node.world_from_node));
    return camera;
}

}  // namespace dewbow::gltf
