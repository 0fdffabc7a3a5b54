// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/phase_lookup.h"

namespace dewbow {

PhaseLookup::PhaseLookup(std::shared_ptr<const AngleIndex> angles,
                         std::span<const Intensities> per_sr)
    : angles_(std::move(angles)) {
    values_.reserve(per_sr.size());
    for (const Intensities& value : per_sr)
        values_.push_back({float(value.perpendicular), float(value.parallel)});
}

template <class Put>
void PhaseLookup::for_each_lane(double cosine, std::span<const double> lambda_nm, Put put) const {
    const auto [cell, angle_share] = angles_->find(cosine);
    const Pair* low = values_.data() + cell * VisibleGrid::kCount;
    const Pair* high = low + VisibleGrid::kCount;
    for (std::size_t k = 0; k < lambda_nm.size(); ++k) {
        const auto [j, share] = VisibleGrid::find(lambda_nm[k]);
        const double w11 = angle_share * share, w10 = angle_share - w11, w01 = share - w11,
                     w00 = 1.0 - share - w10;
        put(k, Intensities{w00 * low[j].perpendicular + w01 * low[j + 1].perpendicular +
                               w10 * high[j].perpendicular + w11 * high[j + 1].perpendicular,
                           w00 * low[j].parallel + w01 * low[j + 1].parallel +
                               w10 * high[j].parallel + w11 * high[j + 1].parallel});
    }
}

void PhaseLookup::eval_lanes(double cosine, std::span<const double> lambda_nm,
                             std::span<Intensities> out) const {
    for_each_lane(cosine, lambda_nm, [&](std::size_t k, const Intensities& at) { out[k] = at; });
}

void PhaseLookup::eval_lanes(double cosine, std::span<const double> lambda_nm,
                             std::span<double> out) const {
    for_each_lane(cosine, lambda_nm,
                  [&](std::size_t k, const Intensities& at) { out[k] = at.unpolarised(); });
}

}  // namespace dewbow
