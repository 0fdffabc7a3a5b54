// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/size_sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "dewbow/base/error.h"

namespace dewbow {
namespace {

using namespace unit;
constexpr std::size_t kMostRadii = 100000;

double softplus(double t) { return t > 30.0 ? t : std::log1p(std::exp(t)); }
double inverse_softplus(double r) { return r > 30.0 ? r : std::log(std::expm1(r)); }
double logistic(double t) { return 1.0 / (1.0 + std::exp(-t)); }

/// r = s ln(1 + e^{q/s}) in even steps of q; towards an abrupt end q = ρ − e ln(1 + e^{(ρ −
/// end)/e}) in even steps of ρ.
class Steps {
public:
    explicit Steps(const DropSizes& sizes)
        : sizes_(sizes),
          scale_m_(effective_radius(sizes).to(m) / 3.0),
          first_m_(scale_m_ * inverse_softplus(sizes.smallest().to(m) / scale_m_)) {
        const Length end = sizes.largest();
        last_m_ = scale_m_ * inverse_softplus(end.to(m) / scale_m_);
        if (sizes.density(1.0001 * end) > 0.0) return;
        end_m_ = last_m_;
        last_m_ += kEndScales * end_scale_m();
    }

    /// Of ρ.
    double span_m() const { return last_m_ - first_m_; }

    /// Radii at the middles of `count` equal steps, with shares as the trapezoidal rule has them;
    /// `rho_m` takes the places.
    std::vector<WeightedRadius> take(std::size_t count,
                                     std::vector<double>* rho_m = nullptr) const {
        const double step_m = span_m() / double(count);
        std::vector<WeightedRadius> radii(count);
        for (std::size_t i = 0; i < count; ++i) {
            const double rho = first_m_ + (double(i) + 0.5) * step_m;
            double q = rho, slope = 1.0;
            if (end_m_ > 0.0) {
                q -= end_scale_m() * softplus((rho - end_m_) / end_scale_m());
                slope = logistic((end_m_ - rho) / end_scale_m());
            }
            radii[i].radius = scale_m_ * softplus(q / scale_m_) * m;
            radii[i].share =
                sizes_.density(radii[i].radius) * logistic(q / scale_m_) * slope * step_m;
            if (rho_m) rho_m->push_back(rho);
        }
        return radii;
    }

private:
    /// The slope there is e^{−14}, 1e-6 of what little there is at the end.
    static constexpr double kEndScales = 14.0;
    /// e. Half as much would need as many more radii along the way as it saves at the end.
    double end_scale_m() const { return 0.15 * scale_m_; }

