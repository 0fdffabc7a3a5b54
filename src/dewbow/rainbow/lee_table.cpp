// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/lee_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/angle_grid.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/composition.h"
#include "dewbow/rainbow/mie_correction.h"
#include "dewbow/rainbow/scattering_table.h"
#include "dewbow/rainbow/size_classes.h"
#include "dewbow/rainbow/table_checks.h"

namespace dewbow {
namespace {

using namespace unit;

/// Radii of one distribution, and those at which Mie theory corrects, as quotients of neighbours:
/// between them what it adds, over Σ x², goes straight in ln r.
constexpr std::size_t kSampledRadii = 256;
constexpr double kCorrectedRatio = 1.15;
/// CPU time for all corrections; those of small drops are large, and need to be better.
constexpr double kCorrectionNs = 2e8, kSmallDrops = 400.0, kForSmallDrops = 4.0;
/// The tolerance that the times above are for. What is left by chance falls with the root of them.
constexpr double kUsualTolerance = 0.02;
/// Parts of an Airy unit, see AngleGrid: enough before the sun's disc.
constexpr double kParts = 6.0;

void check(const LeeRequest& request) {
    if (request.radii.empty()) throw InputError("no drop radii; expected at least one");
    for (std::size_t i = 1; i < request.radii.size(); ++i)
        if (!(request.radii[i] > request.radii[i - 1]))
            throw InputError(
                fmt::format("drop radius {:.6g} mm after {:.6g} mm; expected "
                            "ascending ones",
                            request.radii[i].to(mm), request.radii[i - 1].to(mm)));
    if (!(request.width >= 0.0 && request.width <= 1.0))
        throw InputError(fmt::format(
            "width {:.6g} of drop sizes; expected 0 (one size) to 1, as part of their mean",
            request.width));
    if (!request.optics.drop || !request.optics.around)
        throw InputError("no refractive index of the drops, or of what is around them");
    check_wavelengths(request.wavelengths);
    check_scattering_angles(request.angles);
}

DropSizesPtr sizes_around(Length radius, double width) {
    return width == 0.0 ? single_drop_size(radius) : gamma_drop_sizes(radius, width);
}

/// Σ x² Q_sca over Σ x² of clear spheres, Q = 2 + 1.9924 x^{−2/3}, for the mean of sizes around x.
/// Error: 2e-4 at x = 300, 7e-4 at 150.   [Nussenzveig & Wiscombe, Phys. Rev. Lett. 45 (1980) 1490]
double edge_efficiency(double x) { return 2.0 + 1.9924 * std::pow(x, -2.0 / 3.0); }

/// Radii whose drops differ so much among themselves that orders of light do not interfere.
class WideRadii {
public:
    WideRadii(const LeeRequest& request, std::span<const Length> radii);
    /// Writes [angle][wavelength] of radius number k.
    void compute(std::size_t k, std::span<Intensities> out) const;
    double error() const { return error_; }
    std::size_t corrected_radii() const { return centres_.size(); }

private:
    /// Σ over classes around `radius`, as those around the reference.
    Cloud cloud_around(Length radius) const;
    void add_corrections(Length radius, std::size_t w, std::span<Intensities> per_square) const;

    const LeeRequest& request_;
    std::span<const Length> radii_;
    Length reference_radius_;
    Wavelength reference_;
    std::vector<Angle> angles_;
    std::vector<WeightedRadius> classes_;  ///< around the reference radius
    std::vector<double> sizes_, shares_;
    DropAverages averages_;  ///< around the reference radius, at the reference wavelength
    CompositionFamily compositions_;
    std::vector<ComposedLight> light_;  ///< [wavelength]
    /// What Mie theory adds at one radius, over Σ x².
    struct Correction {
        std::vector<std::size_t> angles;  ///< their numbers
        std::vector<Intensities> more;    ///< [wavelength][of those angles]
    };
    Correction correction_at(Length radius, double budget_ns);

