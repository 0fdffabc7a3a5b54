// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dewbow/rainbow/debye_series.h"
#include "dewbow/rainbow/drop_ray.h"
#include "dewbow/rainbow/models.h"
#include "dewbow/rainbow/self_test/comparison.h"

namespace dewbow::self_test {
namespace {

PartialWaves sum_of_orders(const DebyeSeries& series, int last) {
    PartialWaves sum = series.beyond(last);
    for (int p = 0; p <= last; ++p) {
        const PartialWaves order = series.order(p);
        for (std::size_t i = 0; i < sum.a.size(); ++i) {
            sum.a[i] += order.a[i];
            sum.b[i] += order.b[i];
        }
    }
    return sum;
}

/// Root mean square of the difference of |S_1|² on the main bow, from 2 Airy units outside it
/// to 1.9 inside, over the bow's peak.
double error_on_main_bow(const DescartesRay& bow, double x) {
    constexpr int kAngles = 400;
    const double unit_angle = std::cbrt(bow.airy_constant / (x * x));
    std::vector<Angle> theta;
    for (int i = 0; i <= kAngles; ++i) {
        const double u = bow.bright_side > 0 ? -2.0 + 3.9 * i / kAngles : 1.9 - 3.9 * i / kAngles;
        theta.push_back(bow.scattering_angle + bow.bright_side * u * unit_angle * unit::rad);
    }
    ModelOptions options;
    options.orders = {bow.p};
    const auto intensities = [&](std::string_view model) {
        const Drop drop{x};
        std::vector<Intensities> result(theta.size());
        make_scattering_model(model, options)
            ->intensities({kWater, 0.0}, {&drop, 1}, theta, result);
        return result;
    };
    const std::vector<Intensities> debye = intensities("debye"), airy = intensities("uniform_airy");
    double squares = 0.0, peak = 0.0;
    for (std::size_t i = 0; i < theta.size(); ++i) {
        squares += std::pow(airy[i].perpendicular - debye[i].perpendicular, 2.0);
        peak = std::max(peak, debye[i].perpendicular);
    }
    return std::sqrt(squares / double(theta.size())) / peak;
}

}  // namespace

void check_debye(Rows& rows) {
    Comparison report(rows, "Debye's orders against Mie's series");
    constexpr double kAllowed = 1e-9;
    for (const double x : {100.0, 1000.0}) {
        const PartialWaves mie = mie_waves({kWater, 0.0}, x);
        const DebyeSeries series({kWater}, x);
        const auto compare = [&](const std::string& name, const PartialWaves& waves) {
            report.worst_of([&](Comparison& all) {
                for (int degrees = 0; degrees <= 180; ++degrees) {
                    const Amplitudes s = amplitudes_at(waves, degrees * unit::deg);
                    const Amplitudes expected = amplitudes_at(mie, degrees * unit::deg);
                    const std::string at = fmt::format(" at {}° (worst of 362)", degrees);
                    all.compare(name + "S1" + at, s.perpendicular, expected.perpendicular,
                                kAllowed);
                    all.compare(name + "S2" + at, s.parallel, expected.parallel, kAllowed);
                }
            });
        };
        compare(fmt::format("x = {}, all by the closed form: ", x), series.all());
        compare(fmt::format("x = {}, p = 0…7 and the rest: ", x),
                sum_of_orders(series, kHighestOrder));
    }
}

void check_uniform_airy(Rows& rows) {
    Comparison report(rows, "Uniform Airy against Debye on the main bow, perpendicular, m = 1.333");
    // Measured 4e-4, 1e-5, 8e-3 and 2e-4: asymptotics in x, worse for bows of rays near grazing.
    const struct {
        int p;
        double x, allowed;
    } cases[] = {{2, 1000.0, 1e-3}, {2, 5712.0, 1e-4}, {3, 1000.0, 2e-2}, {3, 5712.0, 1e-3}};
    for (const auto& c : cases) {
        report.bound(fmt::format("p = {}, x = {}: rms error over the peak", c.p, c.x),
                     error_on_main_bow(descartes_ray({kWater}, c.p), c.x), c.allowed);
    }
}

void check_descartes_rays(Rows& rows) {
    Comparison report(rows, "Closed forms of the ray of least deflection, m = 1.333");
    constexpr double kAllowed = 1e-12;
    const double n2 = kWater * kWater;
    const double expected_angle[] = {
        2.0 * std::acos(std::pow((4.0 - n2) / 3.0, 1.5) / n2),
        2.0 * std::numbers::pi -
            2.0 * std::acos(-(n2 * n2 + 18.0 * n2 - 27.0) / (8.0 * kWater * n2))};
    const double expected_light[] = {64.0 / 729.0, 9.0 / 256.0};  // for every index
    for (const int p : {2, 3}) {
        const DescartesRay bow = descartes_ray({kWater}, p);
        const double amplitude = ray_amplitudes(bow.ray, {kWater}, p).perpendicular;
        report.compare(fmt::format("p = {}: scattering angle in degrees", p),
                       bow.scattering_angle.to(unit::deg),
                       expected_angle[p - 2] * 180.0 / std::numbers::pi, kAllowed);
        report.compare(fmt::format("p = {}: light left, perpendicular", p), amplitude * amplitude,
                       expected_light[p - 2], kAllowed);
    }
}

}  // namespace dewbow::self_test
