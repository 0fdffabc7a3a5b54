// SPDX-License-Identifier: Apache-2.0
#pragma once

// What GGX microfacets reflect once, and what is owed for light that they reflect more than once.
//
// A lobe without Fresnel's factor sends back E(μ) of what comes at cos θ = μ; 1 − E(μ) meets
// further microfacets. It is given back by a reciprocal lobe,
//     f_ms = F_ms (1 − E(μ_o)) (1 − E(μ_i)) / (π (1 − E_avg)),   E_avg = 2 ∫ E(μ) μ dμ,
// so that microfacets which reflect all light reflect all light.
//                              [Kulla & Conty, "Revisiting Physically Based Shading at Imageworks",
//                              SIGGRAPH 2017 course; the idea: Kelemen & Szirmay-Kalos 2001]

#include <cstddef>

#include "dewbow/render/surface/table_axis.h"

namespace dewbow {

/// Directional albedo against an integral of its own (see ggx_energy_test.cpp), from kLeastAlpha to
/// 1 and over all angles: the largest error of E, of the grazing part, and of E + F_ms part for
/// F = 1, which would be 1.
inline constexpr double kGgxEnergyError = 3e-3;

struct GgxAlbedo {
    double lost = 0.0;     ///< 1 − E
    double grazing = 0.0;  ///< E with (1 − cos θ_m)⁵ for Fresnel's factor
    /// E with Schlick's F = f0 + (f90 − f0) (1 − cos θ_m)⁵.
    double schlick(double f0, double f90) const {
        return f0 * (1.0 - lost - grazing) + f90 * grazing;
    }
};

/// Albedos at one roughness, out of a table that is computed when it is first asked for.
class GgxAlbedos {
public:
    explicit GgxAlbedos(double alpha);
    /// @param cosine  in [0, 1].
    GgxAlbedo at(double cosine) const;
    /// 2 ∫ … μ dμ of what at() gives.
    GgxAlbedo average() const;

private:
    double alpha_;
    LogAxis cosines_;
    TablePlace row_;
};

class GgxEnergy {
public:
    explicit GgxEnergy(double alpha);

    GgxAlbedo at(double cosine) const { return albedos_.at(cosine); }
    const GgxAlbedo& average() const { return average_; }

    /// f_ms / F_ms, times cos θ_i.
    double compensation(double lost_o, double lost_i, double cos_i) const;
    /// F_ms of microfacets that reflect `average_fresnel` on average over the hemisphere: the sum
    /// of what leaves after 2, 3, … reflections, F² E + F³ E (1 − E) + …, by that of F = 1.
    ///                               [S. Hill, "A Multi-Faceted Exploration", part 4, 2018]
    double multiple(double average_fresnel) const {
        return average_fresnel * average_fresnel * (1.0 - average_.lost) /
               (1.0 - average_fresnel * average_.lost);
    }

private:
    GgxAlbedos albedos_;
    GgxAlbedo average_;
};

}  // namespace dewbow
