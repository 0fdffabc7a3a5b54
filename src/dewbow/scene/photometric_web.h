// SPDX-License-Identifier: Apache-2.0
#pragma once

// How brightly a luminaire shines into each direction, as measured from far away: a table over two
// angles, linear in both between its rows.

#include <vector>

#include "dewbow/math/transform.h"

namespace dewbow {

/// A web as it is tabulated, in the angles of type C [IES LM-63-02, CIE 121:1996].
struct PhotometricTable {
    /// θ from the luminaire's downward axis (nadir), strictly ascending, at least two, within
    /// [0, 180] deg. The luminaire is dark outside of them.
    std::vector<double> vertical_deg;
    /// φ about that axis: {0} for a luminaire that shines alike all around, or strictly ascending
    /// from 0 to 360 deg, ends included.
    std::vector<double> horizontal_deg;
    /// [horizontal][vertical], row-major, >= 0. The rows of 0 and 360 deg are equal.
    std::vector<double> intensity_cd;
};

/// Immutable. Its own frame: −y is nadir (θ = 0), φ = 0 is +x and φ = 90 deg is −z, so that φ grows
/// counter-clockwise as seen from above.
class PhotometricWeb {
public:
    /// Throws InputError if `table` is not as PhotometricTable says, or wholly dark.
    explicit PhotometricWeb(PhotometricTable table);

    /// Luminous intensity in cd, bilinear in (θ, φ); θ in [0, π], any φ.
    double intensity_cd(double theta_rad, double phi_rad) const;
    double intensity_cd(Dir<Object> direction) const;

    /// Luminous flux of the whole web in lm: ∫∫ I sin θ dθ dφ, exact for the bilinear table.
    double flux_lm() const { return flux_lm_; }
    /// flux / 4π: what the intensity would be if it were the same everywhere.
    double mean_intensity_cd() const;
    /// Largest intensity, which is one of the table.
    double max_intensity_cd() const { return max_intensity_cd_; }

    const PhotometricTable& table() const { return table_; }

private:
    double row_intensity(std::size_t row, std::size_t column, double share) const;

    PhotometricTable table_;
    double flux_lm_ = 0.0, max_intensity_cd_ = 0.0;
};

}  // namespace dewbow
