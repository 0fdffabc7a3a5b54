// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/night.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "dewbow/math/interpolation.h"
#include "dewbow/sky/sunlight.h"
#include "dewbow/spectrum/cie.h"

namespace dewbow {

namespace {

/// Energy of a photon times its wavelength, J nm: h c.                         [CODATA 2018]
constexpr double kPlanckLight_J_nm = 6.62607015e-34 * 299792458.0 * 1e9;

/// W m⁻² sr⁻¹ of a rayleigh at a wavelength.
double radiance_of_rayleigh(double lambda_nm) {
    return 1e10 / (4.0 * std::numbers::pi) * kPlanckLight_J_nm / lambda_nm;
}

/// Airglow straight overhead, W m⁻² sr⁻¹ nm⁻¹.
class Airglow {
public:
    Airglow() {
        std::vector<Line> lines;
        for (const auto& [lambda_nm, rayleighs] : kLines)
            lines.push_back({lambda_nm * unit::nm, rayleighs * radiance_of_rayleigh(lambda_nm)});
        lines_ = make_lines(lines, kLineWidth);
    }
    double operator()(double lambda_nm) const {
        constexpr double kContinuum = 3.0;  // R nm⁻¹
        return kContinuum * radiance_of_rayleigh(lambda_nm) + (*lines_)(lambda_nm * unit::nm);
    }

private:
    /// Wide enough for a packet's few wavelengths to find them; the eye sees the same colour.
    static constexpr Wavelength kLineWidth = 20.0 * unit::nm;
    struct Glow {
        double lambda_nm, rayleighs;
    };
    static constexpr std::array<Glow, 4> kLines = {
        {{557.7, 250.0}, {589.3, 50.0}, {630.0, 100.0}, {636.4, 33.0}}};
    SpectrumPtr lines_;
};

/// A magnitude-10 star a square degree, cd m⁻²: 27.78 magnitudes a square second, where magnitude 0
/// is 1.08e5 cd m⁻².                                        [Garstang 1989; Leinert et al. 1998]
const double kTenthMagnitude = 1.08e5 * std::pow(10.0, -0.4 * 27.78);
constexpr double kStars = 75.0;  // stars of magnitude 10: 60 zodiacal light, 15 starlight

/// By how much airglow grows from overhead to where the sine of the altitude is `sine`.
double growth(double sine) { return 1.0 / std::sqrt(0.04 + 0.96 * sine * sine); }

class MoonlessDome final : public SkyDome {
public:
    explicit MoonlessDome(const ClearSky& air)
        : overhead_(make_direct_transmittance(90.0 * unit::deg, air)),
          ground_albedo_(air.ground_albedo) {
        const SpectrumPtr sun = make_sunlight_above();
        stars_ = make_scaled(
            sun, kStars * kTenthMagnitude / (kLuminousEfficacy * xyz_from_spectrum(*sun)[1]));
        for (int i = 0; i < kHeights; ++i) luminance_[std::size_t(i)] = luminance_of_sky(i);
        ground_luminance_ = luminance_of([&](auto nm, auto out) { ground_lanes(nm, out); });
    }

    void radiance_lanes(Dir<World> direction, std::span<const double> lambda_nm,
                        std::span<double> out) const override {
        if (direction.v.y < 0.0) return ground_lanes(lambda_nm, out);
        sky_lanes(direction.v.y, lambda_nm, out);
    }
    double luminance(Dir<World> direction) const override {
        if (direction.v.y < 0.0) return ground_luminance_;
        return interpolate_linear_regular(0.0, kStep, luminance_, direction.v.y);
    }

private:
    static constexpr int kHeights = 65;
    static constexpr double kStep = 1.0 / (kHeights - 1);  // in sin h

    void sky_lanes(double sine, std::span<const double> lambda_nm, std::span<double> out) const {
        const double x = growth(sine);
        overhead_->eval_lanes(lambda_nm, out);
        for (std::size_t i = 0; i < out.size(); ++i) {
            const double light = (*stars_)(lambda_nm[i] * unit::nm) + x * airglow_(lambda_nm[i]);
            out[i] = light * std::pow(out[i], x - 1.0);
        }
    }
    /// Albedo times the mean of the sky over level ground: 2 ∫ L sin h d(sin h), at midpoints.
    void ground_lanes(std::span<const double> lambda_nm, std::span<double> out) const {
        constexpr int kParts = 16;
        std::vector<double> sky(out.size());
        std::fill(out.begin(), out.end(), 0.0);
        for (int i = 0; i < kParts; ++i) {
            const double sine = (i + 0.5) / kParts;
            sky_lanes(sine, lambda_nm, sky);
            for (std::size_t k = 0; k < out.size(); ++k)
                out[k] += ground_albedo_ * 2.0 * sine / kParts * sky[k];
        }
    }
    /// cd m⁻² of what `eval_lanes` writes: every nanometre.
    template <class EvalLanes>
    static double luminance_of(const EvalLanes& eval_lanes) {
        constexpr std::size_t kCount = std::size_t(kLambdaMax_nm - kLambdaMin_nm);
        std::vector<double> lambda_nm(kCount), radiance(kCount);
        for (std::size_t i = 0; i < kCount; ++i) lambda_nm[i] = kLambdaMin_nm + double(i) + 0.5;
        eval_lanes(std::span<const double>(lambda_nm), std::span<double>(radiance));
        double sum = 0.0;
        for (std::size_t i = 0; i < kCount; ++i) sum += radiance[i] * cie_xyz_bar(lambda_nm[i])[1];
        return kLuminousEfficacy * sum;
    }
    double luminance_of_sky(int height) const {
        return luminance_of([&](auto nm, auto out) { sky_lanes(kStep * height, nm, out); });
    }

    SpectrumPtr overhead_;  ///< share of light that comes straight down through the air
    SpectrumPtr stars_;     ///< W m⁻² sr⁻¹ nm⁻¹, overhead
    Airglow airglow_;
    double ground_albedo_;
    std::array<double, kHeights> luminance_;
    double ground_luminance_ = 0.0;
};

}  // namespace

SkyDomePtr make_moonless_dome(const ClearSky& air) { return std::make_shared<MoonlessDome>(air); }

}  // namespace dewbow
