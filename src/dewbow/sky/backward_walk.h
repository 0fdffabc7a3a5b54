// SPDX-License-Identifier: Apache-2.0
#pragma once

// For tests: an oracle for the clear sky: photons followed backwards from the eye through a
// spherical atmosphere, one wavelength at a time. It shares with the solver what the air is
// (densities, depths, phase functions) and nothing of how light gets through it: no levels, no
// harmonics, no level air.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "dewbow/math/sampling.h"
#include "dewbow/math/vector.h"
#include "dewbow/sky/air_optics.h"

namespace dewbow {

struct WalkEstimate {
    double mean = 0.0, standard_error = 0.0;
};

/// y is up at the eye; the sun's irradiance above the atmosphere is 1.
class BackwardWalk {
public:
    BackwardWalk(const ClearSky& sky, double lambda_nm, Vec3 to_sun)
        : optics_(air_optics(sky, lambda_nm * unit::nm)),
          asymmetry_(sky.aerosol_asymmetry),
          albedo_(sky.ground_albedo),
          eye_m_(std::max(sky.eye_height_m, 1e-3)),
          to_sun_(to_sun) {}

    /// Radiance seen from the sky's eye along `direction`.
    WalkEstimate radiance(Vec3 direction, int photons, std::uint64_t seed) {
        state_ = seed;
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < photons; ++i) {
            const double x = one(direction);
            sum += x;
            squares += x * x;
        }
        const double mean = sum / photons;
        return {mean, std::sqrt((squares / photons - mean * mean) / photons)};
    }

private:
    double uniform() {
        // splitmix64 [Steele, Lea & Flood 2014]
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15ull;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double height(Vec3 p) const { return length(p) - kSkyRadius_m; }
    double extinction(double h) const { return dot(optics_.depth, air_density(h)); }

    /// Sunlight at a point.
    double beam(Vec3 p) const {
        const double sine = dot(p, to_sun_) / length(p), h = std::max(height(p), 0.0);
        const double visible = visible_share_of_sun(h, sine);
        if (visible <= 0.0) return 0.0;
        return visible * std::exp(-dot(optics_.depth, air_mass_to_space(h, sine)));
    }

    /// Distance to the ground, or a negative number.
    static double to_ground(Vec3 p, Vec3 d) {
        const double b = dot(p, d), c = dot(p, p) - kSkyRadius_m * kSkyRadius_m;
        const double root = b * b - c;
        return b < 0.0 && root > 0.0 ? -b - std::sqrt(root) : -1.0;
    }

    /// Moves to the next collision, by null collisions in pieces of the flight each with a bound
    /// of its own. False if the photon leaves the air; `ground` if it meets that first.
    bool fly(Vec3& p, Vec3 d, bool& ground) {
        double left = to_ground(p, d);
        ground = false;
        while (true) {
            const double h = height(p);
            if (h > kSkyTop_m) return false;
            const double piece = 500.0 + 0.25 * h;
            const double bound = extinction(std::max(h - piece, 0.0));
            const double s = -std::log(1.0 - uniform()) / bound;
            const double step = std::min(s, piece);
            if (left >= 0.0 && step >= left) {
                p = p + d * left;
                ground = true;
                return true;
            }
            p = p + d * step;
            if (left >= 0.0) left -= step;
            if (s < piece && uniform() * bound < extinction(height(p))) return true;
        }
    }

    Vec3 scattered(Vec3 d, bool by_haze) {
        double cosine = 0.0;
        if (by_haze) {
            const double g = asymmetry_, u = 2.0 * uniform() - 1.0;
            const double f = (1.0 - g * g) / (1.0 + g * u);
            cosine = g > 1e-3 ? (1.0 + g * g - f * f) / (2.0 * g) : u;
        } else {
            do {
                cosine = 2.0 * uniform() - 1.0;
            } while (uniform() * air_phase(1.0) > air_phase(cosine));
        }
        const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
        const double turn = 2.0 * std::numbers::pi * uniform();
        const Tangents frame = tangents_of(d);
        return normalised(d * cosine + frame.t * (sine * std::cos(turn)) +
                          frame.b * (sine * std::sin(turn)));
    }

    double one(Vec3 d) {
        Vec3 p{0.0, kSkyRadius_m + eye_m_, 0.0};
        double weight = 1.0, found = 0.0;
        bool ground = false;
        while (fly(p, d, ground)) {
            if (ground) {
                weight *= albedo_;
                p = p * ((kSkyRadius_m + 1e-3) / length(p));
                const Vec3 up = normalised(p);
                found += weight * std::max(0.0, dot(up, to_sun_)) / std::numbers::pi * beam(p);
                const double sine = std::sqrt(uniform());
                const double turn = 2.0 * std::numbers::pi * uniform();
                const Tangents frame = tangents_of(up);
                d = normalised(up * std::sqrt(1.0 - sine * sine) +
                               frame.t * (sine * std::cos(turn)) +
                               frame.b * (sine * std::sin(turn)));
            } else {
                const AirParts here = air_density(height(p));
                const double all = dot(optics_.depth, here);
                const double air = optics_.depth.air * here.air;
                const double haze = optics_.haze_scattering * here.haze;
                weight *= (air + haze) / all;
                const double cosine = dot(d, to_sun_);
                found += weight * beam(p) *
                         (air * air_phase(cosine) + haze * haze_phase(cosine, asymmetry_)) /
                         (air + haze);
                d = scattered(d, uniform() * (air + haze) >= air);
            }
            if (weight < 0.1) {
                if (uniform() < 0.5) break;
                weight *= 2.0;
            }
        }
        return found;
    }

    AirOptics optics_;
    double asymmetry_, albedo_, eye_m_;
    Vec3 to_sun_;
    std::uint64_t state_ = 0;
};

}  // namespace dewbow
