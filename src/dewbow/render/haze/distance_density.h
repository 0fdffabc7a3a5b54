// SPDX-License-Identifier: Apache-2.0
#pragma once

// Where along a ray through haze a point is taken that scatters light into it.

#include <limits>
#include <span>

#include "dewbow/render/lanes.h"

namespace dewbow {

/// The part of a ray between two distances; `end` may be infinite.
struct RayInterval {
    double begin = 0.0, end = std::numeric_limits<double>::infinity();  ///< m
    bool empty() const { return !(begin < end); }
};

/// A density over distances along a ray: a mixture of terms, each in proportion to what one lamp
/// is expected to bring. One number becomes one distance; the lanes of a packet share it.
class DistanceDensity {
public:
    static constexpr int kMostTerms = 32;

    /// @param extinction  m⁻¹, one a lane. Lanes without any scatter nothing: they ask for nothing.
    explicit DistanceDensity(std::span<const double> extinction);

    /// In proportion to 1 / (width² + (t − centre)²): as the irradiance of a lamp falls off that
    /// lies beside `centre`, at the distance `width` from the ray, so that equal steps are seen
    /// from it under equal angles.
    /// [Kulla & Fajardo, "Importance Sampling Techniques for Path Tracing in Participating Media",
    /// 2012, section 4]
    /// @param intensity  of the lamp: its irradiance at the distance 1 m.
    void add_equiangular(RayInterval where, double centre, double width, double intensity);
    /// In proportion to what is left of light on its way to the ray's origin, the lanes alike: for
    /// what lights all of `where` evenly.   @param irradiance  there.
    void add_attenuated(RayInterval where, double irradiance);
    /// Gives a share of `defensive` to what lights all of `where` evenly: no distance is starved by
    /// terms that know less than there is, or that there was no room for.
    void finish(RayInterval where, double defensive);

    /// Nothing is scattered at any lane.
    bool empty() const { return count_ == 0; }
    /// @param u  in [0, 1).
    double sample(double u) const;
    /// Per metre.
    double pdf(double distance) const;

private:
    struct Term {
        double weight;
        RayInterval where;
        bool equiangular;
        double centre, width;  ///< of an equiangular one
        double angle;          ///< the range that it sees, rad
    };
    struct Extinction {
        double per_m, share;
    };
    std::span<Extinction> extinctions() {
        return {extinctions_.data(), std::size_t(extinction_count_)};
    }
    std::span<const Extinction> extinctions() const {
        return {extinctions_.data(), std::size_t(extinction_count_)};
    }
    void add(const Term& term);
    double sample(const Term& term, double u) const;
    double pdf(const Term& term, double distance) const;

    std::array<Extinction, kMaxLanes> extinctions_;  ///< those that differ
    int extinction_count_ = 0;
    std::array<Term, kMostTerms> terms_;
    int count_ = 0;
    double total_ = 0.0;
};

}  // namespace dewbow
