// SPDX-License-Identifier: Apache-2.0
#include "dewbow/rainbow/cloud_scattering.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <numbers>

#include "dewbow/base/parallel.h"
#include "dewbow/rainbow/mie/angular_sum.h"
#include "dewbow/rainbow/mie/partial_waves.h"

namespace dewbow {
namespace {

/// Drops that a model is asked about at once: its answers for all of them and all angles stay in
/// the caches of a core, and models that share work between drops find enough of them.
constexpr std::size_t kDropsAtOnce = 16;

/// Sums weighted by cross section, until finish().
class Averager {
public:
    explicit Averager(std::size_t angles) { sums_.intensities.resize(angles); }

    void add(double share, double x, const Efficiencies& q, std::span<const Intensities> S) {
        for (std::size_t a = 0; a < S.size(); ++a) {
            sums_.intensities[a].perpendicular += share * S[a].perpendicular;
            sums_.intensities[a].parallel += share * S[a].parallel;
        }
        const double weight = share * x * x;
        sums_.x_squared += weight;
        sums_.efficiencies.extinction += weight * q.extinction;
        sums_.efficiencies.scattering += weight * q.scattering;
        sums_.efficiencies.asymmetry += weight * q.scattering * q.asymmetry;
    }

    DropSums finish() {
        sums_.efficiencies.asymmetry /= sums_.efficiencies.scattering;
        sums_.efficiencies.extinction /= sums_.x_squared;
        sums_.efficiencies.scattering /= sums_.x_squared;
        return std::move(sums_);
    }

private:
    DropSums sums_;
};

/// Drops as a model sees them, with their shares.
struct SharedDrop {
    Drop drop;
    double share;
};
std::vector<SharedDrop> drops_of(const Cloud& cloud, const std::vector<ShapedDrops>& shaped,
                                 Wavelength lambda, double t) {
    std::vector<SharedDrop> drops;
    for (const ShapedDrops& each : shaped) {
        const WeightedRadius& class_of_drops = cloud.radii[each.radius];
        SharedDrop shared{{cloud.optics.size_parameter(class_of_drops.radius, lambda), {}},
                          class_of_drops.share * each.share};
        for (int p = 0; p <= kHighestOrder; ++p)
            shared.drop.shifts[std::size_t(p)] = each.shift(p, t);
        drops.push_back(shared);
    }
    return drops;
}

DropSums scatter_one(const ScatteringModel& model, ComplexIndex index,
                     std::span<const SharedDrop> drops, std::span<const Angle> angles) {
    Averager average(angles.size());
    std::vector<Intensities> S(std::min(kDropsAtOnce, drops.size()) * angles.size());
    std::vector<Drop> some;
    for (std::size_t first = 0; first < drops.size(); first += kDropsAtOnce) {
        const auto group = drops.subspan(first, std::min(kDropsAtOnce, drops.size() - first));
        some.clear();
        for (const SharedDrop& each : group) some.push_back(each.drop);
        model.intensities(index, some, angles, S);
        for (std::size_t d = 0; d < group.size(); ++d)
            average.add(group[d].share, some[d].size_parameter, model.efficiencies(index, some[d]),
                        std::span(S).subspan(d * angles.size(), angles.size()));
    }
    return average.finish();
}

}  // namespace

double DropOptics::size_parameter(Length radius, Wavelength lambda) const {
    const double radius_nm = radius.to(1e-9 * unit::m);
    return 2.0 * std::numbers::pi * radius_nm * (*around)(lambda).value / lambda.to(unit::nm);
}

void DropSums::add(const DropSums& other) {
    for (std::size_t a = 0; a < intensities.size(); ++a) {
        intensities[a].perpendicular += other.intensities[a].perpendicular;
        intensities[a].parallel += other.intensities[a].parallel;
    }
    const double mine = x_squared, others = other.x_squared;
    const Efficiencies &p = efficiencies, &q = other.efficiencies;
    const double scattering = mine * p.scattering + others * q.scattering;
    efficiencies = {
        (mine * p.extinction + others * q.extinction) / (mine + others),
        scattering / (mine + others),
        (mine * p.scattering * p.asymmetry + others * q.scattering * q.asymmetry) / scattering};
    x_squared = mine + others;
}

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

CloudScattering scatter(const ScatteringModel& model, const Cloud& cloud,
                        std::span<const Wavelength> wavelengths, std::span<const Angle> angles) {
    const RelativeIndex greatest = cloud.optics.index(wavelengths.front()),
                        least = cloud.optics.index(wavelengths.back());
    const std::vector<ShapedDrops> shaped =
        shape_drops(cloud.radii, cloud.falling, least, greatest);
    CloudScattering result;
    result.sums.resize(wavelengths.size());
    parallel_or_throw(wavelengths.size(), [&](std::size_t w) {
        const ComplexIndex index = cloud.optics.complex_index(wavelengths[w]);
        const double range = greatest.value - least.value,
                     t = range != 0.0 ? (index.n - least.value) / range : 0.0;
        result.sums[w] =
            scatter_one(model, index, drops_of(cloud, shaped, wavelengths[w], t), angles);
    });
    result.report = std::string(model.name());
    if (result.report != "mie") result.stated_error = std::numeric_limits<double>::quiet_NaN();
    return result;
}

DropSums scatter_exactly(const Cloud& cloud, Wavelength lambda, std::span<const Angle> angles) {
    const ComplexIndex index = cloud.optics.complex_index(lambda);
    const std::span<const WeightedRadius> radii = cloud.radii;
    Averager average(angles.size());
    std::vector<Amplitudes> S(std::min(kDropsAtOnce, radii.size()) * angles.size());
    std::vector<Intensities> intensities(angles.size());
    std::vector<PartialWaves> waves;
    std::vector<double> sizes;
    for (std::size_t first = 0; first < radii.size(); first += kDropsAtOnce) {
        const auto group = radii.subspan(first, std::min(kDropsAtOnce, radii.size() - first));
        waves.clear(), sizes.clear();
        for (const WeightedRadius& each : group) {
            sizes.push_back(cloud.optics.size_parameter(each.radius, lambda));
            waves.push_back(mie_waves(index, sizes.back()));
        }
        angular_sum(waves, angles, S);
        for (std::size_t d = 0; d < group.size(); ++d) {
            for (std::size_t a = 0; a < angles.size(); ++a) {
                const Amplitudes& at = S[d * angles.size() + a];
                intensities[a] = {std::norm(at.perpendicular), std::norm(at.parallel)};
            }
            average.add(group[d].share, sizes[d], efficiencies_of(waves[d], sizes[d]), intensities);
        }
    }
    return average.finish();
}

}  // namespace dewbow
