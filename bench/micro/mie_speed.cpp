// SPDX-License-Identifier: Apache-2.0

// How fast the model `mie` is: one sphere's S1 and S2 at 1801 angles, and one of many spheres',
// beside Wiscombe's algorithm, all on one thread in one run; and `debye` beside `mie`.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/rainbow/mie/angular_kernel.h"
#include "dewbow/rainbow/mie/riccati_bessel.h"
#include "dewbow/rainbow/models.h"
#include "micro/cpu_time.h"
#include "micro/fma_peak.h"
#include "micro/wiscombe_mie.h"

namespace dewbow::bench {
namespace {

constexpr int kSteps = 1800, kRepeats = 15;
constexpr double kIndex = 1.333;
/// Spheres of many, evenly from 0.9 to 1.1 of the size.
constexpr int kSpheres = 48;
/// What is asked for: the share of Wiscombe's time on the same angles.
constexpr double kTargetAlone = 0.5, kTargetTogether = 0.3;

std::vector<Angle> angles() {
    std::vector<Angle> theta;
    for (int i = 0; i <= kSteps; ++i) theta.push_back(180.0 * i / kSteps * unit::deg);
    return theta;
}

/// Exactly symmetric around 0.
std::vector<double> cosines() {
    std::vector<double> mu(kSteps + 1);
    for (std::size_t i = 0; i < kSteps / 2; ++i) {
        mu[i] = std::cos(double(i) * std::numbers::pi / kSteps);
        mu[kSteps - i] = -mu[i];
    }
    return mu;
}

double wiscombe_seconds(double x, bool symmetric) {
    const std::vector<double> mu = cosines();
    std::vector<std::complex<double>> S1(mu.size()), S2(mu.size());
    return least_cpu_seconds(kRepeats, [&] { wiscombe_mie(x, kIndex, mu, symmetric, S1, S2); });
}

double seconds_alone(const AmplitudeModel& mie, double x) {
    const std::vector<Angle> theta = angles();
    std::vector<Amplitudes> S(theta.size());
    return least_cpu_seconds(kRepeats, [&] { mie.amplitudes({kIndex, 0.0}, {x}, theta, S); });
}

/// Of one sphere.
double seconds_together(const ScatteringModel& mie, double x) {
    const std::vector<Angle> theta = angles();
    std::vector<Drop> drops;
    for (int i = 0; i < kSpheres; ++i) drops.push_back({x * (0.9 + 0.2 * i / (kSpheres - 1))});
    std::vector<Intensities> I(drops.size() * theta.size());
    return least_cpu_seconds(kRepeats / 3,
                             [&] {
                                 mie.intensities({kIndex, 0.0}, drops, theta, I);
                             }) /
           kSpheres;
}

std::string_view variant_in_use() {
    for (const SumBlockVariant& variant : sum_block_variants())
        if (variant.is_supported()) return variant.name;
    return "";
}

void run() {
    const std::string_view variant = variant_in_use();
    const double peak = multiply_adds_per_second(variant);
    fmt::print("{}, peak {:.1f} G multiply-adds a second\n", variant, 1e-9 * peak);
    fmt::print(
        "CPU ms a sphere, S1 and S2 at {} angles, index {}; share of Wiscombe's time on "
        "symmetric angles (targets {}, {}) and of the peak\n\n",
        kSteps + 1, kIndex, kTargetAlone, kTargetTogether);
    fmt::print("{:>6} {:>9} {:>10} {:>8} {:>6} {:>6} {:>9} {:>6} {:>6}\n", "x", "Wiscombe",
               "symmetric", "alone", "share", "peak", "together", "share", "peak");
    const auto model = make_scattering_model("mie");
    const auto& mie = dynamic_cast<const AmplitudeModel&>(*model);
    for (double x : {100.0, 1000.0, 5000.0, 10000.0}) {
        const double any = wiscombe_seconds(x, false), symmetric = wiscombe_seconds(x, true);
        const double alone = seconds_alone(mie, x), together = seconds_together(mie, x);
        const double adds = 4.0 * term_count(x) * (kSteps + 1);
        fmt::print(
            "{:>6} {:>9.3f} {:>10.3f} {:>8.4f} {:>6.3f} {:>6.2f} {:>9.4f} {:>6.3f} {:>6.2f}\n", x,
            1e3 * any, 1e3 * symmetric, 1e3 * alone, alone / symmetric, adds / alone / peak,
            1e3 * together, together / symmetric, adds / together / peak);
    }
}

/// One order of light costs the same sums as all of it, and more Bessel functions.
void run_debye() {
    constexpr double kHalfMillimetre = 5712.0;  // radius 0.5 mm at 550 nm
    ModelOptions options;
    options.orders = {2};
    const auto debye = make_scattering_model("debye", options), mie = make_scattering_model("mie");
    const double one_order =
        seconds_alone(dynamic_cast<const AmplitudeModel&>(*debye), kHalfMillimetre);
    const double all = seconds_alone(dynamic_cast<const AmplitudeModel&>(*mie), kHalfMillimetre);
    fmt::print("\nmodel debye, one order, x = {}: {:.4f} ms, {:.2f} times mie's {:.4f} ms\n",
               kHalfMillimetre, 1e3 * one_order, one_order / all, 1e3 * all);
}

}  // namespace
}  // namespace dewbow::bench

int main() {
    dewbow::bench::run();
    dewbow::bench::run_debye();
}
