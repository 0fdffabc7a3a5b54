// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/drop_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "dewbow/base/error.h"
#include "dewbow/rainbow/angle_grid.h"
#include "dewbow/rainbow/automatic_error.h"
#include "dewbow/rainbow/mixed_table.h"
#include "dewbow/rainbow/table_cache.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {
namespace {

using namespace unit;

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kCount = VisibleGrid::kCount;
/// Of angles within the forward cut, where discs make a slope of what is flat.
constexpr Angle kStepWithinCut = 0.05 * deg;
/// Of the air, that drops may fill: their light is added as if each stood alone.
constexpr double kMostWater = 0.01;
constexpr std::array<const char*, 4> kWholeModels = {"auto", "mie", "debye", "descartes"};

/// Drops of one size as they are in nature.
std::vector<DropSizesPtr> natural(const std::vector<DropSizesPtr>& showers) {
    std::vector<DropSizesPtr> all;
    for (const DropSizesPtr& sizes : showers)
        all.push_back(sizes->is_single() ? normal_drop_sizes(sizes->largest(), kLeastWidth)
                                         : sizes);
    return all;
}

/// Angles of the table, from the cut to 180°.
std::vector<Angle> angles_beyond_cut(const DropOptics& optics,
                                     std::span<const DropSizesPtr> showers) {
    const Wavelength shortest = VisibleGrid::kFirst_nm * nm;
    const Wavelength longest =
        (VisibleGrid::kFirst_nm + VisibleGrid::kStep_nm * double(kCount - 1)) * nm;
    std::vector<Angle> all;
    for (const DropSizesPtr& sizes : showers) {
        AngleGrid grid{optics.index(longest), optics.index(shortest)};
        grid.x = optics.size_parameter(effective_radius(*sizes), shortest);
        const Length deviation = relative_width(*sizes) * mean_radius(*sizes);
        grid.fringes = optics.size_parameter(deviation, shortest) < kWashedOutDeviation;
        grid.from = kForwardCut;
        all = merged_angles(all, adaptive_angles(grid));
    }
    return all;
}

struct MadeTable {
    ScatteringTable table;
    std::string identity, note;
};
MadeTable table_of(const DropCloudRequest& request, const std::filesystem::path& cache) {
    TableRequest wanted;
    wanted.model = request.model;
    wanted.orders = request.orders;
    wanted.tolerance = request.tolerance;
    wanted.optics = request.optics;
    wanted.wavelengths = VisibleGrid::wavelengths();
    const std::vector<DropSizesPtr> showers = natural(request.showers);
    wanted.angles = angles_beyond_cut(request.optics, showers);
    wanted.disc = {Angle{}, 0.0};
    MadeTable made;
    std::vector<ScatteringTable> tables;
    for (const DropSizesPtr& sizes : showers) {
        wanted.sizes = sizes;
        CachedTable one = cached_scattering_table(wanted, cache);
        tables.push_back(std::move(one.table));
        made.identity += cache_key(wanted) + " ";
        if (!one.note.empty()) made.note = one.note;
    }
    made.table = tables.size() == 1 ? std::move(tables.front()) : mixed_evenly(tables);
    return made;
}

/// The table's P with what is below the cut put before it, [angle][wavelength].
struct WholePhase {
    std::vector<Angle> angles;
    std::vector<Intensities> values;
};
WholePhase from_zero(const ScatteringTable& table) {
    WholePhase whole;
    for (Angle angle{}; angle < kForwardCut - 0.5 * kStepWithinCut; angle += kStepWithinCut) {
        whole.angles.push_back(angle);
        whole.values.insert(whole.values.end(), table.phase.begin(),
                            table.phase.begin() + std::ptrdiff_t(kCount));
    }
    whole.angles.insert(whole.angles.end(), table.angles.begin(), table.angles.end());
    whole.values.insert(whole.values.end(), table.phase.begin(), table.phase.end());
    return whole;
}

/// ∫ over one cell of a function that is linear in θ, sin θ dθ, as weights of its two ends.
struct CellWeights {
    double low, high;
};
CellWeights cell_weights(double from, double to) {
    // ∫ sin = cos a − cos b, and ∫ (θ − a)/(b − a) sin θ dθ = (sin b − sin a)/(b − a) − cos b.
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    const double all = 2.0 * std::sin(middle) * std::sin(half);
    const double high = std::cos(middle) * std::sin(half) / half - std::cos(to);
    return {all - high, high};
}

/// ½ ∫ P sin θ dθ at each wavelength: share of all scattered light that is scattered as P says.
VisibleValues scattered_shares(const AngleIndex& angles, std::span<const Intensities> phase) {
    VisibleValues shares{};
    for (std::size_t i = 0; i < angles.cells(); ++i) {
        const CellWeights weights = cell_weights(angles.radians(i), angles.radians(i + 1));
        for (std::size_t j = 0; j < kCount; ++j)
            shares[j] += 0.5 * (weights.low * phase[i * kCount + j].unpolarised() +
                                weights.high * phase[(i + 1) * kCount + j].unpolarised());
    }
    return shares;
}

/// Light scattered into each cell of angles, of white light, as a share of all.
std::vector<double> white_shares(const AngleIndex& angles, std::span<const Intensities> per_sr) {
    std::array<double, kCount> colour{};
    double sum = 0.0;
    for (std::size_t j = 0; j < kCount; ++j) {
        const auto xyz = cie_xyz_bar(VisibleGrid::kFirst_nm + VisibleGrid::kStep_nm * double(j));
        colour[j] = xyz[0] + xyz[1] + xyz[2];
        sum += colour[j];
    }
    std::vector<double> white;
    for (std::size_t i = 0; i < per_sr.size(); i += kCount) {
        double mean = 0.0;
        for (std::size_t j = 0; j < kCount; ++j)
            mean += colour[j] / sum * per_sr[i + j].unpolarised();
        white.push_back(mean);
    }
    std::vector<double> shares;
    for (std::size_t i = 0; i < angles.cells(); ++i) {
        const CellWeights weights = cell_weights(angles.radians(i), angles.radians(i + 1));
        shares.push_back(2.0 * kPi * (weights.low * white[i] + weights.high * white[i + 1]));
    }
    return shares;
}

class PointPhase : public PhaseFunction {
public:
    explicit PointPhase(PhaseLookup lookup) : lookup_(std::move(lookup)) {}
    void eval_lanes(double cosine, std::span<const double> lambda_nm,
                    std::span<double> out) const override {
        lookup_.eval_lanes(cosine, lambda_nm, out);
    }

private:
    PhaseLookup lookup_;
};

void check(const DropCloudRequest& request) {
    if (request.showers.empty()) throw InputError("no drop sizes");
    if (std::find(kWholeModels.begin(), kWholeModels.end(), request.model) == kWholeModels.end())
        throw InputError(
            fmt::format("model \"{}\" has light near its bows only, and rain scatters it to all "
                        "sides",
                        request.model),
            "auto, mie, debye and descartes know all angles");
    for (const DropSizesPtr& sizes : request.showers) {
        const Length radius = effective_radius(*sizes);
        if (radius <= kLargestRaindrop) continue;
        throw InputError(
            fmt::format("drops have an effective radius of {:.4g} mm; those beyond {:.4g} mm break "
                        "up as they fall",
                        radius.to(mm), kLargestRaindrop.to(mm)));
    }
}

/// @param section  geometric cross section of the drops in a cubic metre, m⁻¹.
void check_water(double section, std::span<const DropSizesPtr> showers) {
    const double share = section * water_per_cross_section(showers);
    if (share <= kMostWater) return;
    throw InputError(fmt::format("drops would fill {:.3g} % of the air; expected at most {:.0f} %",
                                 100.0 * share, 100.0 * kMostWater),
                     "in the heaviest rain they fill 0.001 %, in fog 0.0001 %");
}

}  // namespace

