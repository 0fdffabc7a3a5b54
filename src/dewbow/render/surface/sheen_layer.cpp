// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/surface/sheen_layer.h"

#include <array>
#include <cmath>
#include <numbers>

#include "dewbow/math/quadrature.h"
#include "dewbow/render/surface/table_axis.h"

namespace dewbow {
namespace {

constexpr double kPi = std::numbers::pi;

/// L(x) = a / (1 + b x^c) + d x + e at r = 0 and r = 1.      [Estevez & Kulla 2017, table 1]
struct Fit {
    double a, b, c, d, e;
};
constexpr Fit kFitOf0{25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
constexpr Fit kFitOf1{21.5473, 3.82987, 0.19823, -1.97760, -4.32054};

double fitted(double x, double r) {
    const double w = (1.0 - r) * (1.0 - r);
    const auto between = [w](double of_0, double of_1) { return of_1 + (of_0 - of_1) * w; };
    const double a = between(kFitOf0.a, kFitOf1.a), b = between(kFitOf0.b, kFitOf1.b);
    const double c = between(kFitOf0.c, kFitOf1.c), d = between(kFitOf0.d, kFitOf1.d);
    return a / (1.0 + b * std::pow(x, c)) + d * x + between(kFitOf0.e, kFitOf1.e);
}

double lambda(double cosine, double r) {
    return std::exp(cosine < 0.5 ? fitted(cosine, r)
                                 : 2.0 * fitted(0.5, r) - fitted(1.0 - cosine, r));
}

double distribution(double cos_m, double r) {
    const double sine2 = std::max(0.0, (1.0 - cos_m) * (1.0 + cos_m));
    return (2.0 + 1.0 / r) * std::pow(sine2, 0.5 / r) / (2.0 * kPi);
}

double sheen(Vec3 wo, Vec3 wi, double lambda_o, double r) {
    const double d = distribution(normalised(wo + wi).z, r);
    return d / (4.0 * wo.z * (1.0 + lambda_o + lambda(wi.z, r)));
}

constexpr std::size_t kRows = 24, kColumns = 32;
/// Fourth root of r; square root of cos θ.
constexpr TableAxis kRowAxis{0.2659, 1.0, kRows}, kColumnAxis{0.0, 1.0, kColumns};
using Table = std::array<std::array<double, kColumns>, kRows>;

double integrate_albedo(double cosine, double r) {
    static const QuadratureRule rule = gauss_legendre(24);
    constexpr int kSpokes = 32;
    const Vec3 wo{std::sqrt((1.0 - cosine) * (1.0 + cosine)), 0.0, cosine};
    const double lambda_o = lambda(cosine, r);
    return integrate(rule, 0.0, 1.0, [&](double x) {
        // Fine where either direction grazes: μ = x².
        const double mu = x * x, sine = std::sqrt(1.0 - mu * mu);
        double sum = 0.0;
        for (int j = 0; j < kSpokes; ++j) {
            const double phi = kPi * (j + 0.5) / kSpokes;
            sum += sheen(wo, {sine * std::cos(phi), sine * std::sin(phi), mu}, lambda_o, r);
        }
        return sum / kSpokes * 2.0 * kPi * 2.0 * x;
    });
}

const Table& table() {
    static const Table table = [] {
        Table result;
        for (std::size_t row = 0; row < kRows; ++row)
            for (std::size_t column = 0; column < kColumns; ++column) {
                const double x = kColumnAxis.at(column);
                result[row][column] =
                    integrate_albedo(std::max(1e-6, x * x), std::pow(kRowAxis.at(row), 4.0));
            }
        return result;
    }();
    return table;
}

}  // namespace

SheenLayer::SheenLayer(Vec3 wo, double roughness)
    : wo_(wo),
      r_(std::max(kLeastSheenR, roughness * roughness)),
      lambda_o_(lambda(wo.z, r_)),
      albedo_o_(albedo(wo.z)) {}

double SheenLayer::eval(Vec3 wi, double albedo_i) const {
    return sheen(wo_, wi, lambda_o_, r_) / std::max({1.0, albedo_o_, albedo_i});
}

double SheenLayer::albedo(double cosine) const {
    const TablePlace row = kRowAxis.place(std::sqrt(std::sqrt(r_)));
    const TablePlace column = kColumnAxis.place(std::sqrt(cosine));
    const auto &a = table()[row.index], &b = table()[row.index + 1];
    return row.between(column.between(a[column.index], a[column.index + 1]),
                       column.between(b[column.index], b[column.index + 1]));
}

}  // namespace dewbow
