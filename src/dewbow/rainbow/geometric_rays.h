// SPDX-License-Identifier: Apache-2.0
#pragma once

// Which rays leave a drop at a given angle, and how bright they are.
//
// dσ/dΩ = a² Σ ε² b / (sin θ |dθ/db|) over the rays, so that |S|² = x² Σ ε² b / (sin θ |dθ/db|),
// with the impact parameter b in radii and ε the amplitude that is left. Phases are not summed.
//                                                                       [van de Hulst 1957, §12.2]

#include <vector>

#include "dewbow/base/quantity.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/scattering.h"

namespace dewbow {

/// Rays of one order between two neighbours among: the axis, the bow, the edge of the drop, and the
/// rays that leave at 0° or 180°. On it the scattering angle is a monotone function of the impact
/// parameter, and each angle from `least` to `greatest` has one ray.
class RayBranch {
public:
    int p = 0;
    RelativeIndex n;
    Angle least, greatest;  ///< scattering angles at its ends

    /// Angle of incidence of the ray that leaves at `theta`, which is within the ends.
    /// Error: 4e-16 of the deflection, over its slope; so 1e-8 at the bow itself.
    Angle incidence_at(Angle theta) const;

private:
    friend class RaySearch;
    friend std::vector<RayBranch> ray_branches(RelativeIndex n, int p);
    /// 2i − 2pr of the ray that leaves at theta is level + side θ.
    double level_ = 0.0;
    int side_ = 1;
    /// The branch is a part of these rays, along which 2i − 2pr is monotone and least_ at the bow.
    double from_ = 0.0, to_ = 0.0, at_from_ = 0.0, at_to_ = 0.0, least_ = 0.0;
};

/// Looks for rays of a branch one after the other: twice as fast where each angle is near the
/// last one.
class RaySearch {
public:
    explicit RaySearch(const RayBranch& branch);
    /// Angle of incidence in radians, with its sine (the impact parameter) and cosine.
    struct Ray {
        double incidence = 0.0, sine = 0.0, cosine = 1.0;
    };
    /// The ray that leaves at `theta`, within the branch's ends. Error: as incidence_at.
    Ray at(Angle theta);

private:
    double root(double turn) const;
    Ray bracketed(double wanted);

    const RayBranch& branch_;
    double root_from_, root_to_, mean_slope_;
    /// The last ray, the root there, and di over its change.
    double incidence_, root_, slope_;
};

/// All rays of order p, from the axis to the edge of the drop.
/// Throws InputError unless p >= 0 and n > 1, and n < p where p >= 2 (so that there is a bow).
std::vector<RayBranch> ray_branches(RelativeIndex n, int p);

struct GeometricRay {
    DropRay ray;
    double impact_parameter = 0.0;  ///< sin i
    double slope = 0.0;             ///< |dθ/db| in radians: 0 at the bow, infinite at b = 1
    RayAmplitudes amplitudes;
    /// What it adds to |S|² / x²: without limit at the bow, and at 0° and 180° unless it runs along
    /// the axis.
    Intensities intensity;
};

/// The rays of order p that leave at `theta`, 0 to 180°, ordered by impact parameter.
/// Throws InputError as above.
std::vector<GeometricRay> geometric_rays(RelativeIndex n, int p, Angle theta);
/// The same, for those who ask for many angles of one index and order.
std::vector<GeometricRay> geometric_rays(const std::vector<RayBranch>& branches, Angle theta);

/// |S|² / x² of order p at `theta`, the rays' phases left aside.
Intensities geometric_intensity(RelativeIndex n, int p, Angle theta);

}  // namespace dewbow
