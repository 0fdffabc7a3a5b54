// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/mirrored_way.h"

namespace dewbow {

LineOnPlane::LineOnPlane(double height_m, Point<World> origin, Dir<World> direction,
                         Dir<World> towards)
    : still_direction_{{1, 0, 0}} {
    const double drop = -towards.v.y;
    origin_ = along(origin, towards, (origin.v.y - height_m) / drop);
    const Vec3 velocity = direction.v + towards.v * (direction.v.y / drop);
    speed_ = length({velocity.x, 0.0, velocity.z});
    direction_ =
        speed_ < kStill ? still_direction_ : Dir<World>{Vec3{velocity.x, 0.0, velocity.z} / speed_};
}

}  // namespace dewbow
