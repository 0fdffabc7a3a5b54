// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every kind of rough surface, in one form for the tests of all of them.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "../analytic/scene_kit.h"
#include "dewbow/render/surface/ggx_lobe.h"
#include "dewbow/render/surface/rough_dielectric.h"
#include "dewbow/render/surface/scattering_surface.h"

namespace dewbow::kit {

/// A surface as it is looked at from one direction. Directions are local, wo.z > 0.
struct SeenSurface {
    struct Value {
        double f_cos = 0.0, pdf = 0.0;
    };
    std::function<Value(Vec3 wi)> eval;
    std::function<std::optional<Vec3>(double u_lobe, std::array<double, 2> u)> sample;
};

struct SurfaceRow {
    std::string name;
    std::function<SeenSurface(Vec3 wo)> from_above, from_below;
    bool transmits = false;
    double index = 1.0;  ///< of what is below against what is above
    /// What it reflects and lets through of even light, all angles.
    double least_albedo = 0.0, most_albedo = 1.0;
    double tables = kGgxEnergyError;  ///< error of tables, on top of either bound
};

/// At one wavelength, in a vacuum.
inline SeenSurface seen(const Material& material, Vec3 wo) {
    const LaneSet lanes = LaneSet::all(one_wavelength(550.0));
    LaneValues outside;
    outside[0] = 1.0;
    const SurfaceCoordinates nowhere;
    RgbReflectanceLanes rgb;
    const SurfaceInputs inputs(nowhere, rgb);
    const auto surface =
        std::make_shared<ScatteringSurface>(material, SurfaceView{inputs, lanes, outside, wo});
    return {
        [surface](Vec3 wi) {
            LaneValues f;
            const double pdf = surface->eval(wi, f);
            return SeenSurface::Value{f[0], pdf};
        },
        [surface](double u_lobe, std::array<double, 2> u) { return surface->sample(u_lobe, u); }};
}

inline SurfaceRow row_of(std::string name, Material material, double least, double most) {
    const auto from = [material](Vec3 wo) { return seen(material, wo); };
    return {std::move(name), from, from, ScatteringSurface::transmits(material), 1.0, least, most};
}

inline SurfaceRow row_of_glass(std::string name, double roughness, double n, double least,
                               double most) {
    const auto from = [roughness](double index) {
        return [roughness, index](Vec3 wo) {
            const auto glass =
                std::make_shared<RoughDielectric>(wo, alpha_of_roughness(roughness), index);
            return SeenSurface{[glass](Vec3 wi) {
                                   const RoughDielectric::Value value = glass->eval(wi);
                                   return SeenSurface::Value{value.f_cos, value.pdf};
                               },
                               [glass](double u_lobe, std::array<double, 2> u) {
                                   return glass->sample(u_lobe, u);
                               }};
        };
    };
    return {std::move(name), from(n), from(1.0 / n), true, n, least, most, kDielectricEnergyError};
}

inline std::vector<SurfaceRow> all_surfaces() {
    const auto white = make_constant(1.0), grey = make_constant(0.5);
    const auto conductor = [](double n, double k, double roughness) {
        return Material{"", Conductor{make_constant(n), make_constant(k), roughness}};
    };
    const auto layered = [](MetallicRoughness surface) { return Material{"", std::move(surface)}; };
    const auto pane = [](double roughness, SpectrumPtr tint) {
        return Material{
            "", ThinDielectric{make_dispersion({"constant", {1.5}}), std::move(tint), roughness}};
    };
    MetallicRoughness tinted{grey, 0.0, 0.6};
    tinted.specular = 0.7, tinted.specular_colour = make_constant(0.5);
    MetallicRoughness varnished_paint{white, 0.0, 0.8};
    varnished_paint.clearcoat = 1.0, varnished_paint.clearcoat_roughness = 0.45;
    MetallicRoughness varnished_metal{white, 1.0, 0.7};
    varnished_metal.clearcoat = 1.0, varnished_metal.clearcoat_roughness = 0.45;
    MetallicRoughness velvet{white, 0.0, 0.9};
    velvet.sheen_colour = white, velvet.sheen_roughness = 0.6;
    MetallicRoughness satin = velvet;
    satin.sheen_roughness = 0.3;
    MetallicRoughness all{grey, 0.4, 0.7};
    all.clearcoat = 0.6, all.clearcoat_roughness = 0.5;
    all.sheen_colour = make_constant(0.4), all.sheen_roughness = 0.8;
    return {
        row_of("white paper", diffuse(1.0), 1.0, 1.0),
        // n + ik of gold at 550 nm, next to; and an index that reflects all there is.
        row_of("gold", conductor(0.4, 2.4, 0.6), 0.7, 0.9),
        row_of("perfect conductor, smoother", conductor(0.5, 1e5, 0.5), 1.0, 1.0),
        row_of("perfect conductor, rough", conductor(0.5, 1e5, 1.0), 1.0, 1.0),
        row_of("white plastic", layered({white, 0.0, 0.6}), 1.0, 1.0),
        row_of("white plastic, rough", layered({white, 0.0, 1.0}), 1.0, 1.0),
        row_of("white metal", layered({white, 1.0, 0.9}), 1.0, 1.0),
        row_of("half metal", layered({grey, 0.5, 0.8, 1.8}), 0.3, 0.8),
        row_of("tinted reflection", layered(tinted), 0.4, 0.8),
        row_of("varnished paint", layered(varnished_paint), 0.9, 1.0),
        row_of("varnished metal", layered(varnished_metal), 0.9, 1.0),
        row_of("velvet", layered(velvet), 0.85, 1.0),
        row_of("satin", layered(satin), 0.6, 1.0),
        row_of("all layers", layered(all), 0.3, 0.9),
        row_of("clear pane", pane(0.6, nullptr), 1.0, 1.0),
        row_of("clear pane, rough", pane(1.0, nullptr), 1.0, 1.0),
        row_of("tinted pane", pane(0.7, grey), 0.4, 0.9),
        row_of_glass("glass", 0.6, 1.5, 1.0, 1.0),
        row_of_glass("diamond, rough", 1.0, 2.4, 1.0, 1.0),
    };
}

}  // namespace dewbow::kit