    const DropSizes& sizes_;
    double scale_m_, first_m_, last_m_ = 0.0;
    double end_m_ = 0.0;  ///< of q where it is abrupt, or 0
};

double mean_power(const std::vector<WeightedRadius>& radii, int power) {
    double sum = 0.0;
    for (const WeightedRadius& drop : radii) sum += drop.share * std::pow(drop.radius.to(m), power);
    return sum;
}

/// Largest relative error of ⟨r²⟩ and ⟨r³⟩.
double moment_error(const std::vector<WeightedRadius>& radii, const DropSizes& sizes) {
    double worst = 0.0;
    for (const int power : {2, 3})
        worst = std::max(worst, std::abs(mean_power(radii, power) / sizes.mean_power(power) - 1.0));
    return worst;
}

/// Drops below the first radius are of that radius from now on: less than 1e-7 of the cross
/// section.
void sum_to_one(std::vector<WeightedRadius>& radii) {
    double rest = 1.0;
    for (std::size_t i = 1; i < radii.size(); ++i) rest -= radii[i].share;
    if (rest >= 0.0) {
        radii.front().share = rest;
        return;
    }
    // Only rounding and the rule's own error can bring the others above 1.
    radii.front().share = 0.0;
    for (WeightedRadius& drop : radii) drop.share /= 1.0 - rest;
}

/// Drops below `least` are of that radius from now on, if they matter little.
void merge_below(Length least, std::vector<WeightedRadius>& radii) {
    constexpr double kLittle = 1e-3;
    const auto kept = std::find_if(radii.begin(), radii.end(), [&](const WeightedRadius& drop) {
        return drop.radius >= least;
    });
    if (kept == radii.begin()) return;
    WeightedRadius merged{least, 0.0};
    for (auto drop = radii.begin(); drop != kept; ++drop) merged.share += drop->share;
    const double cross_section = merged.share * std::pow(least.to(m), 2);
    if (cross_section > kLittle * mean_power(radii, 2)) return;
    radii.erase(radii.begin(), kept);
    radii.insert(radii.begin(), merged);
}

/// Enough for 200 fringes over the range.
constexpr std::size_t kFine = 500;
constexpr double kMostFringes = 200.0;

/// The rate, per metre, from which on |Σ share r² e^{2πi f place}| is below `contrast` of Σ share
/// r².
double faded_rate(const std::vector<WeightedRadius>& radii, const std::vector<double>& places_m,
                  double span_m, double contrast) {
    const double whole = mean_power(radii, 2);
    const auto left = [&](double per_m) {
        std::complex<double> sum = 0.0;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const double r = radii[i].radius.to(m);
            sum += radii[i].share * r * r *
                   std::polar(1.0, 2.0 * std::numbers::pi * per_m * places_m[i]);
        }
        return std::abs(sum) / whole;
    };
    const double most = kMostFringes / span_m;
    double below = 0.0, above = 0.1 / span_m;
    while (above < most && left(above) > contrast) below = std::exchange(above, 1.25 * above);
    while (above - below > 0.001 * above) {
        const double middle = 0.5 * (below + above);
        (left(middle) > contrast ? below : above) = middle;
    }
    return std::min(above, most);
}

}  // namespace

InverseLength fringe_rate(Angle from_bow, double airy_constant, Length wavelength) {
    return 4.0 / 3.0 * std::pow(from_bow.to(rad), 1.5) / std::sqrt(airy_constant) / wavelength;
}

InverseLength washed_out_rate(const DropSizes& sizes, double contrast) {
    if (sizes.is_single()) return InverseLength::from_base(std::numeric_limits<double>::infinity());
    const Steps steps(sizes);
    const std::vector<WeightedRadius> radii = steps.take(kFine);
    std::vector<double> places_m;
    for (const WeightedRadius& drop : radii) places_m.push_back(drop.radius.to(m));
    return faded_rate(radii, places_m, steps.span_m(), contrast) / m;
}

std::vector<WeightedRadius> sample_sizes(const DropSizes& sizes, const SizeSampling& sampling) {
    if (!(sampling.error >= 1e-6 && sampling.error <= 0.1))
        throw InputError(fmt::format(
            "error {:.6g} of an average over drop sizes; expected 1e-6 to 0.1", sampling.error));
    if (sizes.is_single()) return {{sizes.smallest(), 1.0}};

    /// Of ⟨r²⟩ and ⟨r³⟩, above the 2e-7 that smallest() and largest() leave outside. The drops
    /// below the first radius come on top, 1e-7 for an exponential.
    constexpr double kMomentError = 5e-7;
    const Steps steps(sizes);
    std::vector<double> places_m;
    const std::vector<WeightedRadius> fine = steps.take(kFine, &places_m);
    const double faded = faded_rate(fine, places_m, steps.span_m(), 0.5 * sampling.error);
    const double wanted = std::ceil(steps.span_m() * (sampling.fastest.to(1.0 / m) + faded));
    if (!(wanted <= double(kMostRadii)))
        throw InputError(fmt::format("{:.3g} radii are needed for drops of {}, expected at most {}",
                                     wanted, sizes.describe(), kMostRadii),
                         "fringes so far from the bow are washed out: ask for fewer");
    auto count = std::size_t(std::max(wanted, 4.0));
    std::vector<WeightedRadius> radii = steps.take(count);
    while (moment_error(radii, sizes) > kMomentError && count < kMostRadii) {
        count += 1 + count / 16;
        radii = steps.take(count);
    }
    sum_to_one(radii);
    merge_below(sampling.least, radii);
    return radii;
}

}  // namespace dewbow