    std::vector<Length> centres_;
    std::vector<Correction> corrections_;  ///< [centre]
    SunSmoother smoother_;
    double error_ = 0.0;
};

std::vector<Angle> angles_for(const LeeRequest& request, Length largest) {
    if (request.disc.radius == Angle{}) return request.angles;
    const DropOptics& optics = request.optics;
    AngleGrid grid{optics.index(request.wavelengths.back()),
                   optics.index(request.wavelengths.front())};
    grid.x = optics.size_parameter(largest, request.wavelengths.front());
    grid.from = std::max(request.angles.front() - request.disc.radius, 0.0 * deg);
    grid.to = std::min(request.angles.back() + request.disc.radius, 180.0 * deg);
    grid.parts = kParts;
    return merged_angles(request.angles, adaptive_angles(grid));
}

std::vector<std::size_t> numbers_of(std::span<const Angle> wanted, std::span<const Angle> all) {
    std::vector<std::size_t> numbers;
    for (const Angle angle : wanted)
        numbers.push_back(
            std::size_t(std::lower_bound(all.begin(), all.end(), angle) - all.begin()));
    return numbers;
}

std::vector<double> size_parameters(const DropOptics& optics,
                                    std::span<const WeightedRadius> classes, Wavelength lambda) {
    std::vector<double> sizes;
    for (const WeightedRadius& drop : classes)
        sizes.push_back(optics.size_parameter(drop.radius, lambda));
    return sizes;
}

std::vector<double> shares_of(std::span<const WeightedRadius> classes) {
    std::vector<double> shares;
    for (const WeightedRadius& drop : classes) shares.push_back(drop.share);
    return shares;
}

std::vector<WeightedRadius> classes_around(Length radius, double width) {
    const DropSizesPtr sizes = gamma_drop_sizes(radius, width);
    SizeSampling sampling;
    sampling.fastest = double(kSampledRadii) / (sizes->largest() - sizes->smallest());
    return sample_sizes(*sizes, sampling);
}

WideRadii::WideRadii(const LeeRequest& request, std::span<const Length> radii)
    : request_(request),
      radii_(radii),
      reference_radius_(radii[radii.size() / 2]),
      reference_(request.wavelengths[request.wavelengths.size() / 2]),
      angles_(angles_for(request, radii.back())),
      classes_(classes_around(reference_radius_, request.width)),
      sizes_(size_parameters(request.optics, classes_, reference_)),
      shares_(shares_of(classes_)),
      averages_(sizes_, shares_),
      compositions_(request.optics.index(request.wavelengths.back()),
                    request.optics.index(request.wavelengths.front()), {}),
      light_(request.wavelengths.size()),
      smoother_(angles_, request.disc, numbers_of(request.angles, angles_)) {
    parallel_or_throw(light_.size(), [&](std::size_t w) {
        light_[w] = compositions_.at(request.optics.index(request.wavelengths[w])).at(angles_);
    });
    const double finer = kUsualTolerance / request.tolerance;
    const double steps =
        std::ceil(std::log(radii.back() / radii.front()) / std::log(kCorrectedRatio));
    for (double k = 0.0; k <= steps; ++k) {
        const double t = steps > 0.0 ? k / steps : 0.0;
        centres_.push_back(radii.front() * std::pow(radii.back() / radii.front(), t));
        corrections_.push_back(
            correction_at(centres_.back(), kCorrectionNs * finer * finer / (steps + 1.0)));
    }
}

WideRadii::Correction WideRadii::correction_at(Length radius, double budget_ns) {
    const Cloud cloud = cloud_around(radius);
    const double x = request_.optics.size_parameter(moments_of(cloud.radii).effective, reference_);
    const AutomaticPlan plan = plan_angles(x, is_point(request_.disc.radius), request_.tolerance);
    error_ = std::max(error_, plan.error);
    const bool none = std::all_of(angles_.begin(), angles_.end(), [&](Angle angle) {
        return exact_weight(plan.exact, angle) == 0.0;
    });
    if (none) return {};
    const SummedOrders orders(cloud, reference_, compositions_,
                              averages_.rescaled(radius / reference_radius_));
    const MieCorrection mie(cloud, orders, request_.wavelengths, angles_, plan.exact,
                            budget_ns * (x < kSmallDrops ? kForSmallDrops : 1.0));
    Correction correction{{mie.corrected().begin(), mie.corrected().end()}, {}};
    for (std::size_t w = 0; w < request_.wavelengths.size(); ++w)
        for (std::size_t c = 0; c < mie.corrected().size(); ++c) {
            const Intensities more = mie.at(w, c);
            const double weight = mie.weights()[c];
            correction.more.push_back({weight * more.perpendicular, weight * more.parallel});
        }
    return correction;
}

Cloud WideRadii::cloud_around(Length radius) const {
    Cloud cloud{request_.optics, classes_, {}};
    for (WeightedRadius& drop : cloud.radii) drop.radius *= radius / reference_radius_;
    return cloud;
}

void WideRadii::add_corrections(Length radius, std::size_t w,
                                std::span<Intensities> per_square) const {
    const auto above = std::upper_bound(centres_.begin(), centres_.end(), radius);
    const auto upper = std::min(std::size_t(above - centres_.begin()), centres_.size() - 1);
    const std::size_t lower = upper > 0 ? upper - 1 : 0;
    const double t = lower == upper ? 1.0
                                    : std::clamp(std::log(radius / centres_[lower]) /
                                                     std::log(centres_[upper] / centres_[lower]),
                                                 0.0, 1.0);
    const auto add = [&](const Correction& correction, double part) {
        const std::size_t count = correction.angles.size();
        for (std::size_t c = 0; c < count; ++c) {
            const Intensities& more = correction.more[w * count + c];
            Intensities& sum = per_square[correction.angles[c]];
            sum.perpendicular += part * more.perpendicular;
            sum.parallel += part * more.parallel;
        }
    };
    if (lower != upper) add(corrections_[lower], 1.0 - t);
    add(corrections_[upper], t);
}

void WideRadii::compute(std::size_t k, std::span<Intensities> out) const {
    const std::size_t wavelengths = request_.wavelengths.size();
    const DropOptics& optics = request_.optics;
    std::vector<Intensities> phase(angles_.size() * wavelengths), sum(angles_.size());
    for (std::size_t w = 0; w < wavelengths; ++w) {
        const Wavelength lambda = request_.wavelengths[w];
        const double ratio = optics.size_parameter(radii_[k], lambda) /
                             optics.size_parameter(reference_radius_, reference_);
        const DropAverages averages = averages_.rescaled(ratio);
        const double square = averages.fringes.mean_square();
        std::fill(sum.begin(), sum.end(), Intensities{});
        light_[w].add(averages, sum);
        for (Intensities& each : sum) each = {each.perpendicular / square, each.parallel / square};
        add_corrections(radii_[k], w, sum);
        const double scale = 4.0 / edge_efficiency(averages.fringes.effective_size());
        for (std::size_t a = 0; a < angles_.size(); ++a)
            phase[a * wavelengths + w] = {scale * std::max(sum[a].perpendicular, 0.0),
                                          scale * std::max(sum[a].parallel, 0.0)};
    }
    smoother_.apply(phase, out);
}

/// One radius by itself. Returns the error stated.
double compute_alone(const LeeRequest& request, Length radius, std::span<Intensities> out) {
    TableRequest one;
    one.sizes = sizes_around(radius, request.width);
    one.optics = request.optics;
    one.tolerance = request.tolerance;
    one.wavelengths = request.wavelengths;
    one.angles = request.angles;
    one.disc = request.disc;
    const ScatteringTable table = make_scattering_table(one);
    std::copy(table.phase.begin(), table.phase.end(), out.begin());
    return table.stated_error;
}

/// The interval of `points` that holds x, and how far in it.
struct Place {
    std::size_t lower = 0, upper = 0;
    double t = 0.0;
};
template <class Value>
Place place_in(const std::vector<Value>& points, Value x, double (*scale)(Value)) {
    if (points.size() == 1 || !(x > points.front())) return {};
    if (x >= points.back()) return {points.size() - 1, points.size() - 1, 0.0};
    const auto upper =
        std::size_t(std::upper_bound(points.begin(), points.end(), x) - points.begin());
    const double from = scale(points[upper - 1]), to = scale(points[upper]);
    return {upper - 1, upper, (scale(x) - from) / (to - from)};
}

Intensities mixed(const Intensities& a, const Intensities& b, double t) {
    return {a.perpendicular + t * (b.perpendicular - a.perpendicular),
            a.parallel + t * (b.parallel - a.parallel)};
}

}  // namespace

LeeTable make_lee_table(const LeeRequest& request) {
    check(request);
    LeeTable table;
    table.radii = request.radii;
    table.angles = request.angles;
    table.wavelengths = request.wavelengths;
    const std::size_t row = request.angles.size() * request.wavelengths.size();
    table.phase.resize(request.radii.size() * row);
    const auto row_of = [&](std::size_t r) { return std::span(table.phase).subspan(r * row, row); };

    // Small drops first, one by one: those whose orders interfere.
    std::size_t alone = 0;
    while (alone < request.radii.size() &&
           (request.optics.extinction > 0.0 ||
            request.width * request.optics.size_parameter(request.radii[alone],
                                                          request.wavelengths.back()) <
                kWashedOutDeviation)) {
        table.stated_error = std::max(table.stated_error,
                                      compute_alone(request, request.radii[alone], row_of(alone)));
        ++alone;
    }
    if (alone > 0) table.report = fmt::format("{} radii one by one", alone);
    if (alone == request.radii.size()) return table;
    const std::span<const Length> radii = std::span(request.radii).subspan(alone);
    const WideRadii wide(request, radii);
    parallel_or_throw(radii.size(), [&](std::size_t k) { wide.compute(k, row_of(alone + k)); });
    table.stated_error = std::max(table.stated_error, wide.error());
    table.report += fmt::format("{}{} radii by the sum of orders, corrected by mie at {} of them",
                                alone > 0 ? "; " : "", radii.size(), wide.corrected_radii());
    return table;
}

Intensities LeeTable::lookup(Length radius, Angle theta, Wavelength lambda) const {
    const Place r = place_in<Length>(radii, radius, [](Length v) { return std::log(v.to(m)); });
    const Place a = place_in<Angle>(angles, theta, [](Angle v) { return v.to(rad); });
    const Place w =
        place_in<Wavelength>(wavelengths, lambda, [](Wavelength v) { return v.to(nm); });
    const auto along_w = [&](std::size_t i, std::size_t j) {
        return mixed(at(i, j, w.lower), at(i, j, w.upper), w.t);
    };
    const auto along_a = [&](std::size_t i) {
        return mixed(along_w(i, a.lower), along_w(i, a.upper), a.t);
    };
    return mixed(along_a(r.lower), along_a(r.upper), r.t);
}

}  // namespace dewbow
