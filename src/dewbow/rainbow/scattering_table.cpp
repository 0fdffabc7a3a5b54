// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/scattering_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/size_sampling.h"

namespace dewbow {
namespace {

using namespace unit;

/// Wavelengths that are asked for: where waves in water are what they are here.
constexpr Wavelength kShortest = 100.0 * nm, kLongest = 20000.0 * nm;

void check_wavelengths(const std::vector<Wavelength>& wavelengths) {
    if (wavelengths.empty()) throw InputError("no wavelengths; expected at least one");
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double value = wavelengths[i].to(nm);
        if (!(wavelengths[i] >= kShortest && wavelengths[i] <= kLongest))
            throw InputError(fmt::format("wavelength {:.6g} nm; expected {:.6g} to {:.6g} nm",
                                         value, kShortest.to(nm), kLongest.to(nm)));
        if (i > 0 && !(wavelengths[i] > wavelengths[i - 1]))
            throw InputError(
                fmt::format("wavelength {:.6g} nm after {:.6g} nm; expected ascending ones", value,
                            wavelengths[i - 1].to(nm)));
    }
}

void check_angles(const std::vector<Angle>& angles) {
    if (angles.empty()) throw InputError("no angles; expected at least one");
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double value = angles[i].to(deg);
        if (!(angles[i] >= 0.0 * deg && angles[i] <= 180.0 * deg))
            throw InputError(
                fmt::format("scattering angle {:.6g} deg; expected 0 to 180 deg", value));
        if (i > 0 && !(angles[i] > angles[i - 1]))
            throw InputError(
                fmt::format("scattering angle {:.6g} deg after {:.6g} deg; expected ascending ones",
                            value, angles[i - 1].to(deg)));
    }
}

void check(const TableRequest& request) {
    if (!request.sizes) throw InputError("no drop sizes");
    if (!request.optics.drop || !request.optics.around)
        throw InputError("no refractive index of the drops, or of what is around them");
    if (!(request.tolerance > 0.0 && request.tolerance <= 1.0))
        throw InputError(
            fmt::format("tolerance {:.6g}; expected above 0, at most 1", request.tolerance));
    check_wavelengths(request.wavelengths);
    check_angles(request.angles);
}

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
    return sample_sizes(*request.sizes, sampling);
}

/// Drops that a model is asked about at once: its answers for all of them and all angles stay in
/// the caches of a core, and models that share work between drops find enough of them.
constexpr std::size_t kDropsAtOnce = 16;

/// Σ share |S|², Σ share x², and efficiencies weighted by x², over all drops.
struct DropSums {
    std::vector<Intensities> intensities;  ///< [angle]
    double x_squared = 0.0;
    Efficiencies efficiencies;
};

DropSums sum_over_drops(const ScatteringModel& model, const DropOptics& optics, Wavelength lambda,
                        std::span<const WeightedRadius> radii, std::span<const Angle> angles) {
    const ComplexIndex index(optics.index(lambda).value, optics.extinction);
    DropSums sums;
    sums.intensities.resize(angles.size());
    std::vector<Intensities> block(kDropsAtOnce * angles.size());
    std::vector<Drop> drops;
    for (std::size_t first = 0; first < radii.size(); first += kDropsAtOnce) {
        const auto group = radii.subspan(first, std::min(kDropsAtOnce, radii.size() - first));
        drops.clear();
        for (const WeightedRadius& each : group)
            drops.push_back({optics.size_parameter(each.radius, lambda), {}});
        model.intensities(index, drops, angles, block);
        for (std::size_t d = 0; d < group.size(); ++d) {
            const double share = group[d].share;
            for (std::size_t a = 0; a < angles.size(); ++a) {
                const Intensities& one = block[d * angles.size() + a];
                sums.intensities[a].perpendicular += share * one.perpendicular;
                sums.intensities[a].parallel += share * one.parallel;
            }
            const double x = drops[d].size_parameter, weight = share * x * x;
            const Efficiencies q = model.efficiencies(index, drops[d]);
            sums.x_squared += weight;
            sums.efficiencies.extinction += weight * q.extinction;
            sums.efficiencies.scattering += weight * q.scattering;
            sums.efficiencies.asymmetry += weight * q.scattering * q.asymmetry;
        }
    }
    sums.efficiencies.asymmetry /= sums.efficiencies.scattering;
    sums.efficiencies.extinction /= sums.x_squared;
    sums.efficiencies.scattering /= sums.x_squared;
    return sums;
}

/// Calls body(i) in parallel; throws what the first of them threw, in order of i.
void parallel_or_throw(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::vector<std::exception_ptr> failures(count);
    parallel_for(count, [&](std::size_t i) {
        try {
            body(i);
        } catch (...) {
            failures[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace

double DropOptics::size_parameter(Length radius, Wavelength lambda) const {
    return 2.0 * std::numbers::pi * radius.to(1e-9 * m) * (*around)(lambda).value / lambda.to(nm);
}

ScatteringTable make_scattering_table(const TableRequest& request) {
    check(request);
    const ModelOptions options{request.orders, {}, request.tolerance};
    const auto model = make_scattering_model(request.model, options);
    const std::vector<WeightedRadius> radii = sample_radii(request);
    const std::size_t wavelength_count = request.wavelengths.size();

    ScatteringTable table;
    table.angles = request.angles;
    table.wavelengths = request.wavelengths;
    table.mean_cross_section = mean_cross_section(*request.sizes);
    table.phase.resize(request.angles.size() * wavelength_count);
    table.efficiencies.resize(wavelength_count);
    parallel_or_throw(wavelength_count, [&](std::size_t w) {
        const DropSums sums =
            sum_over_drops(*model, request.optics, request.wavelengths[w], radii, request.angles);
        table.efficiencies[w] = sums.efficiencies;
        // ∫ P dΩ = 4π, with dσ/dΩ = |S|² / k² and Σ πa² Q_sca = σ_sca.
        const double scale = 4.0 / (sums.x_squared * sums.efficiencies.scattering);
        for (std::size_t a = 0; a < request.angles.size(); ++a)
            table.phase[a * wavelength_count + w] = {scale * sums.intensities[a].perpendicular,
                                                     scale * sums.intensities[a].parallel};
    });
    return table;
}

}  // namespace dewbow
