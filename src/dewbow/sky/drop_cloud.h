// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the drops of a rain do to light, per metre: extinction, and the phase function that makes
// bows. Where the rain is, and what its law makes of both, rain_region.h and rain_law.h say.
//
// Half of what a large drop takes out of a beam is light diffracted around it within a fraction of
// a degree. Nobody can tell it from light that went straight on, so it is not counted as scattered:
// up to kForwardCut from the forward direction the phase function keeps its value at kForwardCut,
// and the light above that leaves extinction and phase function together. Coronas that are wider,
// of drops smaller than about 50 µm, stay.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dewbow/optics/phase_function.h"
#include "dewbow/rainbow/cloud_scattering.h"
#include "dewbow/rainbow/sun_disc.h"
#include "dewbow/sky/phase_lookup.h"
#include "dewbow/sky/rain_amount.h"
#include "dewbow/sky/visible_grid.h"

namespace dewbow {

/// About the sun's diameter: light that is turned by less is sunlight still.
inline constexpr Angle kForwardCut = 0.5 * unit::deg;

/// Drops of a single size are taken to differ by this much (standard deviation over the mean): no
/// real ones are more alike, and it washes out ripples that are finer than any eye or table.
inline constexpr double kLeastWidth = 0.01;

struct DropCloudRequest {
    std::string model = "auto";  ///< one that knows all angles: auto, mie, debye or descartes
    /// Of light in the drop; empty: all. Where some are chosen, extinction is the geometric cross
    /// section, and what the others would scatter is lost.
    Orders orders;
    double tolerance = 0.02;            ///< of `auto`
    std::vector<DropSizesPtr> showers;  ///< kinds of drops of the same cross section each
    DropOptics optics;
    RainAmount amount;
    std::vector<SunDisc> discs;  ///< of the suns that will shine on it
};

/// Immutable; may be shared by threads. Wavelengths are in vacuum, in nm; outside 360 to 830 nm
/// they count as the nearest of these.
class DropCloud {
public:
    /// As in the request, after a point: discs()[0].
    std::span<const SunDisc> discs() const { return discs_; }
    /// Its number; InputError for a disc that was not asked for.
    std::size_t disc_of(const SunDisc& disc) const;

    /// m⁻¹, where the rain's density is 1. All `out` are as long as `lambda_nm`.
    void extinction_lanes(std::span<const double> lambda_nm, std::span<double> out) const;
    /// Share of extinction that is scattered, ϖ: 0 to 1.
    void albedo_lanes(std::span<const double> lambda_nm, std::span<double> out) const;
    /// Of what is scattered, the share per sr of light polarised perpendicular and parallel to the
    /// plane of scattering, p / 4π, on average over the disc of the source. The mean of both
    /// integrates to 1 over the sphere: to 1e-12 for a point, to 1e-3 for discs.
    /// @param cosine  of the angle between light's direction before and after.
    void phase_lanes(double cosine, std::size_t disc, std::span<const double> lambda_nm,
                     std::span<Intensities> out) const {
        phases_[disc].eval_lanes(cosine, lambda_nm, out);
    }
    /// That of a point, without polarisation.
    PhaseFunctionPtr phase() const { return point_; }

    /// A cosine of the scattering angle, in proportion to the phase function of white light: its
    /// mean over wavelengths by x̄ + ȳ + z̄.   @param u  0 to 1.
    double sample_cosine(double u) const;
    /// Density per sr of that, at a cosine: integrates to 1 over the sphere. It is constant in
    /// steps between the table's angles, and nowhere 0 where the phase function is not.
    double cosine_pdf(double cosine) const;

    double drops_per_m3() const { return drops_per_m3_; }
    double rain_rate_mm_per_h() const { return rain_rate_mm_per_h_; }
    const std::string& report() const { return report_; }  ///< what the model chose
    /// A file of the cache that could not be read or written, and why; empty if all is well.
    const std::string& note() const { return note_; }
    /// Text that depends on all that this object's numbers depend on.
    const std::string& identity() const { return identity_; }

private:
    friend class DropCloudMaker;
    DropCloud() = default;

    std::vector<SunDisc> discs_;
    VisibleValues extinction_{}, albedo_{};
    std::shared_ptr<const AngleIndex> angles_;
    std::vector<PhaseLookup> phases_;  ///< [disc]
    PhaseFunctionPtr point_;
    std::vector<double> below_, density_;  ///< of cosine_pdf: [angle] integral up to it, [cell]
    double drops_per_m3_ = 0.0, rain_rate_mm_per_h_ = 0.0;
    std::string report_, note_, identity_;
};
using DropCloudPtr = std::shared_ptr<const DropCloud>;

/// @param cache  folder where tables are kept (table_cache.h); empty: nowhere.
/// Throws InputError: what is missing or out of range; a model that has no light far from its bows;
/// what the model cannot treat.
DropCloudPtr make_drop_cloud(const DropCloudRequest& request,
                             const std::filesystem::path& cache = {});

}  // namespace dewbow
