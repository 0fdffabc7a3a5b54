// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/scattering_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/angle_grid.h"
#include "dewbow/rainbow/automatic.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/bow_model.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/size_sampling.h"
#include "dewbow/rainbow/sun_disc.h"
#include "dewbow/rainbow/table_checks.h"

namespace dewbow {
namespace {

using namespace unit;

/// Radii for what the bows' fringes do up to 10° from the bows.
std::vector<WeightedRadius> sample_radii(const TableRequest& request) {
    constexpr Angle kFromBow = 10.0 * deg;
    constexpr double kError = 2e-3;
    const Wavelength shortest = request.wavelengths.front();
    const RelativeIndex n = request.optics.index(shortest);
    SizeSampling sampling;
    sampling.error = kError;
    if (n.value > 1.0 && n.value < 2.0)  // else there is no primary bow
        sampling.fastest =
            fringe_rate(kFromBow, descartes_ray(n, 2).airy_constant,
                        shortest.to(nm) / (*request.optics.around)(shortest).value * 1e-9 * m);
    if (request.model == "auto" && !request.sizes->is_single()) {
        /// More radii cost `auto` next to nothing; it groups them as it needs them.
        constexpr double kMany = 1000.0;
        const Length range = request.sizes->largest() - request.sizes->smallest();
        sampling.fastest = std::max(sampling.fastest, kMany / range);
    }
    if (request.model == "airy" || request.model == "uniform_airy") {
        const Wavelength longest = request.wavelengths.back();
        sampling.least =
            kSmallestBowSize / request.optics.size_parameter(1.0 * m, longest) * (1.0 + 1e-12) * m;
    }
    return sample_sizes(*request.sizes, sampling);
}

CloudScattering scatter(const TableRequest& request, const Cloud& cloud,
                        std::span<const Angle> angles) {
    const ModelOptions options{
        request.orders, {relative_width(*request.sizes), request.disc.radius}, request.tolerance};
    if (request.model == "auto")
        return scatter_automatically(cloud, request.wavelengths, angles, options);
    const auto model = make_scattering_model(request.model, options);
    return scatter(*model, cloud, request.wavelengths, angles);
}

/// The angles asked for, and between and beyond them those that the disc needs.
std::vector<Angle> angles_for_disc(const TableRequest& request) {
    if (request.disc.radius == Angle{}) return request.angles;
    const DropOptics& optics = request.optics;
    const Wavelength shortest = request.wavelengths.front();
    AngleGrid grid{optics.index(request.wavelengths.back()), optics.index(shortest)};
    grid.x = optics.size_parameter(effective_radius(*request.sizes), shortest);
    const Length deviation = relative_width(*request.sizes) * mean_radius(*request.sizes);
    grid.fringes = optics.size_parameter(deviation, shortest) < kWashedOutDeviation;
    if (request.falling) grid.longest = 0.1 * deg;  // bows of large drops are anywhere
    grid.from = std::max(request.angles.front() - request.disc.radius, 0.0 * deg);
    grid.to = std::min(request.angles.back() + request.disc.radius, 180.0 * deg);
    return merged_angles(request.angles, adaptive_angles(grid));
}

/// Phase functions before the disc, [angle][wavelength].
std::vector<Intensities> phase_of(const CloudScattering& scattering, std::size_t angles) {
    const std::size_t wavelengths = scattering.sums.size();
    std::vector<Intensities> phase(angles * wavelengths);
    for (std::size_t w = 0; w < wavelengths; ++w) {
        const DropSums& sums = scattering.sums[w];
        // ∫ P dΩ = 4π, with dσ/dΩ = |S|² / k² and Σ πa² Q_sca = σ_sca.
        const double scale = 4.0 / (sums.x_squared * sums.efficiencies.scattering);
        for (std::size_t a = 0; a < angles; ++a)
            phase[a * wavelengths + w] = {scale * sums.intensities[a].perpendicular,
                                          scale * sums.intensities[a].parallel};
    }
    return phase;
}

}  // namespace

void check(const TableRequest& request) {
    if (!request.sizes) throw InputError("no drop sizes");
    if (!request.optics.drop || !request.optics.around)
        throw InputError("no refractive index of the drops, or of what is around them");
    if (!(request.tolerance > 0.0 && request.tolerance <= 1.0))
        throw InputError(
            fmt::format("tolerance {:.6g}; expected above 0, at most 1", request.tolerance));
    check_wavelengths(request.wavelengths);
    check_scattering_angles(request.angles);
}

ScatteringTable make_scattering_table(const TableRequest& request) {
    check(request);
    const Cloud cloud{request.optics, sample_radii(request), request.falling};
    const std::vector<Angle> angles = angles_for_disc(request);
    const CloudScattering scattering = scatter(request, cloud, angles);

    ScatteringTable table;
    table.angles = request.angles;
    table.wavelengths = request.wavelengths;
    table.mean_cross_section = mean_cross_section(*request.sizes);
    table.report = scattering.report;
    table.stated_error = scattering.stated_error;
    for (const DropSums& sums : scattering.sums) table.efficiencies.push_back(sums.efficiencies);
    table.phase = phase_of(scattering, angles.size());
    if (request.disc.radius != Angle{}) {
        std::vector<std::size_t> wanted;
        for (const Angle angle : request.angles)
            wanted.push_back(std::size_t(std::lower_bound(angles.begin(), angles.end(), angle) -
                                         angles.begin()));
        std::vector<Intensities> smooth(request.angles.size() * request.wavelengths.size());
        SunSmoother(angles, request.disc, wanted).apply(table.phase, smooth);
        table.phase = std::move(smooth);
    }
    return table;
}

}  // namespace dewbow
