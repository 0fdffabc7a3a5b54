// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface_inputs.h"

#include <algorithm>

namespace dewbow {

double SurfaceInputs::number(const NumberInput& input) const {
    if (!input.texture) return input.value;
    const TexturePoint point = at_.uv[std::size_t(input.texture->texcoord_set)];
    return input.value * input.texture->eval(point)[std::size_t(input.channel)];
}

void SurfaceInputs::colour(const ColourInput& input, const LaneSet& lanes, LaneValues& out) const {
    if (!input) {
        std::fill_n(out.v.begin(), lanes.count, 1.0);
        return;
    }
    if (!input.varies()) {
        input.spectrum->eval_lanes(lanes.lambdas(), out.first(lanes.count));
        return;
    }
    Colour<LinearSrgb> rgb = input.factor;
    if (input.texture) {
        const auto texel = input.texture->eval(at_.uv[std::size_t(input.texture->texcoord_set)]);
        for (std::size_t c = 0; c < 3; ++c) rgb[c] *= texel[c];
    }
    if (input.vertex_colour)
        for (std::size_t c = 0; c < 3; ++c) rgb[c] *= at_.colour[c];
    for (double& channel : rgb.v) channel = std::clamp(channel, 0.0, 1.0);
    rgb_.eval(rgb, lanes, out);
}

}  // namespace dewbow