std::size_t DropCloud::disc_of(const SunDisc& disc) const {
    for (std::size_t i = 0; i < discs_.size(); ++i)
        if (discs_[i].radius == disc.radius && discs_[i].limb_darkening == disc.limb_darkening)
            return i;
    throw InputError(
        fmt::format("rain was not prepared for a sun of radius {:.6g}°", disc.radius.to(deg)));
}

void DropCloud::extinction_lanes(std::span<const double> lambda_nm, std::span<double> out) const {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = interpolated(extinction_, lambda_nm[k]);
}

void DropCloud::albedo_lanes(std::span<const double> lambda_nm, std::span<double> out) const {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = interpolated(albedo_, lambda_nm[k]);
}

double DropCloud::sample_cosine(double u) const {
    const double at = std::clamp(u, 0.0, 1.0) * below_.back();
    const auto above = std::upper_bound(below_.begin() + 1, below_.end() - 1, at);
    const auto cell = static_cast<std::size_t>(above - below_.begin()) - 1;
    const double share =
        std::clamp((at - below_[cell]) / (below_[cell + 1] - below_[cell]), 0., 1.);
    return angles_->cosine(cell) + share * (angles_->cosine(cell + 1) - angles_->cosine(cell));
}

double DropCloud::cosine_pdf(double cosine) const { return density_[angles_->find(cosine).cell]; }

