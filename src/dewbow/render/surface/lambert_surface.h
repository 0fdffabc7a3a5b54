// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>

#include "dewbow/math/sampling.h"
#include "dewbow/render/surface/surface_view.h"
#include "dewbow/scene/material.h"

namespace dewbow {

class LambertSurface {
public:
    LambertSurface(const Diffuse& material, const SurfaceView& view) : count_(view.lanes.count) {
        view.inputs.colour(material.reflectance, view.lanes, reflectance_);
    }
    double eval(Vec3 wi, LaneValues& f) const {
        for (int k = 0; k < count_; ++k) f[k] = reflectance_[k] / std::numbers::pi * wi.z;
        return pdf_cosine_hemisphere(wi.z);
    }
    double typical_density(Vec3 wi) const { return pdf_cosine_hemisphere(wi.z); }
    std::optional<Vec3> sample(double, std::array<double, 2> u) const {
        return sample_cosine_hemisphere(u[0], u[1]).v;
    }

private:
    int count_;
    LaneValues reflectance_;
};

}  // namespace dewbow
