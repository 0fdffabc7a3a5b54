// SPDX-License-Identifier: Apache-2.0
#include "dewbow/scene/photometric_web.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/math/interpolation.h"

namespace dewbow {
namespace {

constexpr double kDegrees_per_radian = 180.0 / std::numbers::pi;

[[noreturn]] void fail(const std::string& what) { throw InputError("a photometric web's " + what); }

void check_angles(const char* which, const std::vector<double>& angles_deg, double high) {
    for (std::size_t i = 0; i < angles_deg.size(); ++i) {
        if (!(angles_deg[i] >= 0.0 && angles_deg[i] <= high)) {
            fail(fmt::format("{} angle {} is {}; it must lie between 0 and {} deg", which, i,
                             angles_deg[i], high));
        }
        if (i > 0 && !(angles_deg[i] > angles_deg[i - 1])) {
            fail(fmt::format("{} angle {} is {} after {}; they must ascend", which, i,
                             angles_deg[i], angles_deg[i - 1]));
        }
    }
}

void check_circle(const PhotometricTable& table) {
    const auto& phi = table.horizontal_deg;
    if (phi.empty() || phi.front() != 0.0 || (phi.size() > 1 && phi.back() != 360.0)) {
        fail("horizontal angles must be 0 alone, or go from 0 to 360 deg");
    }
    const auto columns = std::ptrdiff_t(table.vertical_deg.size());
    const auto& values = table.intensity_cd;
    if (!std::equal(values.begin(), values.begin() + columns, values.end() - columns)) {
        fail("intensities at 0 and at 360 deg must be the same");
    }
}

void check(const PhotometricTable& table) {
    if (table.vertical_deg.size() < 2) fail("table needs at least two vertical angles");
    check_angles("vertical", table.vertical_deg, 180.0);
    check_angles("horizontal", table.horizontal_deg, 360.0);
    const std::size_t expected = table.vertical_deg.size() * table.horizontal_deg.size();
    if (table.intensity_cd.size() != expected) {
        fail(fmt::format("table has {} intensities; its angles make {}", table.intensity_cd.size(),
                         expected));
    }
    for (double value : table.intensity_cd) {
        if (!(value >= 0.0 && std::isfinite(value))) {
            fail(fmt::format("intensity is {}; it must be finite and not negative", value));
        }
    }
    check_circle(table);
}

/// ∫ I sin θ dθ for I linear from `first` to `last` between two angles. With m their middle and h
/// half their difference it is (first + last) sin m sin h + (last − first) cos m (sin h / h − cos
/// h).
double polar_integral(double begin_rad, double end_rad, double first, double last) {
    const double m = 0.5 * (begin_rad + end_rad), h = 0.5 * (end_rad - begin_rad);
    return (first + last) * std::sin(m) * std::sin(h) +
           (last - first) * std::cos(m) * (std::sin(h) / h - std::cos(h));
}

/// ∫ I(θ) sin θ dθ of one row of the table.
double row_integral(const PhotometricTable& table, std::size_t row) {
    const std::size_t columns = table.vertical_deg.size();
    const double* values = &table.intensity_cd[row * columns];
    double sum = 0.0;
    for (std::size_t v = 0; v + 1 < columns; ++v) {
        sum += polar_integral(table.vertical_deg[v] / kDegrees_per_radian,
                              table.vertical_deg[v + 1] / kDegrees_per_radian, values[v],
                              values[v + 1]);
    }
    return sum;
}

/// A bilinear table is linear in φ, and so are its rows' integrals: the trapezoid is exact.
double flux_of(const PhotometricTable& table) {
    const auto& phi_deg = table.horizontal_deg;
    if (phi_deg.size() == 1) return 2.0 * std::numbers::pi * row_integral(table, 0);
    double flux = 0.0;
    for (std::size_t h = 0; h + 1 < phi_deg.size(); ++h) {
        const double width_rad = (phi_deg[h + 1] - phi_deg[h]) / kDegrees_per_radian;
        flux += 0.5 * width_rad * (row_integral(table, h) + row_integral(table, h + 1));
    }
    return flux;
}

/// Share of the way from abscissae[i] to abscissae[i + 1].
double share_of(const std::vector<double>& abscissae, std::size_t i, double x) {
    return (x - abscissae[i]) / (abscissae[i + 1] - abscissae[i]);
}

/// φ in [0, 360] deg.
double turned_into_circle(double phi_rad) {
    const double phi_deg = std::fmod(phi_rad * kDegrees_per_radian, 360.0);
    return phi_deg < 0.0 ? phi_deg + 360.0 : phi_deg;
}

}  // namespace

PhotometricWeb::PhotometricWeb(PhotometricTable table) : table_(std::move(table)) {
    check(table_);
    max_intensity_cd_ = *std::max_element(table_.intensity_cd.begin(), table_.intensity_cd.end());
    flux_lm_ = flux_of(table_);
    if (!(flux_lm_ > 0.0)) fail("intensities are all zero");
    if (!std::isfinite(flux_lm_)) fail("intensities are too large");
}

double PhotometricWeb::row_intensity(std::size_t row, std::size_t column, double share) const {
    const double* values = &table_.intensity_cd[row * table_.vertical_deg.size() + column];
    return std::lerp(values[0], values[1], share);
}

double PhotometricWeb::intensity_cd(double theta_rad, double phi_rad) const {
    const auto& thetas = table_.vertical_deg;
    const auto& phis = table_.horizontal_deg;
    const double theta_deg = theta_rad * kDegrees_per_radian;
    if (!(theta_deg >= thetas.front() && theta_deg <= thetas.back())) return 0.0;
    const std::size_t column = interval_of(thetas, theta_deg);
    const double share = share_of(thetas, column, theta_deg);
    if (phis.size() == 1) return row_intensity(0, column, share);
    const double phi_deg = turned_into_circle(phi_rad);
    const std::size_t row = interval_of(phis, phi_deg);
    return std::lerp(row_intensity(row, column, share), row_intensity(row + 1, column, share),
                     share_of(phis, row, phi_deg));
}

double PhotometricWeb::intensity_cd(Dir<Object> direction) const {
    const Vec3 d = direction.v;
    // From the tangent: acos loses half the digits near nadir and zenith.
    return intensity_cd(std::atan2(std::hypot(d.x, d.z), -d.y), std::atan2(-d.z, d.x));
}

double PhotometricWeb::mean_intensity_cd() const { return flux_lm_ / (4.0 * std::numbers::pi); }

}  // namespace dewbow
