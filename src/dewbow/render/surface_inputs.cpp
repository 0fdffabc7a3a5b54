// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface_inputs.h"

#include <algorithm>

namespace dewbow {
namespace {

/// The value between three vertices' values.
template <std::size_t N>
std::array<double, N> between(const std::vector<std::array<float, N>>& at,
                              const std::array<std::uint32_t, 3>& triangle, double u, double v) {
    const auto &a = at[triangle[0]], &b = at[triangle[1]], &c = at[triangle[2]];
    std::array<double, N> value;
    for (std::size_t i = 0; i < N; ++i)
        value[i] = (1.0 - u - v) * double(a[i]) + u * double(b[i]) + v * double(c[i]);
    return value;
}

struct SurfaceVaries {
    const Scene& scene;

    bool operator()(const Black&) const { return false; }
    bool operator()(const Diffuse& s) const { return s.reflectance.varies(); }
    bool operator()(const Mirror& s) const { return s.reflectance.varies(); }
    bool operator()(const Dielectric& s) const { return s.roughness.varies() || s.tint.varies(); }
    bool operator()(const ThinDielectric& s) const {
        return s.roughness.varies() || s.tint.varies();
    }
    bool operator()(const Conductor& s) const { return s.roughness.varies(); }
    bool operator()(const MetallicRoughness& s) const {
        return s.base_colour.varies() || s.metalness.varies() || s.roughness.varies() ||
               s.specular.varies() || s.specular_colour.varies() || s.clearcoat.varies() ||
               s.clearcoat_roughness.varies() || s.sheen_colour.varies() ||
               s.sheen_roughness.varies();
    }
    bool operator()(const Mix& s) const {
        return s.second_share.varies() || of(s.first) || of(s.second);
    }
    bool of(int material) const {
        return surface_varies(scene, scene.materials[std::size_t(material)]);
    }
};

}  // namespace

bool surface_varies(const Scene& scene, const Material& material) {
    return std::visit(SurfaceVaries{scene}, material.surface);
}

SurfaceCoordinates coordinates_on(const Mesh& mesh, int triangle, double u, double v) {
    const std::array<std::uint32_t, 3>& corners = mesh.triangles[std::size_t(triangle)];
    SurfaceCoordinates at;
    for (std::size_t set = 0; set < 2; ++set) {
        const auto& coordinates = mesh.texcoords[mesh.texcoords[set].empty() ? 1 - set : set];
        if (coordinates.empty()) continue;
        const auto point = between(coordinates, corners, u, v);
        at.uv[set] = {point[0], point[1]};
    }
    if (!mesh.colours.empty()) {
        const auto rgba = between(mesh.colours, corners, u, v);
        at.colour = {{rgba[0], rgba[1], rgba[2]}};
        at.alpha = rgba[3];
    }
    return at;
}

SurfaceCoordinates coordinates_on_chart(double u, double v) {
    SurfaceCoordinates at;
    at.uv.fill({u, v});
    return at;
}

double number_at(const NumberInput& input, const SurfaceCoordinates& at) {
    if (!input.texture) return input.value;
    const TexturePoint point = at.uv[std::size_t(input.texture->texcoord_set)];
    return input.value * input.texture->eval(point)[std::size_t(input.channel)];
}

Colour<LinearSrgb> colour_at(const ColourInput& input, const SurfaceCoordinates& at) {
    Colour<LinearSrgb> rgb = input.factor;
    if (input.texture) {
        const auto texel = input.texture->eval(at.uv[std::size_t(input.texture->texcoord_set)]);
        for (std::size_t c = 0; c < 3; ++c) rgb[c] *= texel[c];
    }
    if (input.vertex_colour)
        for (std::size_t c = 0; c < 3; ++c) rgb[c] *= at.colour[c];
    for (double& channel : rgb.v) channel = std::clamp(channel, 0.0, 1.0);
    return rgb;
}

void SurfaceInputs::colour(const ColourInput& input, const LaneSet& lanes, LaneValues& out) const {
    if (input.varies())
        rgb_.eval(colour_at(input, at_), lanes, out);
    else if (input.spectrum)
        input.spectrum->eval_lanes(lanes.lambdas(), out.first(lanes.count));
    else
        std::fill_n(out.v.begin(), lanes.count, 1.0);
}

}  // namespace dewbow
