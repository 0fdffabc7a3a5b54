// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "dewbow/scene/checks.h"

namespace dewbow::checks {
namespace {

struct CheckLight {
    const std::string& who;

    void operator()(const PointLight& light) const {
        check_finite(who, "position", light.position.v);
        check_spectrum(who, "intensity", light.intensity);
    }
    void operator()(const SpotLight& light) const {
        check_finite(who, "position", light.position.v);
        check_unit(who, "direction", light.direction.v);
        check_range(who, "the outer angle in degrees", light.outer.to(unit::deg), 0.0,
                    90.0 + kRounding);
        check_range(who, "the inner angle in degrees", light.inner.to(unit::deg), 0.0,
                    light.outer.to(unit::deg));
        if (!(light.inner < light.outer)) fail(who, "the inner angle must be less than the outer");
        check_spectrum(who, "intensity", light.intensity);
    }
    void operator()(const ProfileLight& light) const {
        check_finite(who, "position", light.position.v);
        check_affine(who, light.world_from_object.affine());
        if (!light.web) fail(who, "its photometric web is missing");
        check_spectrum(who, "intensity per candela", light.intensity_per_cd);
    }
    void operator()(const BeamLight& light) const {
        check_finite(who, "position", light.position.v);
        check_unit(who, "direction", light.direction.v);
        check_positive(who, "the radius in metres", light.radius.to(unit::m));
        check_spectrum(who, "irradiance", light.irradiance);
    }
    void operator()(const DistantLight& light) const {
        check_unit(who, "direction", light.direction.v);
        check_range(who, "the angular radius in degrees", light.angular_radius.to(unit::deg), 0.0,
                    90.0);
        check_spectrum(who, "irradiance", light.irradiance);
    }
    void operator()(const UniformEnvironment& light) const {
        check_spectrum(who, "radiance", light.radiance);
    }
    void operator()(const std::shared_ptr<const ImageEnvironment>& light) const {
        if (!light) fail(who, "its picture is missing");
        if (light->width < 1 || light->height < 1 ||
            light->pixels.size() != std::size_t(light->width) * std::size_t(light->height)) {
            fail(who, fmt::format("its picture has {} pixels for {} x {}", light->pixels.size(),
                                  light->width, light->height));
        }
        check_range(who, "scale", light->scale, 0.0, kInfinity);
        check_affine(who, light->world_from_object.affine());
        for (const auto& pixel : light->pixels) {
            for (const double value : pixel.v) {
                if (!std::isfinite(value)) fail(who, "a pixel of its picture is not finite");
            }
        }
    }
    void operator()(const SkyDomePtr& sky) const {
        if (!sky) fail(who, "its sky is missing");
    }
};

}  // namespace

void check_lights(const Scene& scene) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::string who = fmt::format("light {}", i + 1);
        std::visit(CheckLight{who}, scene.lights[i]);
    }
}

}  // namespace dewbow::checks