/// Makes the parts of a cloud, one after the other.
class DropCloudMaker {
public:
    DropCloudMaker(const DropCloudRequest& request, const std::filesystem::path& cache)
        : request_(request), made_(table_of(request, cache)), whole_(from_zero(made_.table)) {
        cloud_.angles_ = std::make_shared<const AngleIndex>(whole_.angles);
        shares_ = scattered_shares(*cloud_.angles_, whole_.values);
    }

    DropCloud make() {
        set_amount();
        set_phases();
        set_sampling();
        cloud_.report_ = made_.table.report;
        cloud_.note_ = made_.note;
        return std::move(cloud_);
    }

private:
    /// Extinction over the geometric cross section.
    double efficiency(std::size_t j) const {
        if (!request_.orders.empty()) return 1.0;
        const Efficiencies& q = made_.table.efficiencies[j];
        return q.extinction - q.scattering + shares_[j] * q.scattering;
    }

    void set_amount() {
        VisibleValues efficiencies;
        for (std::size_t j = 0; j < kCount; ++j) {
            efficiencies[j] = efficiency(j);
            const double scattering = shares_[j] * made_.table.efficiencies[j].scattering;
            cloud_.albedo_[j] = std::min(scattering / efficiencies[j], 1.0);
        }
        const double section =
            cross_section_per_volume(request_.amount, request_.showers,
                                     interpolated(efficiencies, kExtinctionWavelength.to(nm)));
        check_water(section, request_.showers);
        for (std::size_t j = 0; j < kCount; ++j) cloud_.extinction_[j] = section * efficiencies[j];
        cloud_.drops_per_m3_ = section * number_per_cross_section(request_.showers);
        cloud_.rain_rate_mm_per_h_ = section * rain_rate_per_cross_section(request_.showers);
        cloud_.identity_ = fmt::format("{}{}", made_.identity, section);
    }

    void set_phases() {
        for (std::size_t i = 0; i < whole_.values.size(); ++i) {
            const double per_sr = 1.0 / (4.0 * kPi * shares_[i % kCount]);
            whole_.values[i].perpendicular *= per_sr;
            whole_.values[i].parallel *= per_sr;
        }
        add_phase({Angle{}, 0.0}, whole_.values);
        cloud_.point_ = std::make_shared<PointPhase>(cloud_.phases_.front());
        std::vector<Intensities> smooth(whole_.values.size());
        for (const SunDisc& disc : request_.discs) {
            if (disc.radius == Angle{}) continue;
            SunSmoother(whole_.angles, disc).apply(whole_.values, smooth);
            add_phase(disc, smooth);
        }
    }
    void add_phase(const SunDisc& disc, std::span<const Intensities> values) {
        cloud_.discs_.push_back(disc);
        cloud_.phases_.emplace_back(cloud_.angles_, values);
        cloud_.identity_ += fmt::format(" {} {}", disc.radius.to(rad), disc.limb_darkening);
    }

    void set_sampling() {
        const AngleIndex& angles = *cloud_.angles_;
        const std::vector<double> white = white_shares(angles, whole_.values);
        const double sum = std::accumulate(white.begin(), white.end(), 0.0);
        cloud_.below_ = {0.0};
        for (std::size_t i = 0; i < white.size(); ++i) {
            const double share = white[i] / sum;
            cloud_.below_.push_back(cloud_.below_.back() + share);
            const double around = 2.0 * kPi * (angles.cosine(i) - angles.cosine(i + 1));
            cloud_.density_.push_back(share / around);
        }
    }

    const DropCloudRequest& request_;
    const MadeTable made_;
    WholePhase whole_;
    VisibleValues shares_;
    DropCloud cloud_;
};

DropCloudPtr make_drop_cloud(const DropCloudRequest& request, const std::filesystem::path& cache) {
    check(request);
    return std::make_shared<const DropCloud>(DropCloudMaker(request, cache).make());
}

}  // namespace dewbow
