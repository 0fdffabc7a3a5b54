// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/ggx_energy.h"

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/render/microfacet.h"
#include "dewbow/render/surface/visible_normals.h"

namespace dewbow {
namespace {

constexpr std::size_t kRows = 24, kColumns = 32;
/// Square root of alpha.
constexpr TableAxis kRowAxis{0.01, 1.0, kRows};
constexpr TableAxis kColumnAxis{0.0, 1.0, kColumns};

double fifth_power(double x) { return (x * x) * (x * x) * x; }

/// What is lost; and how far the grazing part is above that of a mirror, which takes most of its
/// variation away.
struct Entry {
    double lost = 0.0, grazing_above = 0.0;
};

double grazing_of_mirror(double cosine, double lost) {
    return fifth_power(1.0 - cosine) * (1.0 - lost);
}

Entry integrate(double cosine, double alpha, const VisibleNormals& normals) {
    double lost = 0.0, grazing = 0.0;
    const Vec3 wo{std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine};
    normals.for_each(wo, alpha, [&](Vec3 m, double weight) {
        const double cos_m = dot(wo, m);
        const Vec3 wi = m * (2.0 * cos_m) - wo;
        const double seen = wi.z > 0.0 ? ggx_g1(wi, alpha) : 0.0;
        lost += weight * (1.0 - seen);
        grazing += weight * seen * fifth_power(std::max(0.0, 1.0 - cos_m));
    });
    return {lost, grazing - grazing_of_mirror(cosine, lost)};
}

/// Row: alpha; column: cosine.
using Table = std::array<std::array<Entry, kColumns>, kRows>;

Table make_table() {
    Table table;
    const VisibleNormals normals(64, 16);
    for (std::size_t row = 0; row < kRows; ++row) {
        const double alpha = kRowAxis.at(row) * kRowAxis.at(row);
        const LogAxis cosines(alpha);
        for (std::size_t column = 0; column < kColumns; ++column)
            table[row][column] = integrate(
                std::max(kLeastCosine, cosines.value(kColumnAxis.at(column))), alpha, normals);
    }
    return table;
}

const Table& table() {
    static const Table table = make_table();
    return table;
}

/// By log alpha from 1e-4 on, fine enough to be the average of what lies between the rows of the
/// table. What is lost is divided by alpha², which takes most of its variation away.
constexpr TableAxis kAverageAxis{-9.210340371976182, 0.0, 128};
using Averages = std::array<GgxAlbedo, kAverageAxis.count>;

Averages make_averages() {
    Averages averages;
    for (std::size_t i = 0; i < averages.size(); ++i) {
        const double alpha = std::exp(kAverageAxis.at(i));
        averages[i] = GgxAlbedos(alpha).average();
        averages[i].lost /= alpha * alpha;
    }
    return averages;
}

}  // namespace

GgxAlbedos::GgxAlbedos(double alpha)
    : alpha_(alpha), cosines_(alpha), row_(kRowAxis.place(std::sqrt(alpha))) {}

GgxAlbedo GgxAlbedos::at(double cosine) const {
    const TablePlace column = kColumnAxis.place(cosines_.x(cosine));
    const Entry* const a = &table()[row_.index][column.index];
    const Entry* const b = &table()[row_.index + 1][column.index];
    const double lost =
        row_.between(column.between(a[0].lost, a[1].lost), column.between(b[0].lost, b[1].lost));
    const double above = row_.between(column.between(a[0].grazing_above, a[1].grazing_above),
                                      column.between(b[0].grazing_above, b[1].grazing_above));
    return {lost, above + grazing_of_mirror(cosine, lost)};
}

GgxAlbedo GgxAlbedos::average() const {
    GgxAlbedo sum;
    integrate_over_cosines(kColumns - 1, alpha_, [&](double mu, double weight) {
        const GgxAlbedo albedo = at(mu);
        sum.lost += weight * albedo.lost;
        sum.grazing += weight * albedo.grazing;
    });
    return sum;
}

GgxEnergy::GgxEnergy(double alpha) : albedos_(alpha) {
    static const Averages averages = make_averages();
    const TablePlace place = kAverageAxis.place(std::log(alpha));
    const GgxAlbedo &a = averages[place.index], &b = averages[place.index + 1];
    average_ = {place.between(a.lost, b.lost) * alpha * alpha, place.between(a.grazing, b.grazing)};
}

double GgxEnergy::compensation(double lost_o, double lost_i, double cos_i) const {
    return lost_o * lost_i * cos_i / (std::numbers::pi * average_.lost);
}

}  // namespace dewbow
