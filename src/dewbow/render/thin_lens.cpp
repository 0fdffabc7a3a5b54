// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/thin_lens.h"

#include <array>

#include "dewbow/spectrum/wavelengths.h"

namespace dewbow {

namespace {

double index_in_air(const Dispersion& glass, Wavelength lambda) {
    return (glass(lambda) / (*air())(lambda)).value;
}

}  // namespace

DiscPoint sample_polygon(int corners, double u0, double u1) {
    const int wedge = std::min(int(u0 * corners), corners - 1);
    const Barycentric at = sample_uniform_triangle(u0 * corners - wedge, u1);
    const auto angle = [&](int corner) {
        return std::numbers::pi * (0.5 + 2.0 * corner / corners);
    };
    return {at.b * std::cos(angle(wedge)) + at.c * std::cos(angle(wedge + 1)),
            at.b * std::sin(angle(wedge)) + at.c * std::sin(angle(wedge + 1))};
}

ThinLensOptics::ThinLensOptics(const ThinLens& lens)
    : aperture_radius_(lens.aperture_radius.to(unit::m)),
      blades_(lens.blades),
      vergence_(1.0 / lens.focus_distance.to(unit::m)) {
    if (!lens.glass || lens.glass->index->is_constant()) return;
    glass_ = lens.glass->index;
    n_d_ = index_in_air(*glass_, kLined);
    slope_ = 1.0 / (lens.glass->focal_length.to(unit::m) * (n_d_ - 1.0));
}

DiscPoint ThinLensOptics::sample(double u0, double u1) const {
    const DiscPoint p = blades_ ? sample_polygon(blades_, u0, u1) : sample_concentric_disc(u0, u1);
    return {aperture_radius_ * p.x, aperture_radius_ * p.y};
}

void ThinLensOptics::vergences(std::span<const double> lambda_nm,
                               std::span<double> vergence_per_m) const {
    std::array<double, kMaxLanes> glass, around;
    const std::size_t count = lambda_nm.size();
    if (glass_) {
        glass_->eval_lanes(lambda_nm, std::span(glass).first(count));
        air()->eval_lanes(lambda_nm, std::span(around).first(count));
    }
    for (std::size_t k = 0; k < count; ++k)
        vergence_per_m[k] = glass_ ? vergence_ + slope_ * (glass[k] / around[k] - n_d_) : vergence_;
}

}  // namespace dewbow
