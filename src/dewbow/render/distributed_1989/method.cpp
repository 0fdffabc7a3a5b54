// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/distributed_1989/method.h"

#include <fmt/format.h>

#include <cmath>

#include "dewbow/base/error.h"
#include "dewbow/render/albedo.h"
#include "dewbow/spectrum/cie.h"
#include "dewbow/spectrum/illuminant.h"

namespace dewbow::distributed_1989 {

namespace {

/// Ratios of indices that differ by less part colours by less than 2e-5 rad: a hundredth of a pixel
/// in a picture of 500 pixels and 45°. Air against a vacuum does, 1.1e-5.
constexpr double kLeastDispersion = 2e-5;

/// Steps of the integral over a band, 0.05 nm each.
constexpr int kStepsPerBand = 100;

void refuse_spectral_bins(const Scene& scene) {
    if (scene.film.spectral_bins == 0) return;
    throw InputError("distributed_1989 knows colours and no spectra: it cannot fill the film's " +
                         std::to_string(scene.film.spectral_bins) + " spectral bins",
                     "--estimator path can; or ask for 0 bins");
}

/// 1989 had no medium that scatters; its own rainbow is fog.
void refuse_rain(const Scene& scene) {
    if (scene.rains.empty()) return;
    const std::string& name = scene.rains.front().name;
    throw InputError(fmt::format("distributed_1989 has no light from points in space, and so no "
                                 "rain: it cannot render {}",
                                 name.empty() ? "rain 1" : "the rain \"" + name + "\""),
                     "--estimator path can; the paper's own rainbow is [paper_rainbow]");
}

/// `scene`, if the method can do what it asks for.
const Scene& feasible(const Scene& scene) {
    refuse_spectral_bins(scene);
    refuse_rain(scene);
    return scene;
}

}  // namespace

Method::Method(const Scene& scene)
    : sampling_(make_spectral_model(scene.render.distributed_1989.model),
                scene.render.distributed_1989.sampling),
      told_(scene_of_1989(feasible(scene), sampling_.model())),
      prepared_(told_),
      white_radiance_(scene.film.white_luminance / (kLuminousEfficacy * cie_y_integral())),
      white_(make_scaled(find_illuminant("D65"), white_radiance_)) {
    prepared_.albedo = albedo_of_materials(scene);
    if (carries_rgb())
        make_channels();
    else
        make_spectral_bands();
    const std::array<double, 3> probe_nm{kLambdaMin_nm, kNominal_nm, kLambdaMax_nm};
    for (int id = 0; id < prepared_.media.size(); ++id)
        prepared_.media.medium(id).index->eval_lanes(probe_nm, index_.emplace_back());
}

void Method::make_channels() {
    light_basis_ = light_basis_in_channels(sampling_.model());
    reflectance_basis_ = reflectance_basis_in_channels(sampling_.model());
    band_nm_.assign(kChannel_nm.begin(), kChannel_nm.end());
    for (std::size_t c = 0; c < 3; ++c) {
        band_white_.emplace_back().v[c] = 1.0;
        band_colour_.push_back(band_white_[c] * (1.0 / white_radiance_));
    }
}

/// Radiance is taken to be linear from one band's wavelength to the next's: its colour is then
/// Σ L_k ∫ φ_k(λ) c(λ) dλ, with φ_k the tent over band k and c(λ) the colour of radiance 1 at λ.
void Method::make_spectral_bands() {
    light_basis_ = light_basis();
    reflectance_basis_ = dewbow::reflectance_basis();
    band_colour_.resize(kMostBands);
    const SpectralModel& model = sampling_.model();
    constexpr double kStep_nm = kBandStep_nm / kStepsPerBand;
    for (int i = 0; i < (kMostBands - 1) * kStepsPerBand; ++i) {
        const double place = (i + 0.5) / kStepsPerBand;  // in bands
        const Wavelength lambda = (kLambdaMin_nm + place * kBandStep_nm) * unit::nm;
        const double f = model.coordinate(lambda);
        const MonitorRgb colour =
            model.density(f) * (kStep_nm / (model.nm_per_f(f) * (*white_)(lambda)));
        const auto k = std::size_t(place);
        const double share = place - double(k);
        band_colour_[k] = band_colour_[k] + colour * (1.0 - share);
        band_colour_[k + 1] = band_colour_[k + 1] + colour * share;
    }
    MonitorRgb sum;
    for (int k = 0; k < kMostBands; ++k) {
        band_nm_.push_back(kLambdaMin_nm + k * kBandStep_nm);
        const double white = (*white_)(band_nm_.back() * unit::nm);
        band_white_.push_back(band_colour_[std::size_t(k)] * white);
        sum = sum + band_white_.back();
    }
    for (std::size_t k = 0; k < band_colour_.size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            band_colour_[k][c] /= sum[c];
            band_white_[k][c] /= sum[c];
        }
    }
}

Bands Method::make_white_bands() const {
    return {prepared_.media, {light_basis_, reflectance_basis_}, band_nm_, band_colour_};
}

Bands Method::make_sample_bands() const {
    if (carries_rgb()) return make_white_bands();
    constexpr std::array<double, 1> kAny_nm{kNominal_nm};
    constexpr std::array<MonitorRgb, 1> kAny{};
    return {prepared_.media, {light_basis_, reflectance_basis_}, kAny_nm, kAny};
}

void Method::set_sample(const SpectralSample& sample, Bands& bands) const {
    if (carries_rgb()) {
        for (std::size_t c = 0; c < 3; ++c)
            bands.colour(int(c))[c] = sample.rgb[c] * band_colour_[c][c];
        return;
    }
    const double lambda_nm = colour_nm(sample);
    bands.set_wavelength(lambda_nm);
    bands.colour(0) = sample.rgb * (1.0 / (*white_)(lambda_nm * unit::nm));
}

BandValues Method::for_sample(const BandValues& beta, const SpectralSample& sample) const {
    if (carries_rgb()) return beta;
    const double place =
        std::clamp((colour_nm(sample) - kLambdaMin_nm) / kBandStep_nm, 0.0, kMostBands - 1.0);
    const int k = std::min(int(place), kMostBands - 2);
    const double share = place - k;
    return {1, beta[k] * (1.0 - share) + beta[k + 1] * share};
}

MonitorRgb Method::white_through(const BandValues& beta) const {
    MonitorRgb sum;
    for (int k = 0; k < beta.count(); ++k) sum = sum + band_white_[std::size_t(k)] * beta[k];
    return sum;
}

bool Method::disperses(const Boundary& boundary) const {
    const auto& before = index_[std::size_t(boundary.before.interior())];
    const auto& after = index_[std::size_t(boundary.after.interior())];
    const double middle = after[1] / before[1];
    for (const std::size_t end : {0, 2})
        if (std::abs(after[end] / before[end] - middle) > kLeastDispersion) return true;
    return false;
}

}  // namespace dewbow::distributed_1989
