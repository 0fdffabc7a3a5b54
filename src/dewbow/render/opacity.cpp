// SPDX-License-Identifier: Apache-2.0
#include "dewbow/render/opacity.h"

#include <bit>

#include "dewbow/base/random.h"

namespace dewbow {

namespace {

std::uint64_t hash_of(const Meeting& meeting) {
    const Vec3 &o = meeting.origin, &d = meeting.direction;
    std::uint64_t hash = std::uint64_t(meeting.shape) << 1 | std::uint64_t(meeting.inward);
    hash = hash_combine(hash, std::uint64_t(meeting.primitive));
    for (const double x : {o.x, o.y, o.z, d.x, d.y, d.z})
        hash = hash_combine(hash, std::bit_cast<std::uint64_t>(x));
    return hash;
}

}  // namespace

bool is_there(double opacity, const Meeting& meeting) {
    if (opacity >= 1.0) return true;
    if (!(opacity > 0.0)) return false;
    return double(hash_of(meeting) >> 11) * 0x1p-53 < opacity;
}

}  // namespace dewbow
