// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/paper_fog_light.h"

namespace dewbow {

PaperFogLight::PaperFogLight(const Scene& scene)
    : fog_(*scene.paper_rainbow, first_sun(scene)->direction),
      white_(scene.paper_rainbow->luminance.value_or(scene.film.white_luminance) /
             (kLuminousEfficacy * cie_y_integral())) {}

bool PaperFogLight::on_ray(Vec3 direction, double distance, std::array<double, 2> u,
                           const LaneSet& lanes, RgbReflectanceLanes& shares,
                           RgbLightLanes& colours, FogVeil& veil) const {
    const auto share = fog_.on_ray({direction}, distance * unit::m, u);
    if (!share) return false;
    shares.eval(share->replaced, lanes, veil.replaced);
    colours.eval(share->colour, lanes, veil.light);
    for (int k = 0; k < lanes.count; ++k) veil.light[k] *= veil.replaced[k] * white_;
    return true;
}

}  // namespace dewbow
