// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/dielectric_energy.h"

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/optics/refraction.h"
#include "dewbow/render/microfacet.h"
#include "dewbow/render/surface/visible_normals.h"

namespace dewbow {
namespace {

/// Logarithm of the index to base 2, the same on both sides of 0.
constexpr TableAxis kIndexAxis{-2.0, 2.0, 25};
/// Square root of alpha.
constexpr TableAxis kRowAxis{0.01, 1.0, 16};
constexpr TableAxis kColumnAxis{0.0, 1.0, 24};
/// Logarithm of alpha.
constexpr TableAxis kAverageAxis{-9.210340371976182, 0.0, 64};

double index_at(std::size_t i) { return std::exp2(kIndexAxis.at(i)); }

double integrate_lost(double cosine, double alpha, double n, const VisibleNormals& normals) {
    const Vec3 wo{std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine};
    double lost = 0.0;
    normals.for_each(wo, alpha, [&](Vec3 m, double weight) {
        const double cos_m = std::min(1.0, dot(wo, m));
        const double r = fresnel_dielectric(cos_m, n).unpolarised();
        const Vec3 reflected = m * (2.0 * cos_m) - wo;
        double seen = reflected.z > 0.0 ? r * ggx_g1(reflected, alpha) : 0.0;
        if (r < 1.0) {
            const double cos_t = std::sqrt(std::max(0.0, cos2_transmitted(cos_m, n)));
            const Vec3 refracted = m * (cos_m / n - cos_t) - wo * (1.0 / n);
            if (refracted.z < 0.0) seen += (1.0 - r) * ggx_g1(refracted, alpha);
        }
        lost += weight * (1.0 - seen);
    });
    return lost;
}

struct Tables {
    std::array<std::array<std::array<double, kColumnAxis.count>, kRowAxis.count>, kIndexAxis.count>
        lost;
    /// By alpha², which takes most of its variation away.
    std::array<std::array<double, kAverageAxis.count>, kIndexAxis.count> average;
    /// What a smooth boundary transmits of even light.
    std::array<double, kIndexAxis.count> transmittance;

    Tables() {
        const VisibleNormals normals(32, 12);
        for (std::size_t i = 0; i < kIndexAxis.count; ++i) {
            make_lost(i, normals);
            transmittance[i] = 0.0;
            integrate_over_cosines(32, 1.0, [&](double mu, double weight) {
                transmittance[i] +=
                    weight * (1.0 - fresnel_dielectric(mu, index_at(i)).unpolarised());
            });
            for (std::size_t a = 0; a < kAverageAxis.count; ++a)
                average[i][a] = average_lost(i, std::exp(kAverageAxis.at(a)));
        }
    }
    void make_lost(std::size_t i, const VisibleNormals& normals) {
        for (std::size_t row = 0; row < kRowAxis.count; ++row) {
            const double alpha = kRowAxis.at(row) * kRowAxis.at(row);
            const LogAxis cosines(alpha);
            for (std::size_t column = 0; column < kColumnAxis.count; ++column) {
                const double cosine = cosines.value(kColumnAxis.at(column));
                lost[i][row][column] =
                    integrate_lost(std::max(kLeastCosine, cosine), alpha, index_at(i), normals);
            }
        }
    }
    double lost_at(std::size_t i, TablePlace row, TablePlace column) const {
        const double *a = &lost[i][row.index][column.index],
                     *b = &lost[i][row.index + 1][column.index];
        return row.between(column.between(a[0], a[1]), column.between(b[0], b[1]));
    }
    double average_lost(std::size_t i, double alpha) const {
        const TablePlace row = kRowAxis.place(std::sqrt(alpha));
        const LogAxis cosines(alpha);
        double sum = 0.0;
        integrate_over_cosines(kColumnAxis.count - 1, alpha, [&](double mu, double weight) {
            sum += weight * lost_at(i, row, kColumnAxis.place(cosines.x(mu)));
        });
        return sum / (alpha * alpha);
    }
};

const Tables& tables() {
    static const Tables tables;
    return tables;
}

}  // namespace

DielectricEnergy::DielectricEnergy(double alpha, double n)
    : cosines_(alpha),
      row_(kRowAxis.place(std::sqrt(alpha))),
      near_(kIndexAxis.place(std::log2(n))),
      far_(kIndexAxis.place(-std::log2(n))) {
    const Tables& t = tables();
    const TablePlace place = kAverageAxis.place(std::log(alpha));
    const auto average = [&](TablePlace index) {
        const auto &a = t.average[index.index], &b = t.average[index.index + 1];
        return alpha * alpha *
               index.between(place.between(a[place.index], a[place.index + 1]),
                             place.between(b[place.index], b[place.index + 1]));
    };
    average_near_ = average(near_), average_far_ = average(far_);
    // By that of the larger index, so that T(n) = n² T(1/n) holds as it stands.
    const TablePlace larger = n >= 1.0 ? near_ : far_;
    const double transmittance =
        larger.between(t.transmittance[larger.index], t.transmittance[larger.index + 1]) *
        std::min(1.0, n * n);
    reflected_share_ = 1.0 - transmittance * std::min(1.0, average_far_ / average_near_);
}

double DielectricEnergy::lost(double cosine, TablePlace index) const {
    const TablePlace column = kColumnAxis.place(cosines_.x(cosine));
    return index.between(tables().lost_at(index.index, row_, column),
                         tables().lost_at(index.index + 1, row_, column));
}

double DielectricEnergy::compensation(double lost_o, double lost_i, double cos_i,
                                      bool reflects) const {
    return lost_o * lost_i * cos_i / (std::numbers::pi * (reflects ? average_near_ : average_far_));
}

}  // namespace dewbow
