// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/sunlight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/base/error.h"
#include "dewbow/math/least_squares.h"
#include "dewbow/spectrum/illuminant.h"
#include "dewbow/spectrum/lanewise.h"

namespace dewbow {

namespace {

/// ASTM E490-00a at a row of its table, to bring the illuminant, a relative spectrum, to scale.
constexpr Wavelength kRow = 550.5 * unit::nm;
constexpr double kIrradianceAtRow = 1.862;  // W m⁻² nm⁻¹

/// Reflectance of the moon's disc at a band: ln A = Σ a_i g^i + d_1 e^{−g/p_1} + d_2 e^{−g/p_2} +
/// d_3 cos((g − p_3) / p_4), g in radians in the first sum and in degrees in the others.
struct Band {
    double nm;
    std::array<double, 4> a;
    std::array<double, 3> d;
};
constexpr std::array kBands = {
    Band{350.0, {-2.67511, -1.78539, 0.50612, -0.25578}, {0.34185, 0.01441, -0.01602}},
    Band{355.1, {-2.71924, -1.74298, 0.44523, -0.23315}, {0.33875, 0.01612, -0.00996}},
    Band{405.0, {-2.35754, -1.72134, 0.40337, -0.21105}, {0.35235, -0.03818, -0.00006}},
    Band{412.3, {-2.34185, -1.74337, 0.42156, -0.21512}, {0.36591, -0.05902, 0.00080}},
    Band{414.4, {-2.43367, -1.72184, 0.43600, -0.22675}, {0.35558, -0.03247, -0.00503}},
    Band{441.6, {-2.31964, -1.72114, 0.37286, -0.19304}, {0.37935, -0.09562, 0.00970}},
    Band{465.8, {-2.35085, -1.66538, 0.41802, -0.22541}, {0.33450, -0.02546, -0.00484}},
    Band{475.0, {-2.28999, -1.63180, 0.36193, -0.20381}, {0.33024, -0.03131, 0.00222}},
    Band{486.9, {-2.23351, -1.68573, 0.37632, -0.19877}, {0.36590, -0.08945, 0.00678}},
    Band{544.0, {-2.13864, -1.60613, 0.27886, -0.16426}, {0.37190, -0.10629, 0.01428}},
    Band{549.1, {-2.10782, -1.66736, 0.41697, -0.22026}, {0.36814, -0.09815, -0.00000}},
    Band{553.8, {-2.12504, -1.65970, 0.38409, -0.20655}, {0.37206, -0.10745, 0.00347}},
    Band{665.1, {-1.88914, -1.58096, 0.30477, -0.17908}, {0.37141, -0.13514, 0.01248}},
    Band{693.1, {-1.89410, -1.58509, 0.28080, -0.16427}, {0.39109, -0.17048, 0.01754}},
    Band{703.6, {-1.92103, -1.60151, 0.36924, -0.20567}, {0.37155, -0.13989, 0.00412}},
    Band{745.3, {-1.86896, -1.57522, 0.33712, -0.19415}, {0.36888, -0.14828, 0.00958}},
    Band{763.7, {-1.85258, -1.47181, 0.14377, -0.11589}, {0.39126, -0.16957, 0.03053}},
    Band{774.8, {-1.80271, -1.59357, 0.36351, -0.20326}, {0.36908, -0.16182, 0.00830}},
    Band{865.3, {-1.74561, -1.58482, 0.35009, -0.19569}, {0.39200, -0.18837, 0.00978}},
    Band{872.6, {-1.76779, -1.60345, 0.37974, -0.20625}, {0.39354, -0.19360, 0.00568}},
};
constexpr std::array<double, 4> kP_deg = {4.06054, 12.8802, -30.5858, 16.7498};
constexpr double kLeastPhase_deg = 1.55, kMostPhase_deg = 97.0;
constexpr double kMoonSolidAngle = 6.4177e-5;  // sr, at 384 400 km

double log_reflectance(const Band& band, double phase_deg) {
    const double g = phase_deg * (std::numbers::pi / 180.0);
    return band.a[0] + g * (band.a[1] + g * (band.a[2] + g * band.a[3])) +
           band.d[0] * std::exp(-phase_deg / kP_deg[0]) +
           band.d[1] * std::exp(-phase_deg / kP_deg[1]) +
           band.d[2] * std::cos((phase_deg - kP_deg[2]) / kP_deg[3]);
}

/// The bands were calibrated one by one, and neighbours differ by up to 9 %: a parabola through
/// them all.
class MoonReflectance {
public:
    explicit MoonReflectance(double phase_deg) {
        const std::size_t rows = kBands.size();
        std::vector<double> columns(3 * rows), values(rows);
        for (std::size_t i = 0; i < rows; ++i) {
            const double x = coordinate(kBands[i].nm);
            columns[i] = 1.0, columns[rows + i] = x, columns[2 * rows + i] = x * x;
            values[i] = log_reflectance(kBands[i], phase_deg);
        }
        log_parabola_ = least_squares(columns, values);
    }
    double operator()(double nm) const {
        const double x = coordinate(nm);
        return std::exp(log_parabola_[0] + x * (log_parabola_[1] + x * log_parabola_[2]));
    }

private:
    static double coordinate(double nm) { return (nm - 600.0) / 250.0; }
    std::vector<double> log_parabola_;
};

class Moonlight final : public Lanewise<Moonlight> {
public:
    explicit Moonlight(double phase_deg) : sun_(make_sunlight_above()), reflectance_(phase_deg) {
        for (double nm = kLambdaMin_nm; nm <= kLambdaMax_nm; nm += 1.0)
            max_value_ = std::max(max_value_, value_at(nm));
    }
    double value_at(double nm) const {
        return kMoonSolidAngle / std::numbers::pi * reflectance_(nm) * (*sun_)(nm * unit::nm);
    }
    double max_value() const override { return max_value_; }

private:
    SpectrumPtr sun_;
    MoonReflectance reflectance_;
    double max_value_ = 0.0;
};

}  // namespace

SpectrumPtr make_sunlight_above(double distance_au) {
    const SpectrumPtr shape = find_illuminant("sun-am0");
    return make_scaled(shape, kIrradianceAtRow / ((*shape)(kRow)*distance_au * distance_au));
}

SpectrumPtr make_moonlight_above(Angle phase) {
    const double phase_deg = phase.to(unit::deg);
    if (!(phase_deg >= 0.0 && phase_deg <= kMostPhase_deg))
        throw InputError(fmt::format(
            "the moon's phase {:.6g}°; expected 0° (full) to {}° (a little less than half)",
            phase_deg, kMostPhase_deg));
    return std::make_shared<Moonlight>(std::max(phase_deg, kLeastPhase_deg));
}

}  // namespace dewbow
