// SPDX-License-Identifier: Apache-2.0
#pragma once

// What an endless slab of drops makes of sunlight, by counting photons: each is followed from the
// sun's disc from drop to drop until it leaves, and is counted where it does. Nothing is weighted,
// nothing is aimed, and nothing of the renderer or of the law of rain is used. Polarisation is left
// out, as in the renderer.                          [analog Monte Carlo: Marchuk et al. 1980, ch.
// 2]

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "dewbow/math/vector.h"

namespace dewbow::kit {

/// Directions by their angle from the antisolar point, as the eye looks; those through one face.
struct Ring {
    double inner_deg, outer_deg;
    bool lit_face = true;  ///< seen from the sun's side of the slab; else from the other

    double solid_angle() const {
        return 2.0 * std::numbers::pi * (cosine(inner_deg) - cosine(outer_deg));
    }
    static double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180.0); }
};

/// Angles to scatter by, in proportion to a phase function: it is taken as constant over cells of
/// 0.02 deg, which are small against every ring.
class ScatteringAngles {
public:
    /// @param per_sr  by the cosine of the scattering angle; its integral over the sphere is 1.
    explicit ScatteringAngles(const std::function<double(double)>& per_sr) {
        constexpr int kCells = 9000, kPoints = 4;
        for (int i = 0; i <= kCells; ++i)
            cosines_.push_back(std::cos(std::numbers::pi * i / kCells));
        for (int i = 0; i < kCells; ++i) {
            const double low = cosines_[std::size_t(i)];
            const double step = (cosines_[std::size_t(i) + 1] - low) / kPoints;
            for (int j = 0; j < kPoints; ++j)
                share_ += -2.0 * std::numbers::pi * step * per_sr(low + (j + 0.5) * step);
            shares_.push_back(share_);
        }
    }
    /// Of the whole sphere; 1 but for what the cells leave out.
    double integral() const { return share_; }
    double cosine(double u, double v) const {
        const auto cell = std::size_t(
            std::upper_bound(shares_.begin(), shares_.end() - 1, u * share_) - shares_.begin());
        return cosines_[cell] + v * (cosines_[cell + 1] - cosines_[cell]);
    }

private:
    std::vector<double> cosines_, shares_;
    double share_ = 0.0;
};

struct PhotonSlab {
    double optical_depth = 0.0;  ///< straight through
    double albedo = 1.0;         ///< share of extinction that is scattered
    const ScatteringAngles* angles = nullptr;
    /// How sunlight travels, unit; the slab's normal is +y, and the sun above it.
    Vec3 sunlight;
    double sun_radius_rad = 0.0;
};

/// Light that is scattered once, twice, or more often.
inline constexpr std::size_t kPhotonOrders = 3;
using RingLight = std::array<double, kPhotonOrders>;

namespace photons {

using Random = std::mt19937_64;
inline double number(Random& random) { return double(random() >> 11) * 0x1p-53; }

}  // namespace photons

/// Turned from `axis`, unit, by the angle of that cosine.
inline Vec3 turned(Vec3 axis, double cosine, double azimuth) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    const Vec3 other = std::abs(axis.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 a = normalised(cross(axis, other)), b = cross(axis, a);
    return normalised(axis * cosine + (a * std::cos(azimuth) + b * std::sin(azimuth)) * sine);
}

namespace photons {

/// The same, to any side.
inline Vec3 turned(Vec3 axis, double cosine, Random& random) {
    return kit::turned(axis, cosine, 2.0 * std::numbers::pi * number(random));
}

}  // namespace photons

/// ∫ L |cos| dω over each ring, of the radiance L that leaves the slab for a sun of irradiance 1 on
/// what faces it, from `count` photons. cos is to the slab's normal.
inline std::vector<RingLight> count_photons(const PhotonSlab& slab, const std::vector<Ring>& rings,
                                            std::size_t count, std::uint64_t seed) {
    using namespace photons;
    Random random(seed);
    std::vector<RingLight> light(rings.size());
    const double least_cosine = std::cos(slab.sun_radius_rad);
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 d = turned(slab.sunlight, 1.0 - number(random) * (1.0 - least_cosine), random);
        const double irradiance = -d.y;
        double depth = 0.0;
        for (std::size_t order = 0;; ++order) {
            depth -= d.y * -std::log1p(-number(random));
            if (depth < 0.0 || depth > slab.optical_depth) {
                if (order == 0) break;
                const double angle_deg = std::acos(std::clamp(-dot(d, slab.sunlight), -1.0, 1.0)) *
                                         180.0 / std::numbers::pi;
                for (std::size_t r = 0; r < rings.size(); ++r)
                    if (rings[r].lit_face == (depth < 0.0) && angle_deg >= rings[r].inner_deg &&
                        angle_deg < rings[r].outer_deg)
                        light[r][std::min(order, kPhotonOrders) - 1] += irradiance / double(count);
                break;
            }
            if (number(random) >= slab.albedo) break;
            const double u = number(random), v = number(random);
            d = turned(d, slab.angles->cosine(u, v), random);
        }
    }
    return light;
}

}  // namespace dewbow::kit
